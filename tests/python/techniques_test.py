"""Techniques in Python run in pipelines beside the others; what is wrong with their answers is said."""

import unittest

import foredraw as fd
import numpy as np
from meshes import SPOT


@fd.orderer("my-radial", options=[fd.number("power", 1, 0.1, 4), fd.boolean("turned-round", False)])
def radial(draw, power, turned_round):
    """Draws triangles far from the origin first."""
    distance = np.linalg.norm(draw.positions[draw.indices].mean(axis=1), axis=1) ** power
    return np.argsort(distance if turned_round else -distance, kind="stable")


def failing(function):
    """What the report says of a stage of this function."""
    context = fd.Context()
    fd.add(fd.orderer("failing")(function), context=context)
    try:
        fd.optimize(fd.read(SPOT), "failing", context=context)
    except fd.Error as problem:
        return str(problem)
    return ""


class Techniques(unittest.TestCase):
    def setUp(self):
        self.context = fd.Context()
        self.scene = fd.read(SPOT)

    def test_an_orderer_runs_beside_the_others(self):
        fd.add(radial, context=self.context)
        done = fd.optimize(self.scene, "tipsify, my-radial(power=2), vertex-fetch", context=self.context)
        draw = done.scene.draws[0]
        distance = np.linalg.norm(draw.positions[draw.indices].mean(axis=1), axis=1)
        self.assertTrue(np.all(np.diff(distance) <= 1e-6))
        rows = fd.compare([SPOT], ["tipsify", "my-radial", "my-radial(turned-round=true)"], context=self.context)
        self.assertEqual(len({row["pipeline"] for row in rows} & {"my-radial", "tipsify"}), 2)
        with self.assertRaisesRegex(fd.Error, "0.1 to 4"):
            fd.optimize(self.scene, "my-radial(power=9)", context=self.context)
        with self.assertRaisesRegex(fd.Error, "did you mean 'my-radial'"):
            fd.optimize(self.scene, "my-radail", context=self.context)
        self.assertEqual(len(radial(self.scene.draws[0], 1, False)), self.scene.draws[0].triangle_count)

    def test_what_is_wrong_is_said_and_the_draw_stays(self):
        self.assertIn("permutation", failing(lambda draw: np.zeros(draw.triangle_count, int)))
        self.assertIn("permutation", failing(lambda draw: [0]))
        self.assertIn("at most 5856", failing(lambda draw: np.arange(draw.triangle_count + 1)))
        self.assertIn("must be integers", failing(lambda draw: np.ones(draw.triangle_count)))
        self.assertIn("one is -1", failing(lambda draw: -np.ones(draw.triangle_count, int)))
        said = failing(lambda draw: draw.nothing)
        self.assertIn("AttributeError", said)
        self.assertIn("techniques_test.py", said)

    def test_arrays_can_not_be_written(self):
        def writes(draw):
            draw.indices[0] = 0

        self.assertIn("read-only", failing(writes))

    def test_what_there_is_may_be_kept(self):
        @fd.orderer("content")
        def content(draw):
            raise fd.Keep("it is good already")

        fd.add(content, context=self.context)
        report = fd.optimize(self.scene, "content", context=self.context).report
        self.assertIn("it is good already", str(report))

    def test_vertex_orderers_clusterers_and_evaluators_too(self):
        @fd.vertex_orderer("reversed")
        def reversed_(draw):
            return np.arange(draw.vertex_count)[::-1]

        @fd.clusterer("pairs", provides="clustered")
        def pairs(draw):
            return np.append(np.arange(0, draw.triangle_count, 2), draw.triangle_count)

        @fd.evaluator("cluster-size", [fd.choice("of", ["triangles", "corners"]), fd.integer("times", 1, 1, 9)],
                      metrics=[fd.Metric("mean", "triangles", "Of a cluster"), fd.Metric("streams", "streams")])
        def size(draw, of, times):
            corners = {"triangles": 1, "corners": 3}[of]
            clusters = len(draw.cluster_offsets) - 1
            return {"mean": (times * corners * draw.triangle_count, clusters), "streams": len(draw.streams)}

        for technique in [reversed_, pairs, size]:
            fd.add(technique, context=self.context)
        text = 'pipeline = 1\nstages = ["reversed", "pairs"]\nmeasure = ["cluster-size(of=corners, times=2)"]\n'
        done = fd.optimize(self.scene, text, context=self.context)
        figures = done.report["totals"]["metrics"]["cluster-size"]
        self.assertEqual(figures["mean"]["value"], 12)
        self.assertEqual(figures["streams"]["value"], len(self.scene.draws[0].streams))
        before, after = self.scene.draws[0], done.scene.draws[0]
        self.assertEqual(after.indices[0, 0], before.vertex_count - 1 - before.indices[0, 0])

    def test_remeshers_answer_with_sources(self):
        @fd.remesher("half", provides="welded")
        def half(draw):
            left = draw.indices[: draw.triangle_count // 2]
            vertex_from, indices = np.unique(left, return_inverse=True)
            return indices.reshape(left.shape), vertex_from

        fd.add(half, context=self.context)
        before = self.scene.draws[0]
        after = fd.optimize(self.scene, "half", context=self.context).scene.draws[0]
        self.assertEqual(after.triangle_count, before.triangle_count // 2)
        self.assertLess(after.vertex_count, before.vertex_count)
        for semantic, values in after.streams.items():
            np.testing.assert_array_equal(
                values[after.indices], before.streams[semantic][before.indices[: after.triangle_count]]
            )

        def wrong(answer, **said):
            context = fd.Context()
            fd.add(fd.remesher("wrong", **said)(lambda draw: answer(draw)), context=context)
            with self.assertRaises(fd.Error) as caught:
                fd.optimize(self.scene, "wrong", context=context)
            return str(caught.exception)

        self.assertIn("an index to vertex 3", wrong(lambda draw: ([0, 1, 3], [0, 1, 2])))
        self.assertIn("at most 3225", wrong(lambda draw: ([0, 1, 2], np.zeros(3226, int))))
        lossless = wrong(lambda draw: (draw.indices[1:], np.arange(draw.vertex_count)), lossless=True)
        self.assertIn("other triangles than before", lossless)

    def test_overdraw_is_counted_for_who_asks(self):
        counts = {}

        @fd.orderer("asks", uses_overdraw=True)
        def asks(draw):
            there, backwards = np.arange(draw.triangle_count), np.arange(draw.triangle_count)[::-1]
            counts.update(there=draw.count_overdraw(), same=draw.count_overdraw(there))
            counts["backwards"] = draw.count_overdraw(backwards)
            for odd in [there[:-1], np.zeros(draw.triangle_count, int)]:
                with self.assertRaises(ValueError):
                    draw.count_overdraw(odd)
            return backwards

        fd.add(asks, context=self.context)
        fd.optimize(self.scene, "asks", context=self.context)
        self.assertEqual(counts["there"], counts["same"])
        self.assertEqual(counts["there"][1], counts["backwards"][1])
        self.assertNotEqual(counts["there"][0], counts["backwards"][0])
        self.assertIn("uses_overdraw=True", failing(lambda draw: draw.count_overdraw()))

    def test_wrong_ones_are_not_added(self):
        with self.assertRaisesRegex(fd.Error, "already a plugin 'tipsify'"):
            fd.add(fd.orderer("tipsify")(radial.function), context=self.context)
        with self.assertRaisesRegex(fd.Error, "0 to 1"):
            fd.add(fd.orderer("odd", [fd.number("x", 2, 0, 1)])(radial.function), context=self.context)


if __name__ == "__main__":
    unittest.main()
