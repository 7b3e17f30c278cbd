"""Foredraw in Blender: every glTF that is exported is made cheaper to draw, by the program foredraw.

Install this one file: Edit > Preferences > Add-ons > Install from Disk. Needs Blender 4.4 or newer, whose exporter calls
`post_export_hook`, and the program foredraw. In the export dialog, the panel "Foredraw" has the preset, and afterwards what
was saved.
"""

import json
import os
import shutil
import subprocess
import tempfile

import bpy

bl_info = {
    "name": "Foredraw",
    "author": "Foredraw",
    "version": (0, 1, 0),
    "blender": (4, 4, 0),
    "location": "File > Export > glTF 2.0",
    "description": "Makes exported glTF cheaper to draw: fewer vertices shaded, less overdraw, proved to look the same",
    "category": "Import-Export",
}

PRESETS = [
    ("default", "Default", "Fewer vertices shaded and less overdraw; back sides that are never seen are left out"),
    ("cache-only", "Vertex cache only", "Fewer vertices shaded, nothing else; fast"),
    ("simplify", "Simplify", "Half of the triangles, at a proved error"),
    ("text", "Pipeline", "A pipeline of your own: stages on a line"),
]


class ForedrawPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    program: bpy.props.StringProperty(
        name="Program", description="Where foredraw is; empty: wherever the system finds programs", subtype="FILE_PATH"
    )

    def draw(self, _context):
        self.layout.prop(self, "program")


class ForedrawProperties(bpy.types.PropertyGroup):
    enabled: bpy.props.BoolProperty(name="Foredraw", description="Make the exported file cheaper to draw", default=True)
    preset: bpy.props.EnumProperty(name="Preset", description="What is done to the file", items=PRESETS)
    pipeline: bpy.props.StringProperty(
        name="Stages", description='Stages on a line, such as "weld, lookahead(quality=high), vertex-fetch"'
    )
    report: bpy.props.StringProperty(name="Report", description="What the last export gained")


def draw_export(context, layout):
    """The panel in the export dialog; the exporter calls it."""
    settings = context.scene.foredraw
    header, body = layout.panel("FOREDRAW_export", default_closed=False)
    header.use_property_split = False
    header.prop(settings, "enabled")
    if body is None:
        return
    body.active = settings.enabled
    body.prop(settings, "preset")
    if settings.preset == "text":
        body.prop(settings, "pipeline")
    for line in settings.report.splitlines():
        body.label(text=line)


class glTF2ExportUserExtension:
    """Found by its name; made anew for each export."""

    def post_export_hook(self, export_settings):
        """Called when all files are written. Whatever goes wrong here, the exported files are as the exporter left
        them."""
        settings = bpy.context.scene.foredraw
        if not settings.enabled:
            return
        settings.report = made_cheaper(export_settings["gltf_filepath"], pipeline_of(settings), program())
        print("Foredraw: " + settings.report.replace("\n", "; "))


def pipeline_of(settings):
    return settings.pipeline if settings.preset == "text" else "@" + settings.preset


def program():
    """The path of foredraw, as preferences say it or the system finds it."""
    addon = bpy.context.preferences.addons.get(__name__)
    named = bpy.path.abspath(addon.preferences.program) if addon and addon.preferences.program else ""
    return named or shutil.which("foredraw") or ""


def made_cheaper(path, pipeline, foredraw):
    """Runs the program on the file, in its place, and says what it gained, or why the file is as it was: a few lines."""
    if not foredraw:
        return "The program foredraw was not found: name it in the add-on's preferences. The file is as exported."
    if not os.path.isfile(path):
        return f"There is no file {path}."
    with tempfile.TemporaryDirectory() as folder:
        told = os.path.join(folder, "report.json")
        # Its output replaces its input whole or not at all.
        command = [foredraw, "optimize", path, "-o", path, "-p", pipeline, "--report", told]
        try:
            ended = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", errors="replace")
        except OSError as problem:
            return f"{foredraw} can not be run: {problem.strerror}. The file is as exported."
        if ended.returncode not in (0, 2) or not os.path.isfile(told):
            return "The file is as exported.\n" + last_lines(ended.stderr)
        with open(told, encoding="utf-8") as file:
            report = json.load(file)
    lines = gains(report["totals"])
    if ended.returncode == 2:
        lines.append("A stage failed and left what it found: " + last_lines(ended.stderr))
    return "\n".join(lines)


def gains(totals):
    """A line for each figure that has a before."""
    before = totals.get("before", {}).get("metrics", {})
    lines = []
    for evaluator, metric, name in [
        ("vertex-cache", "acmr", "vertices shaded a triangle"),
        ("overdraw-raster", "ratio", "fragments shaded a pixel"),
    ]:
        was = before.get(evaluator, {}).get(metric, {}).get("value")
        now = totals.get("metrics", {}).get(evaluator, {}).get(metric, {}).get("value")
        if was and now is not None:
            lines.append(f"{name}: {was:.3f} -> {now:.3f} ({100 * (now - was) / was:+.1f} %)")
    return lines or ["done"]


def last_lines(text, count=3):
    return "\n".join(text.strip().splitlines()[-count:])


CLASSES = (ForedrawPreferences, ForedrawProperties)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.foredraw = bpy.props.PointerProperty(type=ForedrawProperties)


def unregister():
    del bpy.types.Scene.foredraw
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
