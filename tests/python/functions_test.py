"""The plain functions do what they say, on nothing too, and say what is wrong."""

import unittest

import foredraw as fd
import numpy as np
from meshes import sheet, sorted_rows

PLACES, INDICES = sheet(40)
EMPTY = np.empty((0, 3), np.uint32)


class Functions(unittest.TestCase):
    def assert_permutation(self, order):
        self.assertEqual(order.dtype, np.uint32)
        np.testing.assert_array_equal(np.sort(order), np.arange(len(order)))

    def test_orders_help_the_cache(self):
        before = fd.vertex_cache(INDICES)
        self.assertGreater(before.acmr, 2)
        for make in [fd.tipsify, fd.forsyth, fd.lookahead]:
            order = make(INDICES)
            self.assert_permutation(order)
            after = fd.vertex_cache(fd.reorder_triangles(INDICES, order))
            self.assertLess(after.acmr, 0.8, make.__name__)
            self.assertEqual(after.vertices, len(PLACES))
            self.assertAlmostEqual(after.acmr, after.misses / len(INDICES))
            self.assertAlmostEqual(after.atvr, after.misses / len(PLACES))

    def test_options_arrive(self):
        def misses(order, cache_size):
            return fd.vertex_cache(INDICES[order], cache_size=cache_size).misses

        self.assertLess(misses(fd.tipsify(INDICES, cache_size=64), 64), misses(fd.tipsify(INDICES, cache_size=8), 64))
        self.assertFalse(np.array_equal(fd.forsyth(INDICES, cache_size=4), fd.forsyth(INDICES)))
        orders = [fd.lookahead(INDICES, quality=quality, target="fifo") for quality in ["fast", "balanced", "high"]]
        counts = [misses(order, 16) for order in orders]
        self.assertEqual(counts, sorted(counts, reverse=True))
        self.assertGreater(counts[0], counts[2])
        targets = {fd.lookahead(INDICES, target=t).tobytes() for t in ["robust", "fifo", "nvidia", "amd", "intel"]}
        self.assertGreater(len(targets), 3)
        cached = INDICES[fd.tipsify(INDICES)]
        np.testing.assert_array_equal(
            fd.linear_clusters(cached, growth=np.float32(1.5)), fd.linear_clusters(cached, growth=1.5)
        )
        few, many = fd.linear_clusters(cached, growth=1.0), fd.linear_clusters(cached, growth=1.5)
        self.assertLess(len(few), len(many))

    def test_a_mesh_from_first_to_last(self):
        cached = fd.reorder_triangles(INDICES, fd.lookahead(INDICES))
        offsets = fd.linear_clusters(cached)
        self.assertEqual((offsets[0], offsets[-1]), (0, len(INDICES)))
        self.assertTrue((offsets[1:] > offsets[:-1]).all())
        sequence = fd.dot_rule(cached, PLACES, offsets)
        order = fd.order_of_clusters(offsets, sequence)
        ranges = [np.arange(offsets[one], offsets[one + 1]) for one in sequence]
        np.testing.assert_array_equal(order, np.concatenate(ranges))
        drawn = fd.reorder_triangles(cached, order)
        np.testing.assert_array_equal(drawn, cached[order])
        vertices, used = fd.vertex_fetch(drawn, len(PLACES) + 5)
        self.assertEqual(used, len(PLACES))
        self.assert_permutation(vertices)
        numbered = fd.renumber_vertices(drawn, vertices)
        moved = fd.reorder_elements(PLACES, vertices[:used])
        np.testing.assert_array_equal(moved[numbered], PLACES[drawn])
        np.testing.assert_array_equal(sorted_rows(drawn), sorted_rows(INDICES))

    def test_elements_may_be_of_any_plain_type(self):
        order = [2, 0]
        table = np.array([(1, 2.0), (3, 4.0), (5, 6.0)], [("a", np.int8), ("b", np.float64)])
        for elements in [np.arange(3), np.arange(24).reshape(3, 4, 2), table, np.arange(12).reshape(3, 4).T[:3]]:
            np.testing.assert_array_equal(fd.reorder_elements(elements, order), elements[order])
        with self.assertRaises(TypeError):
            fd.reorder_elements(np.array([None, 1, 2]), order)

    def test_nothing_is_made_of_nothing(self):
        for empty in [EMPTY, EMPTY.astype(np.int64), []]:
            for make in [fd.tipsify, fd.forsyth, fd.lookahead]:
                self.assertEqual(make(empty).shape, (0,))
            np.testing.assert_array_equal(fd.linear_clusters(empty), [0])
            self.assertEqual(fd.dot_rule(empty, np.empty((0, 3)), [0]).shape, (0,))
            self.assertEqual(fd.reorder_triangles(empty, []).shape, np.shape(empty))
            self.assertEqual(fd.renumber_vertices(empty, [1, 0]).shape, np.shape(empty))
            self.assertEqual(fd.vertex_cache(empty), (0, 0, 0, 0))
        order, used = fd.vertex_fetch(EMPTY, 3)
        self.assert_permutation(order)
        self.assertEqual(used, 0)
        self.assertEqual(fd.order_of_clusters([0], []).shape, (0,))
        self.assertEqual(fd.reorder_elements(np.empty((0, 4)), []).shape, (0, 4))

    def test_options_out_of_range_are_told(self):
        for make, most in [(fd.tipsify, 2**31), (fd.forsyth, 65), (fd.lookahead, 257), (fd.vertex_cache, 65536)]:
            for wrong in [0, -1, most, 2**32 + 16]:
                with self.assertRaisesRegex(ValueError, "cache_size"):
                    make(INDICES, cache_size=wrong)
            with self.assertRaises(TypeError):
                make(INDICES, cache_size="16")
        for wrong in [0, 0.0, 0.5, -2, float("nan")]:
            with self.assertRaisesRegex(ValueError, "growth"):
                fd.linear_clusters(INDICES, growth=wrong)
        with self.assertRaisesRegex(ValueError, "'best', but must be one of fast, balanced, high"):
            fd.lookahead(INDICES, quality="best")
        with self.assertRaisesRegex(ValueError, "one of robust, fifo, nvidia, amd, intel"):
            fd.lookahead(INDICES, target=["fifo"])

    def test_orders_that_are_none_are_told(self):
        two = INDICES[:2]
        for wrong in [[0, 0], [0, 2], [0, -1]]:
            with self.assertRaises(ValueError):
                fd.reorder_triangles(two, wrong)
            with self.assertRaises(ValueError):
                fd.order_of_clusters([0, 1, 2], wrong)
            with self.assertRaises(ValueError):
                fd.reorder_elements(PLACES[:2], wrong)
        with self.assertRaisesRegex(ValueError, "3 entries, but there are 2 triangles"):
            fd.reorder_triangles(two, [0, 1, 2])
        with self.assertRaisesRegex(ValueError, "the shape"):
            fd.reorder_triangles(two, [[0, 1]])
        with self.assertRaisesRegex(TypeError, "the order must be integers"):
            fd.reorder_triangles(two, [0.0, 1.0])
        with self.assertRaises(ValueError):  # the order has too few vertices
            fd.renumber_vertices(two, [0, 1])
        with self.assertRaises(ValueError):  # vertex 0 would be number 299, which 8 bits do not hold
            fd.renumber_vertices(np.array([0, 1, 2], np.uint8), np.arange(300)[::-1])
        with self.assertRaises(ValueError):
            fd.reorder_elements(PLACES[:2], [0, 1, 0])

    def test_clusters_that_are_none_are_told(self):
        for wrong in [[], [1, 2], [0, 0, 2], [0, 1], [0, 3], [0, 2, 1]]:
            with self.assertRaises(ValueError):
                fd.dot_rule(INDICES[:2], PLACES, wrong)
        for wrong in [[], [0, 2], [1, 2, 3], [0, 2, 1], [0, 0, 2**32 - 1]]:
            with self.assertRaises(ValueError):
                fd.order_of_clusters(wrong, [0, 1])
