"""Ten thousand calls leave no memory behind."""

import os
import unittest

import foredraw as fd
import numpy as np
from meshes import sheet

POSITIONS, INDICES = sheet(8)
DRAW = fd.Draw(INDICES, POSITIONS, {"NORMAL": POSITIONS})
PIPELINE = "pipeline = 1\nstages = ['tipsify']\nmeasure = ['vertex-cache']\n"


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Memory(unittest.TestCase):
    def assert_nothing_stays(self, call, calls, least_leak):
        """A leak of `least_leak` bytes a call shows."""
        for _ in range(calls // 4):  # whatever is made once
            call()
        before = resident()
        for _ in range(calls):
            call()
        self.assertLess(resident() - before, calls * least_leak)

    def test_of_functions(self):
        wide = INDICES.astype(np.int64)
        self.assert_nothing_stays(lambda: fd.tipsify(wide), 10_000, 100)
        self.assert_nothing_stays(lambda: fd.linear_clusters(INDICES), 10_000, 100)

    def test_of_mistakes(self):
        def call():
            try:
                fd.tipsify(INDICES, 3)
            except ValueError:
                pass

        self.assert_nothing_stays(call, 10_000, 100)

    def test_of_scenes_and_views(self):
        def call():
            draw = fd.make([DRAW]).draws[0]
            return draw.indices, draw.positions, draw.streams, draw.normalized

        self.assert_nothing_stays(call, 10_000, 200)

    def test_of_contexts(self):
        self.assert_nothing_stays(fd.Context, 100, 20_000)

    def test_of_runs(self):
        scene = fd.make([DRAW])

        def call():
            done = fd.optimize(scene, PIPELINE)
            return done.scene.moves(0), done.scene.draws[0].positions

        self.assert_nothing_stays(call, 400, 2_000)

    def test_of_files_that_are_none(self):
        def call():
            try:
                fd.read_bytes(b"glTF")
            except fd.Error:
                pass

        self.assert_nothing_stays(call, 10_000, 100)
