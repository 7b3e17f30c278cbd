"""Draws that a caller hands over, to make a scene of."""

import ctypes
from ctypes import sizeof
from typing import Any, FrozenSet, Mapping, Optional

import numpy as np

from . import _header as c
from ._arrays import address, count, rows_of_floats, triangles, without_gaps
from ._texts import text_for_c

COMPONENTS = {
    np.dtype(np.int8): c.INT8,
    np.dtype(np.uint8): c.UINT8,
    np.dtype(np.int16): c.INT16,
    np.dtype(np.uint16): c.UINT16,
    np.dtype(np.uint32): c.UINT32,
    np.dtype(np.float32): c.FLOAT32,
}


class Draw:
    """Triangles to make a scene of: :func:`make`.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    positions : array of numbers, (vertices, 3)
    streams : mapping, optional
        Further attributes of the vertices by glTF's words for them, "NORMAL", "TEXCOORD_0", "_MINE": arrays of shape
        (vertices, components) or (vertices,), of int8, uint8, int16, uint16, uint32 or floats.
    name : str, optional
        What reports call it.
    normalized : set of str, optional
        The streams whose integers mean 0 to 1, or -1 to 1.
    """

    def __init__(
        self,
        indices: Any,
        positions: Any,
        streams: Optional[Mapping[str, Any]] = None,
        name: Optional[str] = None,
        normalized: FrozenSet[str] = frozenset(),
    ) -> None:
        self.indices = indices
        self.positions = positions
        self.streams = streams or {}
        self.name = name
        self.normalized = normalized


def draw_for_c(given: Any) -> c.Draw:
    """Of a Draw or a LentDraw; it keeps the arrays that it points to, as `arrays`."""
    mesh = triangles(given.indices)
    indices = mesh.array.astype(np.uint32, copy=False)
    positions = np.ascontiguousarray(rows_of_floats(given.positions, "positions"))
    streams = [_stream_for_c(name, values, given, len(positions)) for name, values in given.streams.items()]
    row = (c.Stream * len(streams))(*streams)
    name = None if given.name is None else text_for_c(given.name, "a name")
    made = c.Draw(
        size=sizeof(c.Draw),
        vertex_count=count(len(positions), "the number of vertices"),
        triangle_count=indices.size // 3,
        name=name,
        indices=address(indices),
        positions=address(positions),
        stream_count=len(streams),
        streams=ctypes.cast(row, ctypes.POINTER(c.Stream)),
    )
    made.arrays = indices, positions, streams, row, name
    return made


def _stream_for_c(semantic: str, values: Any, given: Any, vertex_count: int) -> c.Stream:
    array = np.asarray(values)
    if array.dtype.kind == "f":
        with np.errstate(over="ignore"):
            array = array.astype(np.float32, copy=False)
    array = array.astype(array.dtype.newbyteorder("="), copy=False)
    if array.dtype not in COMPONENTS:
        types = ", ".join(str(dtype) for dtype in COMPONENTS)
        raise TypeError(f"{semantic} must be of one of the types {types}, but is of {array.dtype}")
    if array.ndim == 1:
        array = array.reshape(-1, 1)
    if array.ndim != 2 or len(array) != vertex_count:
        raise ValueError(f"{semantic} must have the shape ({vertex_count}, components), but has {np.shape(values)}")
    array = without_gaps(array)
    made = c.Stream(
        semantic=text_for_c(semantic, "a semantic"),
        bytes=address(array),
        stride=array.strides[0] if len(array) else 0,
        component=COMPONENTS[array.dtype],
        components=count(array.shape[1], "components"),
        normalized=semantic in given.normalized,
    )
    made.array = array
    return made
