"""Processes that end with the test, whatever becomes of either."""

import ctypes
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

SET_PDEATHSIG, SET_CHILD_SUBREAPER = 1, 36
_prctl = ctypes.CDLL(None, use_errno=True).prctl


def adopt_orphans():
    """What loses its parent below this process becomes its child, so that it is found. Ctrl-C and SIGTERM become
    exceptions, so that what stands in `finally` is done."""
    _prctl(SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended by SIGTERM"))


def begin(command, log, **more):
    """A daemon that stays in the foreground. It is killed where this process dies without a word."""
    with open(log, "ab") as out:
        return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=out,
                                preexec_fn=lambda: _prctl(SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0), **more)


def descendants():
    parents = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue  # it has ended
        if fields[0] != "Z":
            parents[int(stat.parent.name)] = int(fields[1])
    found = {os.getpid()}
    while True:
        more = {child for child, parent in parents.items() if parent in found} - found
        if not more:
            return found - {os.getpid()}
        found |= more


def end_all():
    """Everything below this process: asked at first, killed after two seconds."""
    for how, seconds in (signal.SIGTERM, 2), (signal.SIGKILL, 2):
        for process in descendants():
            try:
                os.kill(process, how)
            except ProcessLookupError:
                pass
        end = time.monotonic() + seconds
        while descendants() and time.monotonic() < end:
            time.sleep(0.05)
        while True:  # those that were adopted
            try:
                if os.waitpid(-1, os.WNOHANG)[0] == 0:
                    break
            except ChildProcessError:
                break


def run_tests(unittest):
    """Of the main module."""
    adopt_orphans()
    try:
        unittest.main(verbosity=2)
    finally:
        end_all()
