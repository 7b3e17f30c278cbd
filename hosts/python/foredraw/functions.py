"""The plain functions: orders of triangles and vertices, clusters, figures, on arrays.

Indices are of the shape (n, 3) or (3 n,) and of any integer type. Those of 1, 2 or 4 bytes, one behind the other, are
taken in place; others are copied. `vertex_count` is the largest index plus one where it is not given. An order is
``order[new] = old``. What is wrong with an array is a ValueError, or a TypeError.
"""

from ctypes import byref, c_uint32
from typing import Any, Dict, NamedTuple, Optional, Tuple

import numpy as np

from . import _header as c
from ._arrays import LARGEST, address, count, numbers, positions, triangles
from ._library import library

_QUALITIES = {"fast": c.LOOKAHEAD_FAST, "balanced": c.LOOKAHEAD_BALANCED, "high": c.LOOKAHEAD_HIGH}
_TARGETS = {
    "robust": c.LOOKAHEAD_ROBUST,
    "fifo": c.LOOKAHEAD_FIFO,
    "nvidia": c.LOOKAHEAD_NVIDIA,
    "amd": c.LOOKAHEAD_AMD,
    "intel": c.LOOKAHEAD_INTEL,
}


def tipsify(indices: Any, vertex_count: Optional[int] = None, *, cache_size: int = 16) -> np.ndarray:
    """Order triangles for a FIFO vertex cache; the fastest.

    Sander, Nehab and Barczak: Fast Triangle Reordering for Vertex Locality and Reduced Overdraw, SIGGRAPH 2007,
    section 3.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    vertex_count : int, optional
    cache_size : int
        Entries of the cache, 3 or more.

    Returns
    -------
    order : array of uint32, (n,)
    """
    return _order(library().tipsify, indices, vertex_count, option("cache_size", cache_size))


def forsyth(indices: Any, vertex_count: Optional[int] = None, *, cache_size: int = 32) -> np.ndarray:
    """Order triangles for caches of any kind up to about `cache_size` entries, 3 to 64.

    Forsyth: Linear-Speed Vertex Cache Optimisation, 2006. Parameters and result: as of :func:`tipsify`.
    """
    return _order(library().forsyth, indices, vertex_count, option("cache_size", cache_size))


def lookahead(
    indices: Any,
    vertex_count: Optional[int] = None,
    *,
    quality: str = "balanced",
    target: str = "robust",
    cache_size: int = 16,
) -> np.ndarray:
    """Order triangles for the fewest misses of the vertex cache: fans are drawn on trial.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    vertex_count : int, optional
    quality : {"fast", "balanced", "high"}
    target : {"robust", "fifo", "nvidia", "amd", "intel"}
        "fifo" is for a FIFO of `cache_size` alone, "robust" for it and no worse than tipsify in others; the rest are
        for batches as these GPUs shade them.
    cache_size : int
        Entries of the cache, 3 to 256.

    Returns
    -------
    order : array of uint32, (n,)
    """
    chosen = choice("quality", quality, _QUALITIES), choice("target", target, _TARGETS)
    return _order(library().lookahead, indices, vertex_count, *chosen, option("cache_size", cache_size))


def linear_clusters(
    indices: Any, vertex_count: Optional[int] = None, *, cache_size: int = 16, growth: float = 1.05
) -> np.ndarray:
    """Cut the triangles, as they stand, into clusters where that costs few misses.

    Sander, Nehab and Barczak 2007, section 4.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    vertex_count : int, optional
    cache_size : int
        Entries of a FIFO cache, 3 or more.
    growth : float
        How many times a patch's own misses per triangle a cluster may have, at least 1.

    Returns
    -------
    offsets : array of uint32
        Cluster i holds the triangles ``offsets[i]`` to ``offsets[i + 1] - 1``.
    """
    mesh = triangles(indices, vertex_count)
    room = np.empty(mesh.index_count // 3 + 1, np.uint32)
    clusters = c_uint32()
    size = option("cache_size", cache_size)
    if growth == 0:
        raise ValueError("growth must not be 0")
    status = library().linear_clusters(address(room), byref(clusters), byref(mesh), size, float(growth))
    check(status, mesh, cache_size=cache_size, growth=growth)
    return room[: clusters.value + 1].copy()


def dot_rule(indices: Any, positions_of_vertices: Any, offsets: Any) -> np.ndarray:
    """The sequence of the clusters that draws outward faces first, so that what they hide is not shaded.

    Sander, Nehab and Barczak 2007, section 5.

    Parameters
    ----------
    indices : array of integers, (n, 3) or (3 n,)
    positions_of_vertices : array of numbers, (vertices, 3)
        Floats of 32 bits are taken in place, also within an interleaved array. They may be infinite or no numbers.
    offsets : array of integers
        As :func:`linear_clusters` makes them.

    Returns
    -------
    sequence : array of uint32
        ``sequence[new] = old`` cluster; :func:`order_of_clusters` makes an order of triangles of it.
    """
    places, vertex_count = positions(positions_of_vertices)
    mesh = triangles(indices, vertex_count)
    begins = numbers(offsets, "offsets")
    clusters = max(len(begins) - 1, 0)
    sequence = np.empty(clusters, np.uint32)
    status = library().dot_rule(address(sequence), byref(mesh), byref(places), address(begins), clusters)
    check(status, mesh)
    return sequence


def order_of_clusters(offsets: Any, sequence: Any) -> np.ndarray:
    """The order of the triangles in which the clusters are drawn in that sequence: array of uint32."""
    begins, clusters = numbers(offsets, "offsets"), numbers(sequence, "the sequence")
    if len(begins) != len(clusters) + 1:
        raise ValueError(f"{len(clusters)} clusters have {len(clusters) + 1} offsets, but there are {len(begins)}")
    if begins[0] != 0 or (begins[1:] <= begins[:-1]).any():  # before memory is asked for by them
        raise ValueError(_text(c.NO_CLUSTERS))
    order = np.empty(int(begins[-1]), np.uint32)
    check(library().order_of_clusters(address(order), address(begins), len(clusters), address(clusters)))
    return order


def vertex_fetch(indices: Any, vertex_count: Optional[int] = None) -> Tuple[np.ndarray, int]:
    """The order of the vertices by first use, array of uint32, and how many are used; the others come last."""
    mesh = triangles(indices, vertex_count)
    order = np.empty(mesh.vertex_count, np.uint32)
    used = c_uint32()
    check(library().vertex_fetch(address(order), byref(used), byref(mesh)), mesh)
    return order, used.value


def reorder_triangles(indices: Any, order: Any) -> np.ndarray:
    """The indices in that order of their triangles, in a new array of the same type and shape."""
    mesh = triangles(indices, LARGEST)
    wanted = numbers(order, "the order")
    if len(wanted) != mesh.index_count // 3:
        raise ValueError(f"the order has {len(wanted)} entries, but there are {mesh.index_count // 3} triangles")
    made = np.empty_like(mesh.array)
    check(library().reorder_triangles(address(made), byref(mesh), address(wanted)), mesh)
    return as_given(made, indices)


def renumber_vertices(indices: Any, order: Any) -> np.ndarray:
    """The indices after their vertices took that order, which names each once, in a new array of the same type."""
    wanted = numbers(order, "the order")
    mesh = triangles(indices, len(wanted))
    made = np.empty_like(mesh.array)
    check(library().renumber_vertices(address(made), byref(mesh), address(wanted)), mesh)
    return as_given(made, indices)


def reorder_elements(elements: Any, order: Any) -> np.ndarray:
    """``elements[order]``, of vertices say, where the order names each once at most, and may leave some out.

    Parameters
    ----------
    elements : array of any type, (n, ...)
    order : array of integers
        Of vertex_fetch(), say; with ``order[:used]`` the vertices that nobody uses are left out.

    Returns
    -------
    array of the same type, (len(order), ...)
    """
    given = np.ascontiguousarray(elements)
    wanted = numbers(order, "the order")
    if given.dtype.hasobject:
        raise TypeError(f"elements must be numbers or structs of numbers, but are {given.dtype}")
    made = np.empty((len(wanted), *given.shape[1:]), given.dtype)
    size = count(given.dtype.itemsize * int(np.prod(given.shape[1:])), "bytes of an element")
    reorder = library().reorder_elements
    check(reorder(address(made), address(given), len(given), size, address(wanted), len(wanted)))
    return made


class VertexCache(NamedTuple):
    """What a vertex cache makes of triangles as they stand."""

    misses: int  #: vertices shaded
    vertices: int  #: different ones that the triangles use
    acmr: float  #: misses a triangle: .5 at best on large closed meshes, 3 at worst
    atvr: float  #: misses a vertex that is used: 1 at best


def vertex_cache(indices: Any, vertex_count: Optional[int] = None, *, cache_size: int = 16) -> VertexCache:
    """Count what a FIFO cache of `cache_size` entries, 1 to 65535, misses of the triangles as they stand."""
    mesh = triangles(indices, vertex_count)
    figures = c.VertexCacheFigures()
    status = library().vertex_cache(byref(figures), byref(mesh), option("cache_size", cache_size))
    check(status, mesh, cache_size=cache_size)
    return VertexCache(figures.misses, figures.vertices, figures.acmr, figures.atvr)


def _order(function: Any, indices: Any, vertex_count: Optional[int], *options: int) -> np.ndarray:
    """Of triangles; the last option is the size of a cache."""
    mesh = triangles(indices, vertex_count)
    order = np.empty(mesh.index_count // 3, np.uint32)
    check(function(address(order), byref(mesh), *options), mesh, cache_size=options[-1])
    return order


def option(name: str, value: Any) -> int:
    """C takes 0 for the default, which here is written in the signature."""
    number = count(value, name)
    if number == 0:
        raise ValueError(f"{name} must not be 0")
    return number


def choice(name: str, value: str, choices: Dict[str, int]) -> int:
    try:
        return choices[value]
    except (KeyError, TypeError):
        raise ValueError(f"{name} is {value!r}, but must be one of {', '.join(choices)}") from None


def as_given(made: np.ndarray, given: Any) -> np.ndarray:
    """Of the type in which the caller has indices; a list's is numpy's own."""
    return made.astype(np.asarray(given).dtype, copy=False) if len(made) else made


def _text(status: int) -> str:
    return library().status_text(status).decode()


def check(status: int, mesh: Optional[c.Triangles] = None, **options: Any) -> None:
    """Raises what a status says, with the figures that it is about."""
    if status == c.DONE:
        return
    text = _text(status)
    if status == c.NO_MEMORY:
        raise MemoryError(text)
    if status == c.INDEX_RANGE and mesh is not None:
        text += f": the largest is {int(mesh.array.max())}, and there are {mesh.vertex_count} vertices"
    if status == c.OPTION_RANGE:
        text += ": " + ", ".join(f"{name}={value}" for name, value in options.items())
    raise ValueError(text)
