"""Orders of one draw by stages of pipelines, without a scene."""

from ctypes import byref, c_uint32
from typing import Any, NamedTuple, Optional

import numpy as np

from ._arrays import address, positions, triangles
from ._library import library
from ._texts import Told, check, text_for_c
from ._waiting import Tell
from .contexts import Context, default_context


def order(
    stages: str,
    indices: Any,
    positions_of_vertices: Any,
    *,
    context: Optional[Context] = None,
    progress: Optional[Tell] = None,
) -> np.ndarray:
    """What stages make of a draw's triangles, or of its vertices. Ctrl-C ends it.

    Parameters
    ----------
    stages : str
        One or a line of them, "lookahead, occlusion-order(quality=high)", that order or cluster triangles; or one that
        orders vertices. Techniques of :func:`add` as well.
    indices : array of integers, (n, 3) or (3 n,)
    positions_of_vertices : array of numbers, (vertices, 3)
    context, progress
        As of :func:`optimize`.

    Returns
    -------
    order : array of uint32
        ``order[new] = old``.
    """
    places, vertices = positions(positions_of_vertices)
    mesh = triangles(indices, vertices)
    text, context = text_for_c(stages, "stages"), context or default_context()
    room = np.full(max(mesh.index_count // 3, vertices), 0xFFFFFFFF, np.uint32)  # more than are named: not written

    def work() -> np.ndarray:
        told = Told()
        status = library().order(context._pointer, text, byref(mesh), byref(places), address(room), told.out)
        said = told.take()
        written = int(np.argmax(room == 0xFFFFFFFF)) if (room == 0xFFFFFFFF).any() else len(room)
        check(status, said, room[:written].copy())
        return room[:written].copy()

    return context._run(work, progress)


class Clustered(NamedTuple):
    """Triangles in an order, and cut into clusters."""

    order: np.ndarray  #: order[new] = old triangle
    offsets: np.ndarray  #: cluster i holds the triangles offsets[i] to offsets[i + 1] - 1 of that order


def cluster(
    stages: str,
    indices: Any,
    positions_of_vertices: Any,
    *,
    context: Optional[Context] = None,
    progress: Optional[Tell] = None,
) -> Clustered:
    """The same with stages of which one clusters: "tipsify, linear-clusters". Parameters: as of :func:`order`."""
    places, vertices = positions(positions_of_vertices)
    mesh = triangles(indices, vertices)
    text, context = text_for_c(stages, "stages"), context or default_context()
    made = np.empty(mesh.index_count // 3, np.uint32)
    offsets, clusters = np.empty(len(made) + 1, np.uint32), c_uint32()

    def work() -> Clustered:
        told = Told()
        status = library().cluster(
            context._pointer, text, byref(mesh), byref(places), address(made), address(offsets), byref(clusters),
            told.out,
        )
        check(status, told.take(), Clustered(made, offsets))
        return Clustered(made, offsets[: clusters.value + 1].copy())

    return context._run(work, progress)
