"""A run in a thread of its own, so that the thread that asked for it hears Ctrl-C meanwhile."""

import threading
from queue import SimpleQueue
from typing import Any, Callable, Optional, TypeVar

from ._header import Progress

T = TypeVar("T")
Tell = Callable[[str, float], Any]

_here = threading.local()  # .tell: whom the run of this thread tells how far it is


@Progress
def tell(_user: Any, what: bytes, part: float) -> int:
    """The library's callback for all runs: it calls on the thread on which the run is. Not 0: the run is to end."""
    told = getattr(_here, "tell", None)
    return told(what.decode(errors="replace"), part) if told is not None else 0


def wait_for(work: Callable[[], T], cancel: Callable[[], None], progress: Optional[Tell] = None) -> T:
    """What work() returns or raises, on another thread; progress(what, part) is called on this one.

    What progress() raises ends the run, and is raised when it has ended; so does Ctrl-C, by cancel().
    """
    news: SimpleQueue = SimpleQueue()  # (what, part); None at the end
    goes_on: SimpleQueue = SimpleQueue()  # an answer to each
    outcome: list = []
    raised: list = []
    permit = threading.Lock()  # to begin: the worker takes it, or whoever was interrupted before
    ended = threading.Event()

    def on_worker() -> None:
        if not permit.acquire(blocking=False):
            return
        if progress is not None:
            _here.tell = ask
        try:
            outcome.append(work())
        except BaseException as problem:
            raised.append(problem)
        finally:
            ended.set()
            news.put(None)

    def ask(what: str, part: float) -> int:
        news.put((what, part))
        return 0 if goes_on.get() else 1

    def hear(what: str, part: float) -> None:
        if not raised:
            try:
                progress(what, part)  # type: ignore[misc]
            except Exception as problem:
                raised.append(problem)
        goes_on.put(not raised)

    worker = threading.Thread(target=on_worker, name="foredraw")
    try:
        worker.start()
        while (one := news.get()) is not None:
            hear(*one)
    except BaseException:
        if not permit.acquire(blocking=False):
            while not ended.wait(0.02):  # a cancel that comes before the library has begun is none
                cancel()
                goes_on.put(False)
            worker.join()
        raise
    worker.join()
    if raised:
        raise raised[0]
    return outcome[0]
