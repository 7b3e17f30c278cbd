"""Serves a module written in Python, which the program loads as `foredraw --module FILE.py`: it starts this, as
``python3 -m foredraw.worker FILE``.

A module is a file that decorates its techniques with :func:`foredraw.orderer` and the like, whose names begin with the
vendor's: "acme-radial". Its ``__version__`` stands in reports.
"""

import runpy
import sys
from ctypes import POINTER, byref, pointer, sizeof

from . import _header as c
from ._library import library
from ._texts import text_for_c
from .techniques import Technique


def serve(path: str) -> int:
    """Answers the calls of the program that started this one."""
    names = runpy.run_path(path)
    techniques = list({id(one): one for one in names.values() if isinstance(one, Technique)}.values())
    if not techniques:
        sys.exit("it has no technique: none of its functions is decorated with @foredraw.orderer or the like")
    for one in techniques:
        if "-" not in one.name:
            sys.exit(f"'{one.name}' must begin with its vendor's name, such as 'acme-{one.name}'")
    plugins = (POINTER(c.Plugin) * len(techniques))(*(pointer(one._plugin) for one in techniques))
    vendor = techniques[0].name.partition("-")[0]
    version = str(names.get("__version__", "0"))
    module = c.Module(sizeof(c.Module), c.MODULE_MAJOR, c.MODULE_MINOR, len(techniques), text_for_c(vendor, "a name"),
                      text_for_c(version, "__version__"), plugins)
    return library().serve_module(byref(module))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("foredraw starts this where --module names a .py file: python3 -m foredraw.worker FILE")
    sys.exit(serve(sys.argv[1]))
