"""Arrays of all kinds are taken as they are meant; copied only where they must be; and refused in words."""

import tracemalloc
import unittest

import foredraw as fd
import numpy as np
from foredraw._arrays import positions, triangles
from meshes import sheet

PLACES, INDICES = sheet(9)  # 100 vertices, so that 8 bits hold their numbers
ORDER = fd.tipsify(INDICES)


def misaligned(array):
    return np.frombuffer(b"\0" + array.tobytes(), array.dtype, offset=1).reshape(array.shape)


def read_only(array):
    copy = array.copy()
    copy.flags.writeable = False
    return copy


class Indices(unittest.TestCase):
    def test_of_all_forms_are_the_same_triangles(self):
        wide = INDICES.astype(np.int64)
        padded = np.zeros((len(INDICES), 5), np.uint16)
        padded[:, 1:4] = INDICES
        forms = {str(np.dtype(dtype)): INDICES.astype(dtype) for dtype in "BHIQbhiq"}
        forms.update({dtype: INDICES.astype(dtype) for dtype in [">u2", ">u4", ">i4", ">i8"]})
        forms.update(
            flat=INDICES.reshape(-1),
            fortran=np.asfortranarray(INDICES),
            fortran64=np.asfortranarray(wide),
            sliced=padded[:, 1:4],
            every_second=np.repeat(INDICES, 2, axis=0)[::2],
            backwards=INDICES[::-1].copy()[::-1],
            read_only=read_only(INDICES),
            misaligned=misaligned(INDICES),
            a_list=INDICES.tolist(),
            a_flat_list=INDICES.reshape(-1).tolist(),
        )
        for name, form in forms.items():
            with self.subTest(name):
                np.testing.assert_array_equal(fd.tipsify(form), ORDER)
                moved = fd.reorder_triangles(form, ORDER)
                self.assertEqual(moved.dtype, np.asarray(form).dtype)
                np.testing.assert_array_equal(moved, np.asarray(form).reshape(-1, 3)[ORDER].reshape(np.shape(form)))

    def test_are_taken_in_place_where_they_can_be(self):
        for dtype in "BHIbhi":
            given = read_only(INDICES.astype(dtype))
            self.assertTrue(np.shares_memory(triangles(given).array, given), dtype)
        interleaved = np.zeros((len(PLACES), 8), np.float32)
        interleaved[:, 2:5] = PLACES
        given, count = positions(interleaved[:, 2:5])
        self.assertTrue(np.shares_memory(given.array, interleaved))
        self.assertEqual((given.stride, count), (32, len(PLACES)))

    def test_of_a_million_triangles_are_not_copied(self):
        million = np.tile(INDICES, (1_000_000 // len(INDICES) + 1, 1))[:1_000_000]
        tracemalloc.start()
        try:
            for given in [million, million.view(np.int32)]:
                tracemalloc.reset_peak()
                before = tracemalloc.get_traced_memory()[0]
                order = fd.tipsify(given)
                peak = tracemalloc.get_traced_memory()[1] - before
                self.assertLess(peak, order.nbytes + 100_000)
                self.assertGreaterEqual(peak, order.nbytes)
        finally:
            tracemalloc.stop()

    def test_that_are_none_are_refused(self):
        cases = [
            (TypeError, "float64", INDICES.astype(float)),
            (TypeError, "float32", np.empty((0, 3), np.float32)),
            (TypeError, "bool", np.ones((1, 3), bool)),
            (TypeError, "object", np.array([0, 1, 2**70])),
            (TypeError, "<U1", ["a", "b", "c"]),
            (ValueError, "one is -1", [0, 1, -1]),
            (ValueError, "one is -1", np.array([0, 1, -1], np.int8)),
            (ValueError, "one is 4294967296", [0, 1, 2**32]),
            (ValueError, "one is 18446744073709551615", np.array([0, 1, 2**64 - 1], np.uint64)),
            (ValueError, "vertex_count must be", [0, 1, 2**32 - 1]),
            (ValueError, r"\(4,\)", [0, 1, 2, 3]),
            (ValueError, r"\(3, 4\)", np.zeros((3, 4), int)),
            (ValueError, r"\(1, 1, 3\)", np.zeros((1, 1, 3), int)),
            (ValueError, r"\(\)", 7),
        ]
        for kind, text, given in cases:
            with self.subTest(text=text), self.assertRaisesRegex(kind, text):
                fd.tipsify(given)

    def test_beyond_the_vertices_are_told(self):
        with self.assertRaisesRegex(ValueError, "the largest is 99, and there are 99 vertices"):
            fd.tipsify(INDICES, 99)
        for wrong in [-1, 2**32]:
            with self.assertRaisesRegex(ValueError, f"vertex_count must be 0 to 4294967295, but is {wrong}"):
                fd.tipsify(INDICES, wrong)
        with self.assertRaises(TypeError):
            fd.tipsify(INDICES, 100.0)


class Positions(unittest.TestCase):
    def test_of_all_forms_are_the_same_places(self):
        offsets = fd.linear_clusters(INDICES)
        sequence = fd.dot_rule(INDICES, PLACES, offsets)
        table = np.zeros(len(PLACES), [("normal", np.int8, 3), ("place", np.float32, 3)])  # misaligned
        table["place"] = PLACES
        forms = {
            "float64": PLACES.astype(float),
            "float16": PLACES.astype(np.float16),
            "int64": PLACES.astype(int),
            ">f4": PLACES.astype(">f4"),
            "flat": PLACES.reshape(-1),
            "fortran": np.asfortranarray(PLACES),
            "backwards": PLACES[::-1].copy()[::-1],
            "within a table": table["place"],
            "read-only": read_only(PLACES),
            "a list": PLACES.tolist(),
        }
        for name, form in forms.items():
            with self.subTest(name):
                np.testing.assert_array_equal(fd.dot_rule(INDICES, form, offsets), sequence)

    def test_may_be_no_numbers(self):
        odd = PLACES.astype(float)
        odd[::7] = np.nan
        odd[3] = np.inf
        odd[5] = 1e300  # more than 32 bits hold
        sequence = fd.dot_rule(INDICES, odd, fd.linear_clusters(INDICES))
        np.testing.assert_array_equal(np.sort(sequence), np.arange(len(sequence)))

    def test_that_are_none_are_refused(self):
        offsets = fd.linear_clusters(INDICES)
        for kind, given in [(ValueError, PLACES[:, :2]), (ValueError, [1, 2]), (TypeError, PLACES.astype(complex))]:
            with self.assertRaises(kind):
                fd.dot_rule(INDICES, given, offsets)
