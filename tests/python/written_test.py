"""Files and bytes that are written are those of the program, and so are errors."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import foredraw as fd
from meshes import PROGRAM, ROOT, SPOT

BENCH = ROOT / "benchmarks/corpus/scenes/kaykit_city/bench.gltf"
SPRITES = ROOT / "benchmarks/corpus/particles/atlas_playcanvas_numbers.json"


class Written(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def program(self, path, *arguments):
        return subprocess.run([PROGRAM, "optimize", str(path), "-o", "theirs.glb", "--with", "vertex-cache", *arguments],
                              cwd=self.folder, capture_output=True, text=True)

    def theirs(self, *arguments):
        ended = self.program(*arguments)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return (self.folder / "theirs.glb").read_bytes()

    def test_bytes_are_those_of_the_program_for_every_preset(self):
        presets = sorted((ROOT / "framework/presets").glob("*.toml"))
        self.assertGreater(len(presets), 5)
        for preset in presets:
            path = SPRITES if preset.stem == "sprites" else BENCH
            done = fd.optimize(fd.read(path), "@" + preset.stem)
            done.scene.write(self.folder / "ours.glb")
            with self.subTest(preset.stem):
                theirs = self.theirs(path, "-p", "@" + preset.stem)
                self.assertEqual((self.folder / "ours.glb").read_bytes() == theirs, True)

    def test_settings_are_keyword_arguments(self):
        scene = fd.optimize(fd.read(SPOT), "@small").scene
        self.assertEqual(scene.write_bytes() == self.theirs(SPOT, "-p", "@small"), True)
        for settings in [{"compression": "none"}, {"compression": "ext-meshopt", "corners": "keep"}]:
            options = [word for name, value in settings.items() for word in ("--" + name, value)]
            theirs = self.theirs(SPOT, "-p", "@small", *options)
            self.assertEqual(fd.write_bytes(scene, "x.glb", **settings) == theirs, True)
            scene.write(self.folder / "ours.glb", **settings)
            self.assertEqual((self.folder / "ours.glb").read_bytes() == theirs, True)

    def test_errors_are_those_of_the_program(self):
        scene = fd.read(SPOT)
        for settings, options in [({"compression": "zip"}, ["--compression", "zip"]),
                                  ({"zip": "1"}, ["--set", "output.zip=1"])]:
            with self.assertRaises(fd.Error) as raised:
                scene.write(self.folder / "ours.glb", **settings)
            for part in ["message", "hint"]:
                self.assertIn(raised.exception.diagnostics[0].get(part, ""), self.program(SPOT, *options).stderr)
        with self.assertRaises(fd.Error):
            scene.write_bytes("ours.gltf")
        self.assertEqual(list(self.folder.iterdir()), [])
