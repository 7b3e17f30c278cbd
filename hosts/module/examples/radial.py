"""A module: an orderer of triangles, as radial.c is one."""

import foredraw as fd
import numpy as np

__version__ = "1.0.0"


@fd.orderer("acme-radial", [fd.number("height", 1, 0, 10, doc="How much height counts")],
            provides="overdraw-ordered", breaks="cache-ordered fetch-ordered clustered")
def radial(draw, height):
    """Draws triangles far from the origin first"""
    x, y, z = np.moveaxis(draw.positions.astype(np.float64)[draw.indices], -1, 0)
    y = height * y
    square = x * x + y * y + z * z
    distance = square[:, 0] + square[:, 1] + square[:, 2]
    return np.argsort(-np.where(distance >= 0, distance, -1), kind="stable")
