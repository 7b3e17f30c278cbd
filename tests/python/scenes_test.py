"""Scenes lend what they hold without a copy, and what is lent outlives them; scenes are made of arrays and files."""

import base64
import copy
import gc
import json
import mmap
import pickle
import struct
import tempfile
import unittest
import weakref
from pathlib import Path

import foredraw as fd
import numpy as np
from meshes import HELMET, SPOT, sheet


def lines_and_a_triangle():
    """The text of a glTF with a draw of each."""
    data = struct.pack("<9f3H2x", *range(9), 0, 1, 2)
    views = [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}]
    accessors = [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 1, 2], "max": [6, 7, 8]},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
    ]
    lines = {"attributes": {"POSITION": 0}, "mode": 3}
    triangle = {"attributes": {"POSITION": 0}, "indices": 1}
    return json.dumps(
        {
            "asset": {"version": "2.0"},
            "buffers": [{"byteLength": 44, "uri": "data:;base64," + base64.b64encode(data).decode()}],
            "bufferViews": views,
            "accessors": accessors,
            "meshes": [{"name": "both", "primitives": [lines, triangle]}],
            "nodes": [{"mesh": 0}],
            "scenes": [{"nodes": [0]}],
        }
    ).encode()


class Lending(unittest.TestCase):
    def test_views_are_of_the_scenes_memory_and_read_only(self):
        draw = fd.read(SPOT).draws[0]
        again = draw.indices
        views = [draw.indices, draw.positions, *draw.streams.values()]
        self.assertTrue(np.shares_memory(draw.indices, again))
        self.assertTrue(np.shares_memory(draw.positions, draw.positions))
        for view in views:
            self.assertFalse(view.flags.writeable)
            with self.assertRaises(ValueError):
                view.flags.writeable = True
        self.assertEqual(draw.indices.shape, (draw.triangle_count, 3))
        self.assertEqual(draw.positions.shape, (draw.vertex_count, 3))
        self.assertEqual(draw.streams["TEXCOORD_0"].shape, (draw.vertex_count, 2))
        self.assertLess(draw.indices.max(), draw.vertex_count)

    def test_views_outlive_their_scene(self):
        scene = fd.read(HELMET)
        handle = weakref.ref(scene._handle)
        views = [(v, v.copy()) for d in scene.draws for v in [d.indices, d.positions, *d.streams.values()]]
        del scene
        gc.collect()
        others = [fd.read(HELMET) for _ in range(3)]  # which would take freed memory
        for view, before in views:
            np.testing.assert_array_equal(view, before)
        self.assertIsNotNone(handle())
        part = views[0][0][5:10]
        del view, before, views
        self.assertIsNotNone(handle())
        del part
        self.assertIsNone(handle())  # without a collection: there is no cycle
        del others

    def test_draws_are_a_sequence(self):
        scene = fd.read(HELMET)
        count = len(scene.draws)
        self.assertGreater(count, 2)
        self.assertEqual([draw.name for draw in scene.draws], [scene.draws[i].name for i in range(count)])
        self.assertEqual(scene.draws[-1].triangle_count, scene.draws[count - 1].triangle_count)
        self.assertEqual(len(scene.draws[1:]), count - 1)
        for wrong in [count, -count - 1]:
            with self.assertRaises(IndexError):
                scene.draws[wrong]
            with self.assertRaises(IndexError):
                scene.moves(wrong)
        self.assertIn(f"{count} draws", repr(scene))
        self.assertIn("triangles", repr(scene.draws))

    def test_lines_have_no_arrays(self):
        scene = fd.read_bytes(lines_and_a_triangle(), "both.gltf")
        lines, triangle = scene.draws
        self.assertEqual([lines.has_triangles, triangle.has_triangles], [False, True])
        np.testing.assert_array_equal(triangle.positions, np.arange(9).reshape(3, 3))
        for ask in [lambda: lines.indices, lambda: lines.positions, lambda: lines.streams, lambda: lines.name]:
            with self.assertRaisesRegex(ValueError, "draw 0 is one of lines or points"):
                ask()
        self.assertEqual(scene.moves(0), (None, None))
        self.assertIn("lines", repr(lines))

    def test_scenes_stay_in_their_process(self):
        scene = fd.read(SPOT)
        for send in [pickle.dumps, copy.deepcopy]:
            with self.assertRaisesRegex(TypeError, "stays in its process"):
                send(scene)
        with self.assertRaisesRegex(TypeError, "stays in its process"):
            pickle.dumps(fd.Context())


class Reading(unittest.TestCase):
    def test_bytes_are_read_as_files_are(self):
        theirs = fd.read(SPOT).draws[0]
        data = SPOT.read_bytes()
        with open(SPOT, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as mapped:
            for lender in [data, bytearray(data), memoryview(data), mapped, np.frombuffer(data, np.uint8)]:
                draw = fd.read_bytes(lender).draws[0]
                np.testing.assert_array_equal(draw.indices, theirs.indices)
                np.testing.assert_array_equal(draw.positions, theirs.positions)

    def test_what_is_wrong_is_said(self):
        for read, file in [(lambda: fd.read("none.glb"), "none.glb"), (lambda: fd.read_bytes(b"glTF", "four"), "four"),
                           (lambda: fd.read_bytes(b"", "empty"), "empty"), (lambda: fd.read(Path("no.obj")), "no.obj")]:
            with self.assertRaisesRegex(fd.Error, f"^{file}: error: ") as caught:
                read()
            self.assertEqual(caught.exception.diagnostics[0]["file"], file)
            self.assertEqual(caught.exception.diagnostics[0]["severity"], "error")
        with self.assertRaisesRegex(ValueError, "a path contains a zero byte"):
            fd.read("a\0b.glb")
        with self.assertRaises(TypeError):
            fd.read(7)
        with self.assertRaises(TypeError):
            fd.read_bytes("a text")

    def test_warnings_are_kept(self):
        document = json.loads(lines_and_a_triangle())
        document["meshes"][0]["primitives"].append({"attributes": {"NORMAL": 0}})
        said = fd.read_bytes(json.dumps(document).encode()).diagnostics
        self.assertEqual({one["severity"] for one in said}, {"warning"})

    def test_written_scenes_are_read_again(self):
        with tempfile.TemporaryDirectory() as folder:
            for path in [Path(folder) / "ü.glb", folder + "/a.gltf"]:
                scene = fd.read(SPOT)
                said = scene.write(path)
                self.assertLessEqual({one["severity"] for one in said}, {"note"})
                again = fd.read(path)
                np.testing.assert_array_equal(again.draws[0].indices, scene.draws[0].indices)
            with self.assertRaisesRegex(fd.Error, "error: "):
                fd.write(scene, folder + "/none/x.glb")
            with self.assertRaisesRegex(fd.Error, "error: "):
                fd.write(scene, folder + "/x.unknown")


class Making(unittest.TestCase):
    def setUp(self):
        self.positions, self.indices = sheet(20)
        self.count = len(self.positions)

    def test_arrays_come_out_as_they_went_in(self):
        random = np.random.default_rng(1)
        padded = random.integers(-100, 100, (self.count, 4)).astype(np.int8)
        streams = {
            "NORMAL": padded[:, :3],
            "TEXCOORD_0": random.random((self.count, 2)),
            "COLOR_0": random.integers(0, 255, (self.count, 4)).astype(np.uint8),
            "_ROW": np.arange(self.count, dtype=np.uint32),
            "_BIG": np.asfortranarray(random.integers(0, 9, (self.count, 16)).astype(">u2")),
            "_BACK": np.arange(self.count, dtype=np.int16)[::-1],
        }
        normalized = frozenset(["NORMAL", "COLOR_0"])
        draw = fd.Draw(self.indices.astype(np.int64), self.positions.astype(float), streams, "sheet", normalized)
        scene = fd.make([draw])
        for made in [scene.draws[0], fd.make(scene.draws).draws[0]]:
            self.assertEqual(made.name, "sheet")
            np.testing.assert_array_equal(made.indices, self.indices)
            np.testing.assert_array_equal(made.positions, self.positions)
            self.assertEqual(list(made.streams), list(streams))
            for name, values in streams.items():
                kept = np.asarray(values).reshape(self.count, -1)
                if name == "TEXCOORD_0":
                    kept = kept.astype(np.float32)
                self.assertEqual(made.streams[name].dtype, kept.dtype.newbyteorder("="))
                np.testing.assert_array_equal(made.streams[name], kept)
            self.assertEqual(made.normalized, normalized)

    def test_draws_may_be_odd(self):
        nothing = fd.Draw(np.empty((0, 3), np.uint8), np.empty((0, 3)))
        odd = fd.Draw([0, 0, 0], [[np.nan, np.inf, -np.inf]])
        scene = fd.make([nothing, odd])
        self.assertEqual([draw.triangle_count for draw in scene.draws], [0, 1])
        self.assertEqual(scene.draws[0].positions.shape, (0, 3))
        self.assertFalse(scene.draws[0].indices.flags.writeable)
        np.testing.assert_array_equal(scene.draws[1].positions, [[np.nan, np.inf, -np.inf]])
        self.assertEqual(len(fd.make([]).draws), 0)
        fd.optimize(scene, "weld, tipsify, vertex-fetch")

    def test_wrong_draws_are_named(self):
        good = fd.Draw(self.indices, self.positions)
        tall = {"NORMAL": np.zeros((3, 3), np.float32)}
        cases = [
            (ValueError, "draw 1: indices must have the shape", fd.Draw([0, 1], self.positions)),
            (TypeError, "draw 1: positions must be numbers", fd.Draw(self.indices, [["a", "b", "c"]])),
            (ValueError, r"draw 1: NORMAL must have the shape \(441", fd.Draw(self.indices, self.positions, tall)),
            (TypeError, "draw 1: _N must be of one of the types int8",
             fd.Draw(self.indices, self.positions, {"_N": np.zeros(self.count, np.int64)})),
            (fd.Error, "_N has 17 components", fd.Draw(
                self.indices, self.positions, {"_N": np.zeros((self.count, 17), np.uint8)})),
            (fd.Error, "small: an index names a position", fd.Draw(self.indices, self.positions[:9], name="small")),
        ]
        for kind, text, wrong in cases:
            with self.subTest(text), self.assertRaisesRegex(kind, text):
                fd.make([good, wrong])

    def test_moves_say_where_all_went(self):
        positions, indices = sheet(150)  # vertices of a small one are as near to each other in any order
        scene = fd.make([fd.Draw(indices, positions), fd.Draw(indices[::-1], positions[::-1])])
        self.assertEqual(scene.moves(0), (None, None))
        done = fd.optimize(scene, "tipsify, vertex-fetch")
        for number, before in enumerate(scene.draws):
            after, moves = done.scene.draws[number], done.scene.moves(number)
            np.testing.assert_array_equal(after.indices, moves.vertices[before.indices[moves.triangles]])
            np.testing.assert_array_equal(after.positions[moves.vertices], before.positions)
            self.assertFalse(moves.triangles.flags.writeable)
