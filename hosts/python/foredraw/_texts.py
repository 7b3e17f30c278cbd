"""Texts that cross the border, and what statuses say."""

import ctypes
import json
import os
from ctypes import byref
from typing import Any, Dict, Optional, Union

from ._header import CANCELLED, DONE, NO_MEMORY, Text
from ._library import library
from .errors import Cancelled, Error, told


def text_for_c(text: str, what: str) -> bytes:
    """UTF-8; C ends at the first 0."""
    return _whole(text.encode(), what)


def path_for_c(path: Union[str, "os.PathLike[str]"]) -> bytes:
    return _whole(os.fsencode(path), "a path")


def settings_for_c(settings: Dict[str, Any]) -> Optional[bytes]:
    """A line of name="value"; None if there are none."""
    if not settings:
        return None
    line = ", ".join(f"{name}={json.dumps(value)}" for name, value in settings.items())
    return text_for_c(line, "a setting")


def _whole(data: bytes, what: str) -> bytes:
    if b"\0" in data:
        raise ValueError(f"{what} contains a zero byte")
    return data


class Told:
    """A text that comes out: JSON, freed when it was taken."""

    def __init__(self) -> None:
        self._text = Text()
        self.out = byref(self._text)

    def take(self) -> Dict[str, Any]:
        """Empty where the library had none."""
        return json.loads(self.take_bytes() or b"{}")

    def take_bytes(self) -> bytes:
        data = ctypes.string_at(self._text.data, self._text.length) if self._text.data else b""
        library().text_free(self.out)
        return data


def check(status: int, said: Dict[str, Any], result: Any = None) -> None:
    """Raises what a status says, with the diagnostics that were said about it."""
    if status == DONE:
        return
    if status == NO_MEMORY:
        raise MemoryError("memory ran out")
    diagnostics = said.get("diagnostics") or []
    said_by_status = library().status_text(status).decode()
    if status == CANCELLED:
        raise Cancelled(said_by_status, diagnostics)
    raise Error(told(diagnostics) or said_by_status, diagnostics, result)
