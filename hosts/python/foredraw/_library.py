"""Finds libforedraw at the first call, and declares what is called of it."""

import ctypes
import os
from functools import lru_cache
from pathlib import Path
from typing import Any, Callable, List, Union

from ._header import PROTOTYPES
from .errors import Error

_NAME = "libforedraw.so.1"


class Library:
    """The functions of the C library by their names without "foredraw_", declared when each is first asked for: a
    library with fewer functions than the headers have is of use for the others."""

    def __init__(self, path: Union[str, Path]) -> None:
        self._path = str(path)
        self._shared = ctypes.CDLL(self._path)

    def __getattr__(self, name: str) -> Callable[..., Any]:
        if name not in PROTOTYPES:
            raise AttributeError(name)
        try:
            function = getattr(self._shared, "foredraw_" + name)
        except AttributeError:
            raise Error(
                f"{self._path} has no function foredraw_{name}: it is not of the version of this package, "
                "or was built without it; install both together"
            ) from None
        function.restype, function.argtypes = PROTOTYPES[name]
        setattr(self, name, function)
        return function


def _places() -> List[Path]:
    """Where the library may lie by where this package lies: beside it, or in the same installation."""
    package = Path(__file__).resolve().parent
    lib = package.parents[2]  # of lib/python3/dist-packages/foredraw
    return [package, lib, *sorted(lib.glob("*-linux-*")), lib.with_name("lib64")]


@lru_cache(maxsize=1)
def library() -> Library:
    """The library that the environment names, the one that lies by the package, or the system's."""
    named = os.environ.get("FOREDRAW_LIBRARY")
    if named:
        try:
            return Library(named)
        except OSError as problem:
            raise Error(f"FOREDRAW_LIBRARY names '{named}', which cannot be loaded: {problem}") from None
    places = _places()
    found = [place / _NAME for place in places if (place / _NAME).exists()]
    try:
        return Library(found[0] if found else _NAME)
    except OSError as problem:
        looked = ", ".join(map(str, places))
        raise Error(
            f"{_NAME} cannot be loaded: {problem}. It was looked for in {looked}, and where the system has its "
            "libraries. Name it by the environment variable FOREDRAW_LIBRARY"
        ) from None


def library_version() -> str:
    """The version of the C library."""
    number = library().version()
    return f"{number // 10000}.{number // 100 % 100}.{number % 100}"
