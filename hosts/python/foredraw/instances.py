"""Meshes with many instances, drawn by few calls."""

import ctypes
from ctypes import byref
from typing import Any, NamedTuple, Sequence, Tuple

import numpy as np

from . import _header as c
from ._arrays import address, count, positions, triangles
from ._library import library
from .functions import check, option

_SLOT = np.dtype([("index_offset", "u4"), ("instance", "u4")])
_DRAW = np.dtype([("group", "u4"), ("frequency", "u4"), ("first_slot", "u4"), ("slot_count", "u4")])
_GROUP = np.dtype([("least", "f4", 3), ("most", "f4", 3), ("first_instance", "u4"), ("instance_count", "u4")])


class Merged(NamedTuple):
    """Buffers that foredraw/runtime/merge_instances.h reads, and the draws."""

    indices: np.ndarray  #: uint32, into all meshes' vertices, one mesh's behind the other's
    slots: np.ndarray  #: index_offset, instance
    transforms: np.ndarray  #: (instances, 3, 4), float32
    placed: np.ndarray  #: [instance] which of those that were given
    draws: np.ndarray  #: group, frequency, first_slot, slot_count: slot_count * frequency vertices are drawn
    groups: np.ndarray  #: least, most, first_instance, instance_count: to be culled together


def merge_instances(
    meshes: Sequence[Tuple[Any, Any]],
    mesh_of: Any,
    transforms: Any,
    *,
    frequencies: int = 2,
    most_size: float = 0,
) -> Merged:
    """Merge meshes of one vertex layout, drawn with one shader, without a vertex stored twice.

    Persson: Graphics Gems for Games, SIGGRAPH 2012.

    Parameters
    ----------
    meshes : sequence of (indices, positions)
        Their vertices lie in one buffer, one mesh's behind the other's.
    mesh_of : array of integers, (instances,)
        Which mesh each instance shows.
    transforms : array of numbers, (instances, 3, 4) or (instances, 4, 4)
        What (x, y, z, 1) is multiplied with from the left.
    frequencies : int
        Different sizes of slots at most, 1 to 4.
    most_size : float
        Of a group's box, its longest side; 0: any.
    """
    given, first, kept = [], 0, []
    for indices, places in meshes:
        where, vertices = positions(places)
        mesh = triangles(indices, vertices)
        kept += [where, mesh]
        given.append(c.PackedMesh(mesh, where, count(first, "vertices"), 0))
        first += vertices
    matrices = np.asarray(transforms, np.float32)
    numbers = np.asarray(mesh_of)
    if matrices.ndim != 3 or matrices.shape[1:] not in ((3, 4), (4, 4)) or numbers.shape != matrices.shape[:1]:
        raise ValueError(
            f"transforms must be (instances, 3, 4) or (instances, 4, 4), and mesh_of (instances,), but they are "
            f"{matrices.shape} and {numbers.shape}"
        )
    placed = np.zeros(len(numbers), [("mesh", "u4"), ("transform", "f4", (3, 4))])
    if len(numbers) > 0:
        if numbers.dtype.kind not in "iu":
            raise TypeError(f"mesh_of must be integers, but is {numbers.dtype}")
        if numbers.min() < 0 or numbers.max() >= len(given):
            raise ValueError(f"mesh_of must be 0 to {len(given) - 1}")
        placed["mesh"], placed["transform"] = numbers, matrices[:, :3]
    merged = c.Merged()
    status = library().merge_instances(
        byref(merged), (c.PackedMesh * len(given))(*given), len(given),
        ctypes.cast(address(placed), ctypes.POINTER(c.PlacedMesh)), len(placed), option("frequencies", frequencies),
        float(most_size),
    )
    check(status, None, frequencies=frequencies, most_size=most_size)
    try:
        instances = merged.instance_count
        return Merged(
            _copy(merged.indices, merged.index_count, np.dtype(np.uint32)),
            _copy(merged.slots, merged.slot_count, _SLOT),
            _copy(merged.transforms, 12 * instances, np.dtype(np.float32)).reshape(-1, 3, 4),
            _copy(merged.placed, instances, np.dtype(np.uint32)),
            _copy(merged.draws, merged.draw_count, _DRAW),
            _copy(merged.groups, merged.group_count, _GROUP),
        )
    finally:
        library().merged_free(byref(merged))


def _copy(first: Any, length: int, dtype: np.dtype) -> np.ndarray:
    if length == 0:
        return np.empty(0, dtype)
    return np.frombuffer(ctypes.string_at(first, length * dtype.itemsize), dtype).copy()
