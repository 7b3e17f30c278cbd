"""Scenes: from files, from memory, and into files again."""

import os
from ctypes import byref, c_void_p
from typing import Any, Iterable, List, Optional, Union

import numpy as np

from . import _header as c
from ._arrays import address
from ._library import library
from ._texts import Told, check, path_for_c, settings_for_c, text_for_c
from .contexts import Context, default_context
from .errors import Diagnostic
from .given_draws import draw_for_c
from .lent_draws import Draws, Handle, Moves, moves_of

FilePath = Union[str, "os.PathLike[str]"]


class Scene:
    """A scene, which never changes: what is made of it is another. :func:`read`, :func:`read_bytes` and :func:`make`
    give one, and :func:`optimize` makes a cheaper one of it.

    Attributes
    ----------
    draws : sequence
        The draws by number; their ``indices``, ``positions`` and ``streams`` are read-only views of the scene's memory,
        and keep it alive.
    diagnostics : list of dict
        Warnings of whoever read it.
    """

    def __init__(self, handle: Handle, diagnostics: Iterable[Diagnostic] = ()) -> None:
        self._handle = handle
        self.draws = Draws(handle)
        self.diagnostics: List[Diagnostic] = list(diagnostics)

    def moves(self, number: int) -> Moves:
        """Where triangles and vertices of that draw went, from what was read to what they are now."""
        return moves_of(self._handle, range(len(self.draws))[number])

    def write(self, path: FilePath, *, context: Optional[Context] = None, **settings: str) -> List[Diagnostic]:
        """:func:`write` of this."""
        return write(self, path, context=context, **settings)

    def write_bytes(self, name: FilePath = "scene.glb", *, context: Optional[Context] = None, **settings: str) -> bytes:
        """:func:`write_bytes` of this."""
        return write_bytes(self, name, context=context, **settings)

    def __repr__(self) -> str:
        return f"<foredraw scene of {len(self.draws)} draws>"


def read(path: FilePath, *, context: Optional[Context] = None) -> Scene:
    """Read glTF, OBJ, PLY, OFF, STL, an image or a frame list."""
    pointer, told = c_void_p(), Told()
    context = context or default_context()
    status = library().read(context._pointer, path_for_c(path), byref(pointer), told.out)
    return _scene(status, pointer, told)


def read_bytes(data: Any, name: str = "memory", *, context: Optional[Context] = None) -> Scene:
    """Read glTF in memory, .glb or .gltf: bytes, or whatever lends them. Files beside it are not looked for.

    Parameters
    ----------
    data : bytes, bytearray, memoryview, mmap, array of uint8
    name : str
        What diagnostics call it.
    """
    view = memoryview(data).cast("B")
    array = np.frombuffer(view, np.uint8) if len(view) else np.empty(0, np.uint8)
    pointer, told = c_void_p(), Told()
    context = context or default_context()
    status = library().read_memory(
        context._pointer, address(array), array.size, text_for_c(name, "a name"), byref(pointer), told.out
    )
    return _scene(status, pointer, told)


def make(draws: Iterable[Any], *, context: Optional[Context] = None) -> Scene:
    """Make a scene of draws in memory, which are copied.

    Parameters
    ----------
    draws : iterable of :class:`Draw`, or of draws of other scenes
    """
    given = []
    for number, draw in enumerate(draws):
        try:
            given.append(draw_for_c(draw))
        except (TypeError, ValueError) as problem:
            raise type(problem)(f"draw {number}: {problem}") from None
    pointer, told = c_void_p(), Told()
    context = context or default_context()
    status = library().make_scene(
        context._pointer, (c.Draw * len(given))(*given), len(given), byref(pointer), told.out
    )
    return _scene(status, pointer, told)


def write(
    scene: Scene, path: FilePath, *, context: Optional[Context] = None, **settings: str
) -> List[Diagnostic]:
    """Write the scene, as what the extension says: all its files or none. Warnings and notes come back.

    Parameters
    ----------
    **settings
        Those of [output] in a pipeline, such as ``compression="draco"`` or ``levels="msft-lod"``. What is not given is
        as the pipeline that made the scene says.
    """
    told = Told()
    context = context or default_context()
    status = library().write_as(
        context._pointer, scene._handle.pointer, path_for_c(path), settings_for_c(settings), told.out
    )
    said = told.take()
    check(status, said)
    return said.get("diagnostics", [])


def write_bytes(
    scene: Scene, name: FilePath = "scene.glb", *, context: Optional[Context] = None, **settings: str
) -> bytes:
    """The bytes of the file that :func:`write` would write to that path. A scene that takes several files, as .gltf
    does, is refused."""
    told, file = Told(), Told()
    context = context or default_context()
    status = library().write_memory(
        context._pointer, scene._handle.pointer, path_for_c(name), settings_for_c(settings), file.out, told.out
    )
    check(status, told.take())
    return file.take_bytes()


def _scene(status: int, pointer: c_void_p, told: Told) -> Scene:
    said = told.take()
    check(status, said)
    return Scene(Handle(pointer.value or 0), said.get("diagnostics", []))
