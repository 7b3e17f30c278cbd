"""Runs the tests of a module: run.py functions_test. The exit code 77 says that they are skipped."""

import importlib.util
import sys
import unittest

if __name__ == "__main__":
    if importlib.util.find_spec("numpy") is None:
        print(f"skipped: {sys.executable} has no numpy; packages/install test brings it")
        sys.exit(77)
    unittest.main(module=sys.argv.pop(1))
