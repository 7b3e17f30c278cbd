"""Meshes and files that several tests need."""

import os
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
SPOT = ROOT / "benchmarks/corpus/static/spot.glb"
HELMET = ROOT / "benchmarks/corpus/static/flight_helmet_notex.glb"  # whose @default takes seconds
PROGRAM = os.environ.get("FOREDRAW_PROGRAM", "")


def sheet(cells):
    """Positions and triangles, (n, 3), of a bent sheet of so many cells along each side, in a random sequence."""
    side = cells + 1
    y, x = np.divmod(np.arange(side * side), side)
    positions = np.stack([x, y, x * y % 7], axis=1).astype(np.float32)
    corner = (np.arange(cells * cells) // cells * side + np.arange(cells * cells) % cells)[:, None]
    triangles = np.concatenate([corner + [0, 1, side], corner + [side, 1, side + 1]])
    return positions, np.random.default_rng(7).permutation(triangles).astype(np.uint32)


def sorted_rows(array):
    """Whichever sequence rows are in."""
    return array[np.lexsort(array.T)]
