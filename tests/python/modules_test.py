"""Modules in a context: the same techniques, whoever runs them."""

import gc
import os
import tempfile
import unittest
from pathlib import Path

import foredraw as fd
from meshes import ROOT

SPOT = ROOT / "benchmarks/corpus/static/spot.glb"
RADIAL = ROOT / "hosts/module/examples/radial.py"


class Modules(unittest.TestCase):
    def setUp(self):
        if not os.environ.get("FOREDRAW_MODULE_WORKER"):
            self.skipTest("this build has no foredraw-module")
        self.context = fd.Context()

    def test_techniques_give_the_bytes_that_they_give_here(self):
        names = {}
        exec(compile(RADIAL.read_text(), str(RADIAL), "exec"), names)
        here = fd.Context()
        fd.add(names["radial"], context=here)
        self.context.load_module(RADIAL)
        scene, pipeline = fd.read(SPOT), "weld, acme-radial(height=.5), vertex-fetch"
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder) / "here.glb", Path(folder) / "apart.glb"]
            for path, context in zip(paths, [here, self.context]):
                done = fd.optimize(scene, pipeline, context=context)
                done.scene.write(path)
            self.assertEqual(paths[0].read_bytes(), paths[1].read_bytes())
        self.assertEqual(done.report["modules"][0]["version"], "1.0.0")

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(fd.Error, "none.so"):
            self.context.load_module("none.so")
        with self.assertRaisesRegex(fd.Error, "process of its own alone"):
            self.context.load_module(RADIAL, inside=True)

    def test_a_fork_leaves_workers_alone(self):
        self.context.load_module(RADIAL)
        scene = fd.read(SPOT)
        triangles = fd.optimize(scene, "acme-radial", context=self.context).scene.draws[0].indices.tolist()
        child = os.fork()
        if child == 0:
            del self.context  # the workers are not its own to end
            gc.collect()
            os._exit(0)
        os.waitpid(child, 0)
        again = fd.optimize(scene, "acme-radial", context=self.context).scene.draws[0].indices.tolist()
        self.assertEqual(triangles, again)


if __name__ == "__main__":
    unittest.main()
