"""Processes that multiprocessing starts, in either way, make what this one makes."""

import multiprocessing
import unittest

import foredraw as fd
import numpy as np
from meshes import SPOT, sheet

_, INDICES = sheet(30)


def work(path):
    """In another process: a function, and a run on several threads."""
    done = fd.optimize(fd.read(path), "weld, lookahead, vertex-fetch")
    return fd.tipsify(INDICES), done.scene.draws[0].indices.copy(), done.report["totals"]


def fails(path):
    fd.optimize(fd.read(path), "tipsfy")


class Processes(unittest.TestCase):
    def assert_same(self, method):
        mine = work(SPOT)  # first: a forked process has what this one's library has begun
        with multiprocessing.get_context(method).Pool(2) as pool:
            for theirs in pool.map_async(work, [SPOT, SPOT, SPOT]).get(60):
                np.testing.assert_array_equal(theirs[0], mine[0])
                np.testing.assert_array_equal(theirs[1], mine[1])
                self.assertEqual(theirs[2], mine[2])
            with self.assertRaisesRegex(fd.Error, "did you mean 'tipsify'") as caught:
                pool.apply_async(fails, [SPOT]).get(60)
            self.assertEqual(caught.exception.diagnostics[0]["code"], "unknown-plugin")

    def test_that_are_forked(self):
        self.assert_same("fork")

    def test_that_are_spawned(self):
        self.assert_same("spawn")

    def test_that_are_forked_may_leave_what_they_inherit(self):
        scene, context = fd.read(SPOT), fd.Context(threads=2)
        before = scene.draws[0].indices.sum()
        child = multiprocessing.get_context("fork").Process(target=leaves, args=([scene, context],))
        del context
        child.start()
        child.join(60)
        self.assertEqual(child.exitcode, 0)
        self.assertEqual(scene.draws[0].indices.sum(), before)


def leaves(inherited):
    scene = inherited[0]
    fd.optimize(scene, "tipsify", context=inherited[1])
    inherited.clear()
