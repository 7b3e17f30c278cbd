"""The installed package finds the library of its installation."""

import os
import unittest
from pathlib import Path

os.environ.pop("FOREDRAW_LIBRARY", None)
import foredraw as fd
from foredraw._library import library


class Installed(unittest.TestCase):
    def test_library_is_that_of_the_installation(self):
        package = Path(fd.__file__).parent
        self.assertEqual(package.parent.name, "dist-packages")
        prefix = package.parents[3]
        self.assertIn(prefix, Path(library()._path).parents)
        self.assertEqual(fd.library_version(), fd.__version__)
        self.assertEqual(list(fd.tipsify([0, 1, 2])), [0])
