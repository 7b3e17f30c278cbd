"""Several pipelines side by side."""

import os
from ctypes import c_char_p, c_void_p
from html import escape
from typing import Any, Dict, Iterable, List, Optional, Union

from ._arrays import count
from ._library import library
from ._texts import Told, check
from ._waiting import Tell
from .contexts import Context, default_context
from .figures import Row, figures
from .runs import Pipeline, pipeline_text
from .scenes import FilePath, Scene, read


class Comparison(List[Row]):
    """Figures of several pipelines on several scenes, as rows, which pandas.DataFrame takes. A notebook shows a table.

    A row has the figures that the program's ``compare --csv`` has of all draws of a scene together: ``file``,
    ``branch`` (0 for the input, 1 and up for the pipelines), ``pipeline`` ("input" for the input), ``evaluator``,
    ``metric``, ``value``, ``unit`` and ``error``; of each pipeline's time the evaluator is "time".

    Attributes
    ----------
    report : dict
        As the program's ``compare --json`` (docs/reference/report.md): reports of each pipeline, and sums over all
        scenes.
    """

    def __init__(self, report: Dict[str, Any]) -> None:
        super().__init__(row for file in report.get("files", []) for row in _rows(file))
        self.report = report

    def _repr_html_(self) -> str:
        files = self.report.get("files", [])
        return _table(self.report.get("all") or (files[0] if files else {}))


def compare(
    scenes: Union[FilePath, Scene, Iterable[Union[FilePath, Scene]]],
    pipelines: Union[Pipeline, Iterable[Pipeline]],
    *,
    rounds: int = 1,
    context: Optional[Context] = None,
    progress: Optional[Tell] = None,
) -> Comparison:
    """Run each pipeline on each scene, and measure all alike. Ctrl-C ends it.

    Parameters
    ----------
    scenes : paths or scenes, or one
    pipelines : str or path, or several
        As of :func:`optimize`. All measure as the first does.
    rounds : int
        How often stages run; their times are the medians.
    context, progress
        As of :func:`optimize`.

    Raises
    ------
    Error
        For a pipeline that is wrong. Where one could not be planned or a stage failed on some scene, the error's
        `result` is the comparison of the others.
    """
    context = context or default_context()
    held = [one if isinstance(one, Scene) else read(one, context=context) for one in _several(scenes)]
    texts = [pipeline_text(one) for one in _several(pipelines)]
    handles = (c_void_p * len(held))(*(scene._handle.pointer for scene in held))
    lines = (c_char_p * len(texts))(*texts)
    times = count(rounds, "rounds")

    def work() -> Comparison:
        told = Told()
        status = library().compare(context._pointer, handles, len(held), lines, len(texts), times, told.out)
        report = told.take()
        comparison = Comparison(report)
        check(status, _all_said(report), comparison if comparison else None)
        return comparison

    return context._run(work, progress)


def _several(given: Any) -> Iterable[Any]:
    return [given] if isinstance(given, (str, os.PathLike, Scene)) else given


def _rows(file: Dict[str, Any]) -> Iterable[Row]:
    """Of one scene: the input's, then each pipeline's."""
    path = file["input"]["path"]
    branches = [branch for branch in enumerate(file["branches"], 1) if not branch[1].get("lost")]
    if branches:
        for row in figures(branches[0][1]["report"]["totals"].get("before", {})):
            yield {"file": path, "branch": 0, "pipeline": "input", **row}
    for number, branch in branches:
        place = {"file": path, "branch": number, "pipeline": branch["name"]}
        for row in figures(branch["report"]["totals"]):
            yield {**place, **row}
        time = {"evaluator": "time", "metric": "all stages", "value": branch["seconds"], "unit": "s", "error": None}
        yield {**place, **time}


def _all_said(report: Dict[str, Any]) -> Dict[str, Any]:
    """The diagnostics of the comparison, and those of each pipeline on each scene."""
    said = list(report.get("diagnostics", []))
    for file in report.get("files", []):
        for branch in file["branches"]:
            said += [one for one in branch["report"].get("diagnostics", []) if one not in said]
    return {"diagnostics": said}


def _table(file: Dict[str, Any]) -> str:
    """The figures of one file, or of all as one: pipelines beside each other, the best in bold."""
    branches = file.get("branches", [])
    names = "".join(f"<li>{escape(branch['name'])}</li>" for branch in branches)
    heads = "".join(f"<th>[{number}]</th>" for number in range(1, len(branches) + 1))
    rows = "".join(_table_row(row) for row in file.get("metrics", []) if "." not in row["metric"])
    times = "".join(f"<td>{_number(branch['seconds'])}</td>" for branch in branches)
    return (
        f"<p>{escape(file.get('input', {}).get('path', ''))}</p><ol>{names}</ol>"
        f"<table><tr><th></th><th>metric</th><th>input</th>{heads}</tr>{rows}"
        f"<tr><td>time</td><td>all stages, s</td><td></td>{times}</tr></table>"
    )


def _table_row(row: Dict[str, Any]) -> str:
    there = [value for value in row["values"] if value is not None]
    best = (min(there) if row["lower-is-better"] else max(there)) if len(set(there)) > 1 else None
    cells = "".join(
        f"<td><b>{_number(value)}</b></td>" if value is not None and value == best else f"<td>{_number(value)}</td>"
        for value in row["values"]
    )
    names = f"<td>{escape(row['evaluator'])}</td><td>{escape(row['metric'])}</td>"
    return f"<tr>{names}<td>{_number(row['input'])}</td>{cells}</tr>"


def _number(value: Optional[float]) -> str:
    if value is None:
        return ""
    return f"{value:,.0f}" if value == int(value) else f"{value:,.4f}"
