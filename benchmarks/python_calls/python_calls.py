#!/usr/bin/python3
"""What calls from Python cost beside the same calls in C: of two triangles, and of a million.

    FOREDRAW_LIBRARY=libforedraw.so.1 PYTHONPATH=hosts/python benchmarks/python_calls/python_calls.py

Debian's python3, for the sake of its numpy. Each time is the least of many batches, so that other work on the machine
hardly shows. "Bare" is the C function by ctypes with everything prepared: what is above it is the package.
"""

import tracemalloc
from ctypes import byref, c_uint32
from timeit import repeat

import foredraw as fd
import numpy as np
from foredraw import _arrays, _header
from foredraw._library import library


def least(call, times=100, batches=300):
    """Microseconds."""
    return min(repeat(call, number=times, repeat=batches)) / times * 1e6


def sheet(cells):
    """Triangles of a sheet of so many cells along each side, in a random sequence."""
    side = cells + 1
    corner = (np.arange(cells * cells) // cells * side + np.arange(cells * cells) % cells)[:, None]
    triangles = np.concatenate([corner + [0, 1, side], corner + [side, 1, side + 1]])
    return np.random.default_rng(1).permutation(triangles).astype(np.uint32)


def bare_calls(indices):
    """The C functions on the same memory, by name."""
    mesh = _arrays.triangles(indices)
    answer = np.empty(max(len(indices), mesh.vertex_count) + 1, np.uint32)
    used, figures = c_uint32(), _header.VertexCacheFigures()
    room, c = _arrays.address(answer), library()
    return answer, {
        "tipsify": lambda: c.tipsify(room, byref(mesh), 16),
        "forsyth": lambda: c.forsyth(room, byref(mesh), 32),
        "lookahead": lambda: c.lookahead(room, byref(mesh), 2, 1, 16),
        "linear_clusters": lambda: c.linear_clusters(room, byref(used), byref(mesh), 16, 1.05),
        "vertex_fetch": lambda: c.vertex_fetch(room, byref(used), byref(mesh)),
        "vertex_cache": lambda: c.vertex_cache(byref(figures), byref(mesh), 16),
    }


def print_small():
    indices = np.array([[0, 1, 2], [2, 1, 3]], np.uint32)
    wide = indices.astype(np.int64)
    kept, bare = bare_calls(indices)
    print("two triangles, us       | bare | uint32 | int64")
    for name, call in bare.items():
        ours = getattr(fd, name)
        print(f"{name:24}| {least(call):4.1f} | {least(lambda: ours(indices)):6.1f} | {least(lambda: ours(wide)):5.1f}")
    draw = fd.make([fd.Draw(indices, np.zeros((4, 3)))]).draws[0]
    print(f"{'a view of a scene':24}|      | {least(lambda: draw.indices):6.1f} |")


def print_million():
    indices = sheet(708)[:1_000_000]
    kept, bare = bare_calls(indices)
    forms = {"uint32": indices, "int32": indices.view(np.int32), "int64": indices.astype(np.int64)}
    print("\na million triangles     | bare, ms | uint32 | int32 | int64, times that")
    for name in ["tipsify", "linear_clusters", "vertex_fetch", "vertex_cache"]:
        ours = getattr(fd, name)
        calls = [bare[name], *(lambda form=form: ours(form) for form in forms.values())]
        rounds = [[least(call, 1, 1) for call in calls] for _ in range(15)]
        times = [min(column) for column in zip(*rounds)]
        parts = " | ".join(f"{time / times[0]:5.2f}" for time in times[1:])
        print(f"{name:24}| {times[0] / 1000:8.1f} |  {parts}")
    print("\nmost memory of tipsify, MB beyond its answer (indices have 12, or 24)")
    for name, form in forms.items():
        tracemalloc.start()
        answer = fd.tipsify(form)
        print(f"{name:24}| {(tracemalloc.get_traced_memory()[1] - answer.nbytes) / 1e6:5.2f}")
        tracemalloc.stop()


print_small()
print_million()
