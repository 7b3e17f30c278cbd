"""What the package says of the C headers is what the headers say, and what a compiler makes of them."""

import ctypes
import os
import re
import subprocess
import unittest

from foredraw import _header
from meshes import ROOT

STRUCTS = {
    name: struct
    for name, struct in vars(_header).items()
    if isinstance(struct, type) and issubclass(struct, ctypes.Structure) and struct is not ctypes.Structure
}


def name_in_c(name):
    """VertexCacheFigures is foredraw_vertex_cache_figures."""
    return "foredraw" + re.sub("([A-Z])", lambda match: "_" + match[1].lower(), name)


class Header(unittest.TestCase):
    def test_layouts_and_values_are_the_compilers(self):
        lines = subprocess.run([os.environ["FOREDRAW_LAYOUTS"]], capture_output=True, text=True, check=True).stdout
        compilers = dict(line.split(maxsplit=1) for line in lines.splitlines())
        ours = {}
        for name, struct in STRUCTS.items():
            ours[name_in_c(name)] = str(ctypes.sizeof(struct))
            for member, _ in struct._fields_:
                ours[f"{name_in_c(name)}.{member}"] = "{0.offset} {0.size}".format(getattr(struct, member))
        for name, value in vars(_header).items():
            if isinstance(value, int):
                ours["FOREDRAW_" + name] = str(value)
        self.assertGreater(len(ours), 60)
        self.assertEqual(ours, compilers)

    def test_functions_are_the_headers(self):
        declared = {}
        for name in ["status", "functions", "simplification", "sprites", "instances", "plugin", "foredraw"]:
            text = (ROOT / f"framework/foredraw/c/{name}.h").read_text()
            text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
            for result, name, taken in re.findall(r"^([\w ]+\*?) ?foredraw_(\w+)\(([^)]*)\);", text, re.MULTILINE):
                declared[name] = (result.strip(), [] if taken == "void" else taken.split(","))
        self.assertEqual(set(_header.PROTOTYPES), set(declared))
        for name, (result, taken) in _header.PROTOTYPES.items():
            self.assertEqual(len(taken), len(declared[name][1]), name)
            for ours, theirs in zip(taken, declared[name][1]):
                self.assertEqual(is_pointer(ours), "*" in theirs, f"{name}: {theirs}")
                if not is_pointer(ours):
                    self.assertEqual(ours, BY_VALUE[theirs.split()[0]], f"{name}: {theirs}")
            if result is not None and "*" not in declared[name][0]:
                self.assertEqual(result, BY_VALUE[declared[name][0]], name)


BY_VALUE = {
    "int": ctypes.c_int,
    "uint32_t": ctypes.c_uint32,
    "uint64_t": ctypes.c_uint64,
    "double": ctypes.c_double,
}


def is_pointer(taken):
    return taken not in BY_VALUE.values()
