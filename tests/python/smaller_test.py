"""Meshes made smaller, sprites, instances, overdraw, and orders of one draw by stages."""

import unittest

import foredraw as fd
import numpy as np
from meshes import sheet, sorted_rows

PLACES, INDICES = sheet(20)
BUMPS = PLACES.astype(np.float32).copy()
BUMPS[:, 2] += np.arange(len(BUMPS)) * 7 % 11 * 0.3


class Weld(unittest.TestCase):
    def test_equal_vertices_become_one(self):
        corners = np.arange(INDICES.size).reshape(INDICES.shape)
        places, colours = BUMPS[INDICES.ravel()], (INDICES.ravel() % 3).astype(np.uint8)
        welded = fd.weld(corners, places, colours)
        self.assertEqual(len(welded.kept), len(BUMPS))
        np.testing.assert_array_equal(places[welded.kept][welded.indices], places[corners])
        np.testing.assert_array_equal(fd.move_vertices(corners, welded.destination), welded.indices)
        self.assertEqual(len(fd.weld(corners[:2], places, keep_unused=True).kept), len(BUMPS))
        self.assertEqual(len(fd.weld(INDICES[:1], BUMPS).kept), 3)

    def test_what_is_wrong_is_told(self):
        with self.assertRaisesRegex(ValueError, "an attribute"):
            fd.weld(INDICES)
        with self.assertRaisesRegex(ValueError, "as long as"):
            fd.weld(INDICES, BUMPS, BUMPS[:3])
        with self.assertRaisesRegex(TypeError, "plain memory"):
            fd.weld(INDICES, np.full(len(BUMPS), None))
        with self.assertRaisesRegex(ValueError, "not below"):
            fd.weld(INDICES, BUMPS[:5])


class Shells(unittest.TestCase):
    def test_closed_ones_are_told_from_open_ones(self):
        corners = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
        places = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        self.assertEqual(fd.shell_kinds(corners, places).tolist(), [0] * 4)
        self.assertEqual(fd.shell_kinds(corners[:, ::-1], places).tolist(), [3] * 4)
        self.assertEqual(fd.shell_kinds(corners[:3], places).tolist(), [1] * 3)


class Simplify(unittest.TestCase):
    def test_to_a_count_and_to_an_error(self):
        collapses = fd.quadric_collapse(INDICES, BUMPS)
        self.assertGreater(len(collapses), 100)
        half = fd.simplify(INDICES, BUMPS, collapses, triangles_left=400)
        self.assertLessEqual(len(half.indices), 400)
        self.assertGreater(half.error, 0)
        np.testing.assert_array_equal(half.positions, BUMPS)
        self.assertEqual(half.indices.dtype, INDICES.dtype)
        exact = fd.simplify(INDICES, BUMPS, collapses, error=0)
        self.assertLess(exact.error, 1e-5)
        loose = fd.simplify(INDICES, BUMPS, error=half.error)
        self.assertLessEqual(loose.error, half.error * 1.03)
        moved = fd.simplify(INDICES, BUMPS, fd.quadric_collapse(INDICES, BUMPS, moves=True), triangles_left=400)
        self.assertFalse(np.array_equal(moved.positions, BUMPS))
        coloured = fd.quadric_collapse(INDICES, BUMPS, [(np.arange(len(BUMPS)) % 5, 2.0)], least=300)
        self.assertFalse(np.array_equal(coloured.collapses[:50], collapses.collapses[:50]))

    def test_what_vertices_carry_comes_along(self):
        ramp = BUMPS[:, 0].copy()  # which is linear on the surface's plane, and nearly so on its bumps
        up = np.tile(np.float32([0, 0, 1]), (len(BUMPS), 1))
        attributes = [(ramp, 0.1), (up, 0.1, "direction"), (ramp > 5, 0.1, "blended")]
        left = {}
        for solves in (True, False):
            collapses = fd.quadric_collapse(INDICES, BUMPS, attributes, moves=True, solves=solves)
            half = fd.simplify(INDICES, BUMPS, collapses, triangles_left=400)
            values = fd.level_attributes(INDICES, BUMPS, collapses, half.collapses, attributes)
            self.assertEqual([one.shape for one in values], [(len(BUMPS), 1), (len(BUMPS), 3), (len(BUMPS), 1)])
            np.testing.assert_array_equal(values[1], up)
            used = np.unique(half.indices)
            left[solves] = np.abs(values[0][used, 0] - half.positions[used, 0]).mean()
        self.assertLess(left[True], left[False])
        self.assertEqual(fd.level_attributes(INDICES, BUMPS, collapses, 0, []), [])
        with self.assertRaisesRegex(ValueError, "sideways"):
            fd.quadric_collapse(INDICES, BUMPS, [(up, 1, "sideways")])
        with self.assertRaisesRegex(ValueError, "attributes="):
            fd.quadric_collapse(INDICES, BUMPS, [(ramp, 1, "direction")])
        with self.assertRaisesRegex(ValueError, "another mesh"):
            fd.level_attributes(INDICES[:2], BUMPS[:30], collapses, 0, [(ramp[:30], 1)])

    def test_what_is_wrong_is_told(self):
        collapses = fd.quadric_collapse(INDICES, BUMPS)
        with self.assertRaisesRegex(ValueError, "another mesh"):
            fd.simplify(INDICES[:2], BUMPS[:30], collapses)
        with self.assertRaisesRegex(ValueError, "error=-1"):
            fd.simplify(INDICES, BUMPS, collapses, error=-1)
        collapses.collapses["removed"][1] = collapses.collapses["removed"][0]
        with self.assertRaises(ValueError):
            fd.simplify(INDICES, BUMPS, collapses, error=1)
        with self.assertRaisesRegex(ValueError, "a row for each"):
            fd.quadric_collapse(INDICES, BUMPS, [([1.0], 1)])

    def test_its_error_is_measured(self):
        half = fd.simplify(INDICES, BUMPS, triangles_left=400)
        measured = fd.surface_error(half.indices, half.positions, INDICES, BUMPS, samples=500)
        self.assertAlmostEqual(measured.largest, half.error, delta=0.05 * half.error)
        self.assertLessEqual(measured.rms, measured.largest)
        self.assertGreater(measured.mean_error, 0)
        with self.assertRaisesRegex(ValueError, "no triangle"):
            fd.surface_error(np.empty((0, 3), int), BUMPS, INDICES, BUMPS)

    def test_of_nothing(self):
        nothing = fd.simplify(np.empty((0, 3), np.uint32), np.empty((0, 3)))
        self.assertEqual(nothing.indices.shape, (0, 3))


class Overdraw(unittest.TestCase):
    def test_an_order_lowers_it(self):
        cached = fd.reorder_triangles(INDICES, fd.lookahead(INDICES))
        before = fd.overdraw(cached, BUMPS, views=40, size=64)
        order = fd.occlusion_order(cached, BUMPS, acmr_budget=2)
        np.testing.assert_array_equal(np.sort(order), np.arange(len(INDICES)))
        after = fd.overdraw(fd.reorder_triangles(cached, order), BUMPS, views=40, size=64)
        self.assertLess(after.ratio, before.ratio)
        self.assertEqual(after.visible, before.visible)
        self.assertGreaterEqual(after.worst_view, after.ratio)
        for wrong in [dict(views=0), dict(size=8), dict(views=100001)]:
            with self.assertRaises(ValueError):
                fd.overdraw(INDICES, BUMPS, **wrong)
        for wrong in [dict(quality="best"), dict(acmr_budget=0.5), dict(acmr_budget=0), dict(cache_size=2)]:
            with self.assertRaises(ValueError):
                fd.occlusion_order(INDICES, BUMPS, **wrong)


class Sprites(unittest.TestCase):
    def setUp(self):
        x, y = np.meshgrid(np.arange(64) % 32 - 16, np.arange(32) - 16)
        self.image = np.zeros((32, 64, 4), np.uint8)
        self.image[:, :, 3] = np.where(x * x + y * y < 100, 200, 0)

    def test_frames_and_polygons(self):
        alpha = self.image[:, :, 3]
        frames = fd.sprite_frames(alpha)
        self.assertEqual(len(frames), 2)
        trimmed = fd.particle_trim(alpha, frames, mip_levels=0)
        self.assertEqual([one.outcome for one in trimmed], ["trimmed"] * 2)
        self.assertLess(trimmed[0].area, 0.95 * trimmed[0].frame_area)
        self.assertLessEqual(trimmed[0].corners.max(), 1)
        wide = fd.particle_trim(alpha.astype(np.uint16) * 257, frames, vertices=4, mip_levels=0)
        self.assertEqual([len(one.corners) for one in wide], [4, 4])
        self.assertEqual(fd.particle_trim(alpha, frames[:1])[0].outcome, "no-saving")
        np.testing.assert_array_equal(fd.particle_trim(alpha.copy(), frames, mip_levels=0)[1].corners, trimmed[1].corners)
        self.assertEqual(fd.particle_trim(alpha, []), [])
        self.assertEqual(fd.particle_trim(np.zeros((8, 8), np.uint8), [(0, 0, 8, 8)])[0].outcome, "empty")

    def test_what_is_wrong_is_told(self):
        alpha = self.image[:, :, 3]
        for frames in [[(0, 0, 65, 1)], [(-1, 0, 2, 2)], [(0, 0, 0, 4)]]:
            with self.assertRaises(ValueError):
                fd.particle_trim(alpha, frames)
        with self.assertRaisesRegex(ValueError, "vertices=17"):
            fd.particle_trim(alpha, [(0, 0, 8, 8)], vertices=17)
        with self.assertRaisesRegex(ValueError, "repeat, mirrored, clamped"):
            fd.particle_trim(alpha, [(0, 0, 8, 8)], wrap=("clamp", "clamp"))
        with self.assertRaisesRegex(TypeError, "uint8 or uint16"):
            fd.sprite_frames(self.image)
        with self.assertRaisesRegex(ValueError, "no texels"):
            fd.sprite_frames(np.empty((0, 4), np.uint8))


class Instances(unittest.TestCase):
    def test_merged_draws_show_what_was_placed(self):
        small, cells = sheet(3)
        meshes = [(cells, small), (INDICES, BUMPS)]
        mesh_of = np.arange(30) % 2
        transforms = np.tile(np.eye(4), (30, 1, 1))
        transforms[:, 0, 3] = np.arange(30) * 50
        merged = fd.merge_instances(meshes, mesh_of, transforms)
        both = np.concatenate([small, BUMPS]).astype(np.float32)
        shown = []
        for draw in merged.draws:
            for slot in merged.slots[draw["first_slot"] : draw["first_slot"] + draw["slot_count"]]:
                entries = merged.indices[slot["index_offset"] : slot["index_offset"] + draw["frequency"]].reshape(-1, 3)
                entries = entries[(entries != entries[:, :1]).any(axis=1)]
                shown += [(both[t] + merged.transforms[slot["instance"]][:, 3]) for t in entries]
        placed = []
        for mesh, matrix in zip(mesh_of, transforms):
            indices, places = meshes[mesh]
            placed += [places[t].astype(np.float32) + matrix[:3, 3].astype(np.float32) for t in indices]
        np.testing.assert_allclose(sorted_rows(np.array(shown).reshape(-1, 9)), sorted_rows(np.array(placed).reshape(-1, 9)))
        self.assertEqual(sorted(merged.placed.tolist()), list(range(30)))

    def test_what_is_wrong_is_told(self):
        for mesh_of, transforms in [([1], np.eye(4)[None]), ([-1], np.eye(4)[None]), ([0], np.zeros((1, 3, 4)))]:
            with self.assertRaises(ValueError):
                fd.merge_instances([(INDICES, BUMPS)], mesh_of, transforms)
        with self.assertRaisesRegex(ValueError, "instances, 3, 4"):
            fd.merge_instances([(INDICES, BUMPS)], [0], np.eye(4))
        self.assertEqual(len(fd.merge_instances([], [], np.empty((0, 3, 4))).slots), 0)


class OneDraw(unittest.TestCase):
    def test_orders_are_those_of_the_functions(self):
        np.testing.assert_array_equal(fd.order("lookahead", INDICES, BUMPS), fd.lookahead(INDICES))
        places, indices = sheet(250)
        indices = indices[fd.lookahead(indices)] * 619 % len(places)  # numbers of vertices as they help no cache
        np.testing.assert_array_equal(fd.order("vertex-fetch", indices, places), fd.vertex_fetch(indices)[0])
        narrow, wide = INDICES.astype(np.uint16), np.zeros((len(BUMPS), 7), np.float32)
        wide[:, 2:5] = BUMPS
        np.testing.assert_array_equal(
            fd.order("tipsify, occlusion-order", narrow, wide[:, 2:5]), fd.order("tipsify, occlusion-order", INDICES, BUMPS)
        )
        order, offsets = fd.cluster("tipsify, linear-clusters", INDICES, BUMPS)
        np.testing.assert_array_equal(order, fd.tipsify(INDICES))
        np.testing.assert_array_equal(offsets, fd.linear_clusters(INDICES[order]))
        self.assertEqual(fd.order("lookahead", np.empty((0, 3), int), np.empty((0, 3))).shape, (0,))

    def test_techniques_of_ones_own_run(self):
        @fd.orderer("my-reversed")
        def reversed_order(draw):
            """Last triangles first."""
            return np.arange(len(draw.indices))[::-1]

        context = fd.Context()
        fd.add(reversed_order, context=context)
        order = fd.order("my-reversed", INDICES, BUMPS, context=context)
        np.testing.assert_array_equal(order, np.arange(len(INDICES))[::-1])

    def test_what_is_wrong_is_told(self):
        with self.assertRaisesRegex(fd.Error, "did you mean"):
            fd.order("tipsfy", INDICES, BUMPS)
        with self.assertRaisesRegex(fd.Error, "neither orders nor clusters"):
            fd.order("weld", INDICES, BUMPS)
        with self.assertRaisesRegex(fd.Error, "no stage clusters"):
            fd.cluster("tipsify", INDICES, BUMPS)


if __name__ == "__main__":
    unittest.main()
