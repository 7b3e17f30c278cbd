"""Draws: triangles that are drawn at once. Those that a caller hands over, and those that a scene lends."""

import ctypes
from collections.abc import Sequence
from ctypes import byref, c_uint64, c_void_p, sizeof
from functools import cached_property
from typing import Any, Dict, FrozenSet, List, Mapping, NamedTuple, Optional, Union, overload

import numpy as np

from . import _header as c
from ._arrays import address, count, lent, rows_of_floats, triangles, without_gaps
from ._library import library
from ._texts import text_for_c

_COMPONENTS = {
    np.dtype(np.int8): c.INT8,
    np.dtype(np.uint8): c.UINT8,
    np.dtype(np.int16): c.INT16,
    np.dtype(np.uint16): c.UINT16,
    np.dtype(np.uint32): c.UINT32,
    np.dtype(np.float32): c.FLOAT32,
}
_TYPES = {number: dtype for dtype, number in _COMPONENTS.items()}


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


class LentDraw:
    """What a draw of a scene is now, at full detail. Arrays are read-only views of the scene, and keep it alive."""

    def __init__(self, handle: "Handle", number: int) -> None:
        self._handle = handle
        self._number = number

    @cached_property
    def _lent(self) -> Optional[c.Draw]:
        draw = c.Draw(size=sizeof(c.Draw))
        status = library().scene_draw(self._handle.pointer, self._number, byref(draw))
        if status == c.NO_MEMORY:
            raise MemoryError("memory ran out")
        return draw if status == c.DONE else None

    @property
    def has_triangles(self) -> bool:
        """False: it is a draw of lines or points, which has no arrays here."""
        return self._lent is not None

    @property
    def _triangles(self) -> c.Draw:
        if self._lent is None:
            raise ValueError(f"draw {self._number} is one of lines or points: ask has_triangles first")
        return self._lent

    @property
    def name(self) -> str:
        return (self._triangles.name or b"").decode(errors="replace")

    @property
    def vertex_count(self) -> int:
        return self._triangles.vertex_count

    @property
    def triangle_count(self) -> int:
        return self._triangles.triangle_count

    @property
    def indices(self) -> np.ndarray:
        """Array of uint32, (triangles, 3)."""
        return lent(self._handle, self._triangles.indices, np.uint32, (self.triangle_count, 3))

    @property
    def positions(self) -> np.ndarray:
        """Array of float32, (vertices, 3); quantised ones are decoded."""
        return lent(self._handle, self._triangles.positions, np.float32, (self.vertex_count, 3))

    @property
    def streams(self) -> Dict[str, np.ndarray]:
        """By semantic: what else vertices have, (vertices, components), in the types in which it is stored."""
        return {stream.semantic.decode(): self._array(stream) for stream in self._streams()}

    @property
    def normalized(self) -> FrozenSet[str]:
        """The streams whose integers mean 0 to 1, or -1 to 1."""
        return frozenset(stream.semantic.decode() for stream in self._streams() if stream.normalized)

    def _streams(self) -> list:
        draw = self._triangles
        return draw.streams[: draw.stream_count] if draw.stream_count else []

    def _array(self, stream: c.Stream) -> np.ndarray:
        shape = self.vertex_count, stream.components
        return lent(self._handle, stream.bytes, _TYPES[stream.component], shape, stream.stride)

    def __repr__(self) -> str:
        if not self.has_triangles:
            return "<foredraw draw of lines or points>"
        return f"<foredraw draw {self.name!r}: {self.triangle_count} triangles, {self.vertex_count} vertices>"


class Handle:
    """A scene of the library's, which is freed with the last who keeps this."""

    def __init__(self, pointer: int) -> None:
        self.pointer = pointer
        self._free = library().scene_free

    def __del__(self) -> None:
        self._free(self.pointer)

    def __reduce__(self) -> Any:
        raise TypeError("a scene stays in its process; write it to a file, and read that in the other")


class Draws(Sequence[LentDraw]):
    """The draws of a scene by number."""

    def __init__(self, handle: Handle) -> None:
        self._handle = handle

    def __len__(self) -> int:
        return library().scene_draws(self._handle.pointer)

    @overload
    def __getitem__(self, number: int) -> LentDraw: ...

    @overload
    def __getitem__(self, number: slice) -> List[LentDraw]: ...

    def __getitem__(self, number: Union[int, slice]) -> Union[LentDraw, List[LentDraw]]:
        wanted = range(len(self))[number]
        if isinstance(wanted, range):
            return [LentDraw(self._handle, one) for one in wanted]
        return LentDraw(self._handle, wanted)

    def __repr__(self) -> str:
        return repr(list(self))


class Moves(NamedTuple):
    """Where triangles and vertices of a draw went. None: all are as they were."""

    triangles: Optional[np.ndarray]  #: of uint32: ``triangles[new] = old``
    vertices: Optional[np.ndarray]  #: of uint32: ``vertices[old] = new``, or 0xffffffff where it was left out


def moves_of(handle: Handle, number: int) -> Moves:
    triangles_at, vertices_at, vertex_count = c_void_p(), c_void_p(), c_uint64()
    out = byref(triangles_at), byref(vertices_at), byref(vertex_count)
    library().scene_moves(handle.pointer, number, *out)

    def array(first: c_void_p, length: int) -> Optional[np.ndarray]:
        return lent(handle, first.value, np.uint32, (length,)) if first.value else None

    triangle_count = LentDraw(handle, number).triangle_count if triangles_at.value else 0
    return Moves(array(triangles_at, triangle_count), array(vertices_at, vertex_count.value))


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
    if array.dtype not in _COMPONENTS:
        types = ", ".join(str(dtype) for dtype in _COMPONENTS)
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
        component=_COMPONENTS[array.dtype],
        components=count(array.shape[1], "components"),
        normalized=semantic in given.normalized,
    )
    made.array = array
    return made
