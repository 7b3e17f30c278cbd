"""Images of sprites: cut into frames, and frames trimmed to what shows."""

from ctypes import byref, c_uint32, sizeof
from typing import Any, List, NamedTuple, Sequence, Tuple

import numpy as np

from . import _header as c
from ._arrays import LARGEST, address
from ._library import library
from .functions import check, choice, option

_WRAPS = {"repeat": c.WRAP_REPEAT, "mirrored": c.WRAP_MIRRORED, "clamped": c.WRAP_CLAMPED}
_UVS = {"float32": c.UV_FLOAT32, "float16": c.UV_FLOAT16, "unorm16": c.UV_UNORM16}
_OUTCOMES = ["trimmed", "rectangle", "empty", "full", "no-saving"]
_MOST_FRAMES = 16384

Frame = Tuple[int, int, int, int]


def sprite_frames(alpha: Any, *, threshold: float = 0, gutter: int = 1) -> List[Frame]:
    """The parts of an image of many sprites, in reading order, each with a margin of one texel.

    Parameters
    ----------
    alpha : array of uint8 or uint16, (height, width)
        What shows: a channel of an image may be a slice of it, ``image[:, :, 3]``.
    threshold : float
        A texel shows that is above it, 0 to 1.
    gutter : int
        Empty texels between parts, 1 to 65535.

    Returns
    -------
    list of (x, y, width, height), in texels from the upper left corner
    """
    image = _alpha(alpha)
    frames = np.empty((_MOST_FRAMES, 4), np.uint32)
    found = c_uint32(_MOST_FRAMES)
    gaps = option("gutter", gutter)
    status = library().sprite_frames(address(frames), byref(found), byref(image), float(threshold), gaps)
    if status == c.TOO_LARGE and found.value == 0:
        raise ValueError(f"there are more than {_MOST_FRAMES} parts; raise threshold or gutter")
    check(status, None, threshold=threshold, gutter=gutter)
    return [tuple(row) for row in frames[: found.value].tolist()]


class Trimmed(NamedTuple):
    """A sprite's polygon."""

    outcome: str  #: "trimmed", "rectangle", "empty", "full" or "no-saving"; after the last three the frame stays
    corners: np.ndarray  #: (n, 2), texture coordinates, clockwise on a screen; (0, 0) is the upper left corner
    area: float  #: of what is drawn, in texels
    frame_area: float  #: in texels
    lost: float  #: the largest number that may show outside, at most the threshold


def particle_trim(
    alpha: Any,
    frames: Sequence[Frame],
    *,
    vertices: int = 8,
    threshold: float = 0,
    padding: float = 0,
    least_saving: float = 0.05,
    mip_levels: int = 2,
    wrap: Tuple[str, str] = ("clamped", "clamped"),
    is_nearest: bool = False,
    uv: str = "float32",
) -> List[Trimmed]:
    """A polygon for each frame, as small as its vertices allow, that holds all that shows.

    Persson: Graphics Gems for Games, SIGGRAPH 2012.

    Parameters
    ----------
    alpha : array of uint8 or uint16, (height, width)
    frames : sequence of (x, y, width, height)
        In texels; :func:`sprite_frames` finds them.
    vertices : int
        Of a polygon, 3 to 16.
    threshold, padding, least_saving : float
        What is above shows, 0 to 1; texels more on each side, 0 to 64; share of a frame below which it stays, 0 to 1.
    mip_levels : int
        Smaller versions of the image that may be sampled, 0 to 14.
    wrap : pair of {"repeat", "mirrored", "clamped"}
    is_nearest : bool
        Texels are not blended.
    uv : {"float32", "float16", "unorm16"}
        How coordinates are stored.
    """
    image = _alpha(alpha)
    rows = np.ascontiguousarray(np.asarray(list(frames), np.int64).reshape(-1, 4))
    if rows.size > 0 and (rows.min() < 0 or rows.max() > LARGEST):
        raise ValueError(f"frames must lie in the image of {image.width} x {image.height} texels")
    rows = rows.astype(np.uint32)
    options = c.TrimOptions(
        size=sizeof(c.TrimOptions),
        vertices=option("vertices", vertices),
        threshold=threshold,
        padding=padding,
        least_saving=least_saving,
        mip_levels=option("mip_levels", mip_levels + 1) - 1,
        wrap_u=choice("wrap", wrap[0], _WRAPS),
        wrap_v=choice("wrap", wrap[1], _WRAPS),
        is_nearest=bool(is_nearest),
        uv=choice("uv", uv, _UVS),
    )
    made = (c.Trimmed * len(rows))()
    corners = np.empty((len(rows), 16, 2), np.float64)
    status = library().particle_trim(made, address(corners), byref(image), address(rows), len(rows), byref(options))
    check(status, None, vertices=vertices, threshold=threshold, padding=padding, mip_levels=mip_levels, frames=frames)
    return [
        Trimmed(_OUTCOMES[one.outcome], corners[i, : one.corner_count].copy(), one.area, one.frame_area, one.lost)
        for i, one in enumerate(made)
    ]


def _alpha(values: Any) -> c.Alpha:
    """For C; it keeps the array. A channel of an interleaved image is taken in place."""
    array = np.asarray(values)
    if array.dtype not in (np.uint8, np.uint16) or array.ndim != 2:
        raise TypeError(f"alpha must be a (height, width) array of uint8 or uint16, but is {array.dtype} {array.shape}")
    array = array.astype(array.dtype.newbyteorder("="), copy=False)
    if array.size > 0 and (array.strides[0] <= 0 or not 0 < array.strides[1] <= LARGEST):
        array = np.ascontiguousarray(array)
    if array.size == 0:
        raise ValueError("the image has no texels")
    made = c.Alpha(
        address(array), array.shape[1], array.shape[0], array.itemsize, array.strides[1], array.strides[0]
    )
    made.array = array
    return made
