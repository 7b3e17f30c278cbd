"""Arrays as the library takes and lends them. What it takes is copied only where it has to be."""

import operator
from typing import Any, Optional, Tuple

import numpy as np

from ._header import Positions, Triangles

LARGEST = 0xFFFFFFFF  # that 32 bits hold


def address(array: np.ndarray) -> int:
    """Of the first element. Who calls keeps the array."""
    return array.__array_interface__["data"][0]


def count(value: Any, what: str) -> int:
    """`value` as a number that C's uint32_t holds."""
    number = operator.index(value)
    if not 0 <= number <= LARGEST:
        raise ValueError(f"{what} must be 0 to {LARGEST}, but is {number}")
    return number


def unsigned(values: Any, what: str) -> np.ndarray:
    """Integers of any type as unsigned ones of 1, 2 or 4 bytes, one behind the other in C's order."""
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        if array.size > 0 or isinstance(values, np.ndarray):
            raise TypeError(f"{what} must be integers, but are {array.dtype}")
        array = array.astype(np.uint32)  # an empty list has no type of its own
    size = array.dtype.itemsize
    if array.size > 0 and (size == 8 or array.dtype.kind == "i"):
        least, most = int(array.min()), int(array.max())
        if least < 0 or most > LARGEST:
            raise ValueError(f"{what} must be 0 to {LARGEST}, but one is {least if least < 0 else most}")
    if size == 8:
        return array.astype(np.uint32, order="C")
    if array.dtype.kind == "i":
        array = array.view(array.dtype.str.replace("i", "u"))
    return np.ascontiguousarray(array, array.dtype.newbyteorder("="))


def numbers(values: Any, what: str) -> np.ndarray:
    """Integers of any type as a row of 32-bit ones: an order, offsets."""
    array = unsigned(values, what)
    if array.ndim != 1:
        raise ValueError(f"{what} must be a row of numbers, but have the shape {array.shape}")
    return array.astype(np.uint32, copy=False)


def triangles(indices: Any, vertex_count: Optional[int] = None) -> Triangles:
    """A triangle list for C. It keeps the array that it points to, as `array`."""
    array = unsigned(indices, "indices")
    is_flat = array.ndim == 1 and array.size % 3 == 0
    if not is_flat and not (array.ndim == 2 and array.shape[1] == 3):
        raise ValueError(f"indices must have the shape (n, 3) or (3 n,), but have {array.shape}")
    if vertex_count is None:
        vertex_count = int(array.max()) + 1 if array.size > 0 else 0
    made = Triangles(address(array), array.size, array.itemsize, count(vertex_count, "vertex_count"))
    made.array = array
    return made


def rows_of_floats(values: Any, what: str) -> np.ndarray:
    """Numbers of any type as rows of three 32-bit floats, without gaps within a row."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{what} must be numbers, but are {array.dtype}")
    if array.ndim == 1 and array.size % 3 == 0:
        array = array.reshape(-1, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} must have the shape (n, 3) or (3 n,), but have {array.shape}")
    with np.errstate(over="ignore"):  # what is too large for them is infinite, which is taken
        return without_gaps(array.astype(np.float32, copy=False))


def without_gaps(rows: np.ndarray) -> np.ndarray:
    """Elements of a row one behind the other; rows forward, at any distance that C's uint32_t holds."""
    between, within = rows.strides
    if within != rows.itemsize or not 0 < between <= LARGEST:
        return np.ascontiguousarray(rows)
    return rows


def positions(values: Any) -> Tuple[Positions, int]:
    """Positions for C, within an interleaved array if need be, and how many there are."""
    array = rows_of_floats(values, "positions")
    made = Positions(address(array), array.strides[0])
    made.array = array
    return made, len(array)


class _Lent:
    """Memory of the library's, as numpy asks for it; who has an array of it keeps its owner."""

    def __init__(self, owner: object, interface: dict) -> None:
        self.owner = owner
        self.__array_interface__ = interface


def lent(owner: object, first: Optional[int], dtype: Any, shape: Tuple[int, ...], stride: int = 0) -> np.ndarray:
    """A read-only view, which keeps `owner`, of an array at the address `first`. `stride`: bytes from one row to the
    next; 0: none between them."""
    dtype = np.dtype(dtype)
    if 0 in shape:
        empty = np.empty(shape, dtype)
        empty.flags.writeable = False
        return empty
    strides = (stride, dtype.itemsize) if stride and len(shape) == 2 else None
    return np.asarray(
        _Lent(owner, {"version": 3, "data": (first, True), "typestr": dtype.str, "shape": shape, "strides": strides})
    )
