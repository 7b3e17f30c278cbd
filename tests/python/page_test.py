"""What docs/guides/python.md and the package's README show can be run."""

import contextlib
import io
import os
import re
import shutil
import tempfile
import unittest

from meshes import ROOT, SPOT


class Page(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        shutil.copy(SPOT, "house.glb")

    def run_page(self, page, names):
        """Its pieces one after the other, and what they print."""
        text = (ROOT / page).read_text(encoding="utf-8")
        pieces = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            for piece in pieces:
                exec(compile(piece, page, "exec"), names)
        return len(pieces), said.getvalue()

    def test_of_the_documentation(self):
        names = {}
        count, said = self.run_page("docs/guides/python.md", names)
        self.assertEqual(count, 6)
        self.assertIn("vertex-cache acmr ", said)
        before, after = map(float, said.splitlines()[-4].split())
        self.assertLess(after, before)
        self.assertGreater(float(said.splitlines()[-3].split()[1]), 0)  # the error of a simplified mesh
        self.assertGreaterEqual(float(said.splitlines()[-2]), 1)  # its overdraw
        self.assertLess(names["acmr"], 1)
        self.assertFalse(names["view"].flags.writeable)
        self.assertEqual(names["best"]["pipeline"], said.splitlines()[-1].rsplit(" ", 1)[0])

    def test_of_the_package(self):
        self.assertEqual(self.run_page("hosts/python/README.md", {"indices": [0, 1, 2]})[0], 1)
        self.assertTrue(os.path.exists("cheaper.glb"))
