"""Pipelines and evaluators, run on a scene."""

import os
from ctypes import byref, c_void_p
from typing import Any, Dict, NamedTuple, Optional, Union

from ._library import library
from ._texts import Told, check, text_for_c
from ._waiting import Tell
from .contexts import Context, default_context
from .lent_draws import Handle
from .scenes import Scene

Pipeline = Union[str, "os.PathLike[str]"]


class Optimized(NamedTuple):
    """What a pipeline made."""

    scene: Scene
    report: Dict[str, Any]  #: as the program's ``--json`` (docs/reference/report.md)


def optimize(
    scene: Scene, pipeline: Pipeline, *, context: Optional[Context] = None, progress: Optional[Tell] = None
) -> Optimized:
    """Run a pipeline's stages on a scene. Ctrl-C ends it.

    Parameters
    ----------
    scene : Scene
    pipeline : str or path
        "@default" or another preset, a line of stages, or the text of a pipeline's file (docs/reference/pipelines.md);
        a :class:`pathlib.Path` names such a file.
    context : Context, optional
    progress : callable, optional
        Called with what is going on, and which part of the whole is done, 0 to 1, on the calling thread. What it
        raises ends the run.

    Raises
    ------
    Error
        For a pipeline that is wrong or cannot be used. Where a stage failed, and left what it found, the error's
        `result` is what the others made.
    """
    context = context or default_context()
    text = pipeline_text(pipeline)

    def work() -> Optimized:
        pointer, told = c_void_p(), Told()
        status = library().optimize(context._pointer, scene._handle.pointer, text, byref(pointer), told.out)
        made = Scene(Handle(pointer.value)) if pointer.value else None
        report = told.take()
        result = Optimized(made, report) if made is not None else None
        check(status, report, result)
        return result  # type: ignore[return-value]

    return context._run(work, progress)


def measure(
    scene: Scene,
    evaluators: Optional[str] = None,
    *,
    context: Optional[Context] = None,
    progress: Optional[Tell] = None,
) -> Dict[str, Any]:
    """Measure a scene. Ctrl-C ends it.

    Parameters
    ----------
    scene : Scene
    evaluators : str, optional
        "vertex-cache, overdraw-raster(count=30)"; otherwise those of @default.
    context, progress
        As of :func:`optimize`.

    Returns
    -------
    report : dict
        As the program's ``--json`` (docs/reference/report.md); ``figures(report["totals"])`` makes a table of it.
    """
    context = context or default_context()
    text = None if evaluators is None else text_for_c(evaluators, "a list of evaluators")

    def work() -> Dict[str, Any]:
        told = Told()
        status = library().measure(context._pointer, scene._handle.pointer, text, told.out)
        report = told.take()
        check(status, report)
        return report

    return context._run(work, progress)


def pipeline_text(pipeline: Pipeline) -> bytes:
    """For C; of a path, the text of the file."""
    if not isinstance(pipeline, str):
        with open(pipeline, encoding="utf-8") as file:
            pipeline = file.read()
    return text_for_c(pipeline, "a pipeline")
