"""The add-on, in a stand-in for Blender: what is exported is made cheaper in its place, and whatever goes wrong is told."""

import os
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import bpy  # the stand-in beside this file

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "hosts/blender"))
import foredraw_export as addon  # noqa: E402

SPOT = ROOT / "benchmarks/corpus/static/spot.glb"
PROGRAM = os.environ["FOREDRAW_PROGRAM"]


class Export(unittest.TestCase):
    def setUp(self):
        addon.register()
        self.addCleanup(addon.unregister)
        bpy.begin(addon, PROGRAM)
        self.settings = bpy.context.scene.foredraw
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = Path(self.folder.name) / "spot näher.glb"
        shutil.copy(SPOT, self.file)

    def export(self):
        """As the exporter does when all is written."""
        addon.glTF2ExportUserExtension().post_export_hook({"gltf_filepath": str(self.file)})

    def test_files_become_cheaper_in_their_place(self):
        self.settings.preset = "cache-only"
        self.export()
        self.assertNotEqual(self.file.read_bytes(), SPOT.read_bytes())
        self.assertRegex(self.settings.report, r"vertices shaded a triangle: \d\.\d+ -> \d\.\d+ \(-\d")
        self.assertEqual(list(self.file.parent.iterdir()), [self.file])

    def test_pipelines_of_ones_own_are_taken(self):
        self.settings.preset, self.settings.pipeline = "text", "tipsify, vertex-fetch"
        self.export()
        tipsified = self.file.read_bytes()
        self.settings.pipeline = "forsyth, vertex-fetch"
        shutil.copy(SPOT, self.file)
        self.export()
        self.assertNotEqual(self.file.read_bytes(), tipsified)

    def test_what_is_wrong_is_told_and_the_file_stays(self):
        self.settings.preset, self.settings.pipeline = "text", "tipsfy"
        self.export()
        self.assertIn("as exported", self.settings.report)
        self.assertIn("tipsify", self.settings.report)
        self.assertEqual(self.file.read_bytes(), SPOT.read_bytes())
        bpy.begin(addon, "/nowhere/foredraw")
        self.export()
        self.assertIn("can not be run", bpy.context.scene.foredraw.report)
        bpy.begin(addon)
        path, os.environ["PATH"] = os.environ["PATH"], ""
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        self.export()
        self.assertIn("was not found", bpy.context.scene.foredraw.report)
        self.assertEqual(self.file.read_bytes(), SPOT.read_bytes())
        self.file.unlink()
        bpy.begin(addon, PROGRAM)
        self.export()
        self.assertIn("no file", bpy.context.scene.foredraw.report)

    def test_nothing_is_done_where_it_is_off(self):
        self.settings.enabled = False
        self.export()
        self.assertEqual(self.file.read_bytes(), SPOT.read_bytes())
        self.assertEqual(self.settings.report, "")

    def test_presets_are_those_of_the_program(self):
        presets = {path.stem for path in (ROOT / "framework/presets").glob("*.toml")}
        self.assertLessEqual({name for name, *_ in addon.PRESETS} - {"text"}, presets)

    def test_the_panel_has_preset_and_report(self):
        layout = bpy.Layout()
        self.settings.report = "one\ntwo"
        addon.draw_export(bpy.context, layout)
        self.assertEqual(layout.drawn, ["enabled", "preset", "one", "two"])
        self.settings.preset = "text"
        layout = bpy.Layout()
        addon.draw_export(bpy.context, layout)
        self.assertIn("pipeline", layout.drawn)
        closed = bpy.Layout(is_open=False)
        addon.draw_export(bpy.context, closed)
        self.assertEqual(closed.drawn, ["enabled"])


if __name__ == "__main__":
    unittest.main()
