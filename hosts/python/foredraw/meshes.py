"""Meshes made smaller, and what is drawn of them: weld, simplification, overdraw, on arrays.

Arrays, and what is wrong with them: as of the functions of functions.py.
"""

from ctypes import byref, c_uint32
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _header as c
from ._arrays import address, count, numbers, positions, triangles, without_gaps
from ._library import library
from .functions import as_given, check, choice, option

_QUALITIES = {"fast": c.OCCLUSION_FAST, "balanced": c.OCCLUSION_BALANCED, "high": c.OCCLUSION_HIGH}


def occlusion_order(
    indices: Any,
    positions_of_vertices: Any,
    *,
    quality: str = "balanced",
    acmr_budget: float = 1.05,
    cache_size: int = 16,
    shows_back_faces: bool = False,
) -> np.ndarray:
    """Order triangles so that what hides most is drawn first, as seen from 80 sides.

    The triangles as they stand should suit the vertex cache (:func:`lookahead`): they are moved in small groups.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    positions_of_vertices : array of numbers, (vertices, 3)
    quality : {"fast", "balanced", "high"}
    acmr_budget : float
        Misses of the vertex cache at most, as a multiple of what there are, at least 1.
    cache_size : int
        Entries of a FIFO cache, 3 to 65535.
    shows_back_faces : bool

    Returns
    -------
    order : array of uint32, (n,)
    """
    mesh, places = _mesh(indices, positions_of_vertices)
    order = np.empty(mesh.index_count // 3, np.uint32)
    wanted = choice("quality", quality, _QUALITIES)
    if acmr_budget == 0:
        raise ValueError("acmr_budget must not be 0")
    status = library().occlusion_order(
        address(order), byref(mesh), byref(places), wanted, float(acmr_budget), option("cache_size", cache_size),
        bool(shows_back_faces),
    )
    check(status, mesh, acmr_budget=acmr_budget, cache_size=cache_size)
    return order


class Welded(NamedTuple):
    """Vertices made one."""

    indices: np.ndarray  #: into the vertices that are kept, in the type and shape of what was given
    kept: np.ndarray  #: [new vertex] = old one: ``attribute[kept]`` is what is left of an attribute
    destination: np.ndarray  #: [old vertex] = new one, 0xffffffff where it went


def weld(indices: Any, *attributes: Any, keep_unused: bool = False) -> Welded:
    """Make one of vertices that are equal in every byte of all attributes; the first of equals stays.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    attributes : arrays of any type, (vertices, ...)
    keep_unused : bool
        Keep vertices that no triangle uses.
    """
    if not attributes:
        raise ValueError("there must be an attribute")
    rows = [np.ascontiguousarray(attribute) for attribute in attributes]
    for row in rows:
        if row.dtype.hasobject:
            raise TypeError(f"attributes must be plain memory, but one is {row.dtype}")
        if row.ndim == 0 or len(row) != len(rows[0]):
            raise ValueError(f"attributes must be as long as each other, but have {[np.shape(r) for r in rows]}")
    vertices = len(rows[0])
    mesh = triangles(indices, vertices)
    sizes = [row.dtype.itemsize * int(np.prod(row.shape[1:])) for row in rows]
    given = (c.Attribute * len(rows))(*[c.Attribute(address(row), 0, size) for row, size in zip(rows, sizes)])
    destination, kept, left = np.empty(vertices, np.uint32), np.empty(vertices, np.uint32), c_uint32()
    status = library().weld(
        address(destination), address(kept), byref(left), byref(mesh), given, len(rows), bool(keep_unused)
    )
    check(status, mesh, bytes=sizes)
    return Welded(move_vertices(indices, destination), kept[: left.value].copy(), destination)


def move_vertices(indices: Any, destination: Any) -> np.ndarray:
    """The indices after their vertices went there: ``destination[indices]``, checked, in the type and shape given."""
    where = numbers(destination, "the destination")
    mesh = triangles(indices, len(where))
    made = np.empty_like(mesh.array)
    check(library().move_vertices(address(made), byref(mesh), address(where)), mesh)
    return as_given(made, indices)


class Collapses:
    """A mesh made coarser edge by edge: :func:`quadric_collapse` makes it, :func:`simplify` cuts levels out of it."""

    def __init__(self, vertices: int, moves: bool, solves: bool = False) -> None:
        room = max(vertices, 1)
        self.collapses = np.zeros(room, [("removed", "u4"), ("kept", "u4"), ("blend", "f4"), ("error", "f4")])
        self.pairs = np.zeros(room, [("removed", "u4"), ("kept", "u4")])
        self.first_pair = np.zeros(room + 1, np.uint32)
        self.places = np.zeros((room, 3), np.float32) if moves else None
        self._arrays = c.Collapses(
            address(self.collapses),
            address(self.pairs),
            address(self.first_pair),
            None if self.places is None else address(self.places),
            0,
            solves,
        )

    def __len__(self) -> int:
        return self._arrays.count


#: An array, its weight, and, if it is one, that it is a "direction" or always "blended".
Weighted = Union[Tuple[Any, float], Tuple[Any, float, str]]


def quadric_collapse(
    indices: Any,
    positions_of_vertices: Any,
    attributes: Sequence[Weighted] = (),
    *,
    moves: bool = False,
    solves: bool = True,
    least: int = 0,
) -> Collapses:
    """The edges of a mesh in the sequence in which it costs least to collapse them.

    Hoppe: Progressive Meshes, SIGGRAPH 1996; costs after Garland and Heckbert 1997, Lindstrom and Turk 1998, Hoppe
    1999.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    positions_of_vertices : array of numbers, (vertices, 3)
    attributes : sequence of (array, weight) or (array, weight, kind), optional
        What counts beside distances, of shape (vertices,) or (vertices, components): a difference times the weight is
        a length. The kind "direction" is for three numbers that point somewhere, of length 1, and a fourth that is a
        sign; "blended" for what moves vertices, such as joint weights, which all vertices of a point share.
    moves : bool
        Points may move to where the cost is least. Otherwise all levels use the vertices that there are.
    solves : bool
        What vertices carry where points move is solved for from the triangles around; otherwise it is blended along
        the edge. :func:`level_attributes` tells it.
    least : int
        Triangles to stop at.
    """
    mesh, places = _mesh(indices, positions_of_vertices)
    weighted = _Weighted(attributes, mesh.vertex_count)
    made = Collapses(mesh.vertex_count, moves, solves)
    status = library().quadric_collapse(
        byref(made._arrays), byref(mesh), byref(places), weighted.given, len(weighted.given), count(least, "least")
    )
    check(status, mesh, attributes=weighted.told)
    return made


class _Weighted:
    """Attributes for C, and the arrays that they point to."""

    def __init__(self, attributes: Sequence[Weighted], vertices: int) -> None:
        self.rows, given = [], []
        for values, weight, *kind in attributes:
            row = np.asarray(values, np.float32)
            row = without_gaps(row.reshape(-1, 1) if row.ndim == 1 else row)
            if row.ndim != 2 or len(row) != vertices:
                raise ValueError(f"an attribute must have a row for each of {vertices} vertices: {row.shape}")
            self.rows.append(row)
            stride = row.strides[0] if len(row) else 0
            given.append(c.WeightedAttribute(address(row), stride, row.shape[1] + _kind(*kind), float(weight)))
        self.given = (c.WeightedAttribute * len(given))(*given)
        self.told = [(row.shape[1], *rest) for row, (_, *rest) in zip(self.rows, attributes)]


def _kind(kind: str = "") -> int:
    kinds = {"": 0, "direction": c.DIRECTION, "blended": c.BLENDED}
    if kind not in kinds:
        raise ValueError(f'an attribute is a "direction", "blended", or neither, not {kind!r}')
    return kinds[kind]


def shell_kinds(indices: Any, positions_of_vertices: Any) -> np.ndarray:
    """What the shell of each triangle is, for passes that draw back faces alone: who stands outside of a closed one sees
    no back face before a front one.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    positions_of_vertices : array of numbers, (vertices, 3)

    Returns
    -------
    kinds : array of uint8, (n,)
        0: closed and right side out; 1: open; 2: flat; 3: inside out; 4: a part of it shows its back.
    """
    mesh, places = _mesh(indices, positions_of_vertices)
    kinds = np.empty(mesh.index_count // 3, np.uint8)
    check(library().shell_kinds(address(kinds), byref(mesh), byref(places)), mesh)
    return kinds


class Simplified(NamedTuple):
    """A level that was cut out."""

    indices: np.ndarray  #: (n, 3), in the type of what was given
    positions: np.ndarray  #: (vertices, 3), float32: of all vertices, where they lie then
    collapses: int  #: that were done
    error: float  #: proved: no point of either surface is farther from the other


def simplify(
    indices: Any,
    positions_of_vertices: Any,
    collapses: Optional[Collapses] = None,
    *,
    triangles_left: int = 0,
    error: float = float("inf"),
) -> Simplified:
    """Leave as few triangles as are asked for, or more where that would exceed an error.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    positions_of_vertices : array of numbers, (vertices, 3)
    collapses : Collapses, optional
        Of the same mesh; :func:`quadric_collapse` where it is not given. Who wants several levels gives it.
    triangles_left : int
    error : float
        The largest distance of the two surfaces, either way, in units of the positions.
    """
    sequence = quadric_collapse(indices, positions_of_vertices) if collapses is None else collapses
    mesh, places = _mesh(indices, positions_of_vertices)
    _check_fits(sequence, mesh)
    few = np.empty(mesh.index_count, mesh.array.dtype)
    moved = np.empty((mesh.vertex_count, 3), np.float32)
    made = c.Simplified()
    status = library().simplify(
        address(few), address(moved), byref(made), byref(mesh), byref(places), byref(sequence._arrays),
        count(triangles_left, "triangles_left"), float(error),
    )
    check(status, mesh, error=error)
    level = few[: made.index_count].reshape(-1, 3).copy()
    return Simplified(as_given(level, indices), moved, made.collapses, made.error)


def level_attributes(
    indices: Any,
    positions_of_vertices: Any,
    collapses: Collapses,
    done: int,
    attributes: Sequence[Weighted],
) -> List[np.ndarray]:
    """What vertices carry in a level that was cut out of a sequence.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    positions_of_vertices : array of numbers, (vertices, 3)
    collapses : Collapses
        Of the same mesh.
    done : int
        How many of them: :attr:`Simplified.collapses`.
    attributes : sequence of (array, weight) or (array, weight, kind)
        As of :func:`quadric_collapse`, and others; weights do not count.

    Returns
    -------
    values : list of arrays of float32, of shape (vertices, components)
        One for each attribute. A vertex that no triangle has any more carries what it did.
    """
    mesh, places = _mesh(indices, positions_of_vertices)
    _check_fits(collapses, mesh)
    weighted = _Weighted(attributes, mesh.vertex_count)
    widths = [row.shape[1] for row in weighted.rows]
    made = np.empty((mesh.vertex_count, sum(widths)), np.float32)
    status = library().level_attributes(
        address(made), byref(mesh), byref(places), byref(collapses._arrays), count(done, "done"), weighted.given,
        len(weighted.given),
    )
    check(status, mesh, done=done, attributes=weighted.told)
    ends = np.cumsum(widths, dtype=int)
    return [made[:, end - width : end].copy() for end, width in zip(ends, widths)]


def _check_fits(collapses: Collapses, mesh: c.Triangles) -> None:
    if len(collapses.first_pair) != max(mesh.vertex_count, 1) + 1:
        raise ValueError(f"the collapses are of another mesh than this one of {mesh.vertex_count} vertices")


class Overdraw(NamedTuple):
    """What is drawn of triangles as they stand and does not stay."""

    shaded: int  #: fragments that pass the depth test, over all views
    visible: int  #: fragments that stay
    ties: int  #: fragments equally near as what was there before them
    ratio: float  #: shaded / visible: 1 at best
    error: float  #: its standard error
    worst_view: float  #: the highest ratio of a view


def overdraw(
    indices: Any,
    positions_of_vertices: Any,
    *,
    views: int = 100,
    size: int = 256,
    shows_back_faces: bool = False,
) -> Overdraw:
    """Draw the triangles from `views` sides all round, into pictures of `size` x `size` pixels, and count."""
    mesh, places = _mesh(indices, positions_of_vertices)
    figures = c.OverdrawFigures()
    status = library().overdraw(
        byref(figures), byref(mesh), byref(places), option("views", views), option("size", size),
        bool(shows_back_faces),
    )
    check(status, mesh, views=views, size=size)
    return Overdraw(*[getattr(figures, name) for name in Overdraw._fields])


class SurfaceError(NamedTuple):
    """How far a surface lies from another one, in units of the positions."""

    largest: float  #: proved: no point of either surface is farther from the other
    found: float  #: a point is so far away
    rms: float  #: root of the mean square, both ways, by area
    rms_error: float  #: its standard error
    mean: float
    mean_error: float
    p99: float  #: 99 of 100 points are no farther
    p99_error: float


def surface_error(
    indices: Any,
    positions_of_vertices: Any,
    original_indices: Any,
    original_positions: Any,
    *,
    samples: int = 10000,
    seed: int = 0,
) -> SurfaceError:
    """How far a surface lies from the one that it stands for, by `samples` points on each, and proved."""
    changed, places = _mesh(indices, positions_of_vertices)
    original, original_places = _mesh(original_indices, original_positions)
    figures = c.SurfaceErrorFigures()
    status = library().surface_error(
        byref(figures), byref(changed), byref(places), byref(original), byref(original_places),
        option("samples", samples), seed,
    )
    if status == c.NO_TRANSFORM:
        raise ValueError("one of the surfaces has no triangle with finite positions")
    check(status, None, samples=samples)
    return SurfaceError(*[getattr(figures, name) for name in SurfaceError._fields])


def _mesh(indices: Any, positions_of_vertices: Any) -> Tuple[c.Triangles, c.Positions]:
    places, vertices = positions(positions_of_vertices)
    return triangles(indices, vertices), places
