"""The package is one of any Python from 3.9 on, does nothing when it is imported, and says where its library is not."""

import ast
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import foredraw as fd
from meshes import ROOT

FOLDER = ROOT / "hosts/python"
SOURCES = sorted((FOLDER / "foredraw").glob("*.py"))


def run(code, **environment):
    """What another python3 prints."""
    whole = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **environment}
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=whole)
    return ended.stdout + ended.stderr


class Package(unittest.TestCase):
    def test_has_the_version_of_the_library(self):
        self.assertEqual(fd.__version__, fd.library_version())

    def test_is_of_python_3_9(self):
        self.assertGreater(len(SOURCES), 8)
        for source in SOURCES:
            ast.parse(source.read_text(encoding="utf-8"), feature_version=(3, 9))

    def test_wants_numpy_alone(self):
        imported = set()
        for source in SOURCES:
            for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Import):
                    imported |= {name.name.split(".")[0] for name in node.names}
                elif isinstance(node, ast.ImportFrom) and node.level == 0:
                    imported.add(node.module.split(".")[0])
        self.assertEqual(imported - set(sys.stdlib_module_names), {"numpy"})

    def test_shows_what_it_says(self):
        for name in fd.__all__:
            self.assertTrue(getattr(fd, name).__doc__, name)

    def test_does_nothing_when_it_is_imported(self):
        code = "import foredraw, threading; print(threading.active_count(), 'imported')"
        said = run(code, FOREDRAW_LIBRARY="/none.so")
        self.assertEqual(said, "1 imported\n")

    def test_says_where_the_library_is_not(self):
        call = "import foredraw; foredraw.tipsify([0, 1, 2])"
        said = run(call, FOREDRAW_LIBRARY="/none.so")
        self.assertIn("foredraw.errors.Error: FOREDRAW_LIBRARY names '/none.so', which cannot be loaded", said)
        said = run(call, FOREDRAW_LIBRARY="")
        self.assertIn("Name it by the environment variable FOREDRAW_LIBRARY", said)

    def test_finds_the_library_in_its_installation(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix = Path(folder).resolve()
            packages = prefix / "lib/python3/dist-packages"
            packages.mkdir(parents=True)
            shutil.copytree(FOLDER / "foredraw", packages / "foredraw", ignore=shutil.ignore_patterns("__pycache__"))
            places = ["lib64", "lib/x86_64-linux-gnu", "lib", "lib/python3/dist-packages/foredraw"]
            for place in places:  # each goes before the last
                library = prefix / place / "libforedraw.so.1"
                library.parent.mkdir(exist_ok=True)
                library.symlink_to(os.environ["FOREDRAW_LIBRARY"])
                said = run("from foredraw._library import library; print(library()._path)", FOREDRAW_LIBRARY="",
                           PYTHONPATH=str(packages))
                self.assertEqual(said, f"{library}\n")

    def test_says_what_a_library_lacks(self):
        said = run("import foredraw; foredraw.tipsify([0, 1, 2])", FOREDRAW_LIBRARY="libc.so.6")
        self.assertIn("libc.so.6 has no function foredraw_tipsify", said)

    @unittest.skipUnless(
        all(importlib.util.find_spec(name) for name in ["pip", "setuptools", "wheel"]), "no pip, setuptools or wheel"
    )
    def test_makes_one_wheel_for_all(self):
        with tempfile.TemporaryDirectory() as folder:
            sources = Path(folder) / "python"
            for path in [*SOURCES, FOLDER / "pyproject.toml", FOLDER / "README.md", FOLDER / "foredraw/py.typed"]:
                copy = sources / path.relative_to(FOLDER)
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes(path.read_bytes())
            options = ["--no-build-isolation", "--no-deps", "--no-index", "-w", folder]
            subprocess.run([sys.executable, "-m", "pip", "wheel", *options, sources], check=True, capture_output=True)
            (wheel,) = Path(folder).glob("*.whl")
            self.assertEqual(wheel.name, f"foredraw-{fd.__version__}-py3-none-any.whl")
            with zipfile.ZipFile(wheel) as content:
                names = {name for name in content.namelist() if name.startswith("foredraw/")}
        self.assertEqual(names, {f"foredraw/{source.name}" for source in SOURCES} | {"foredraw/py.typed"})
