"""What runs need: plugins and threads of the library."""

import os
import weakref
from ctypes import byref, sizeof
from functools import lru_cache
from typing import Any, Callable, List, Optional, TypeVar, Union

from ._arrays import count
from ._header import Settings
from ._library import library
from ._texts import Told, check, path_for_c
from ._waiting import Tell, tell, wait_for

T = TypeVar("T")


class Context:
    """Plugins and threads. Functions use one of their own where none is given.

    Several threads may run pipelines in a context at once. Ctrl-C and :meth:`cancel` end all that runs in it.

    Parameters
    ----------
    threads : int
        At most so many; 0: one for each processor. Results do not depend on it.
    """

    def __init__(self, threads: int = 0) -> None:
        settings = Settings(size=sizeof(Settings), threads=count(threads, "threads"), progress=tell)
        self._pointer = library().context_new(byref(settings))
        if not self._pointer:
            raise MemoryError("memory ran out")
        weakref.finalize(self, library().context_free, self._pointer)
        self._techniques: List[Any] = []  # that were added, which live as long

    def load_module(self, path: Union[str, "os.PathLike[str]"], *, inside: bool = False) -> None:
        """Add the techniques of a module's file, or of all in a folder. They run in processes of their own, or `inside`
        this one, which then trusts them. Raises :class:`Error` where something is wrong with one; the others are added
        all the same. Do it before other threads use the context."""
        said = Told()
        check(library().load_module(self._pointer, path_for_c(path), inside, said.out), said.take())

    def cancel(self) -> None:
        """End whatever runs in the context at this time: it raises :class:`Cancelled`. From any thread."""
        library().cancel(self._pointer)

    def _run(self, work: Callable[[], T], progress: Optional[Tell]) -> T:
        return wait_for(work, self.cancel, progress)

    def __reduce__(self) -> Any:
        raise TypeError("a context stays in its process; make one in each process")


@lru_cache(maxsize=1)
def _of_process(_process: int) -> Context:
    return Context()


def default_context() -> Context:
    """The one that functions use where none is given, made at the first call; a forked process has its own."""
    return _of_process(os.getpid())
