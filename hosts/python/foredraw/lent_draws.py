"""Draws as a scene lends them: views of its memory, which keep it alive."""

from collections.abc import Sequence
from ctypes import byref, c_uint64, c_void_p, sizeof
from functools import cached_property
from typing import Any, Dict, FrozenSet, List, NamedTuple, Optional, Union, overload

import numpy as np

from . import _header as c
from ._arrays import lent
from ._library import library
from .given_draws import COMPONENTS

_TYPES = {number: dtype for dtype, number in COMPONENTS.items()}


class Handle:
    """A scene of the library's, which is freed with the last who keeps this."""

    def __init__(self, pointer: int) -> None:
        self.pointer = pointer
        self._free = library().scene_free

    def __del__(self) -> None:
        self._free(self.pointer)

    def __reduce__(self) -> Any:
        raise TypeError("a scene stays in its process; write it to a file, and read the file in the other process")


class LentDraw:
    """What a draw of a scene is now, at full detail. Arrays are read-only views of the scene, and keep it alive."""

    def __init__(self, handle: Handle, number: int) -> None:
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
