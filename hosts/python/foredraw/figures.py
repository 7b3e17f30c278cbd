"""Figures of reports as rows of a table."""

from typing import Any, Dict, Iterator, List, Mapping, Tuple

Row = Dict[str, Any]


def figures(state: Mapping[str, Any]) -> List[Row]:
    """The figures of a state of a report as rows, which pandas.DataFrame takes.

    Parameters
    ----------
    state : mapping
        ``report["totals"]``, what that has as "before", or one of ``report["draws"]`` (docs/reference/report.md).

    Returns
    -------
    list of dict
        evaluator, metric, value, unit, error. What they mean: docs/reference/figures.md.
    """
    return [
        {
            "evaluator": evaluator,
            "metric": metric,
            "value": figure["value"],
            "unit": figure["unit"],
            "error": figure.get("error"),
        }
        for evaluator, metrics in state.get("metrics", {}).items()
        for metric, figure in _flat(metrics)
    ]


def _flat(metrics: Mapping[str, Any], before: str = "") -> Iterator[Tuple[str, Mapping[str, Any]]]:
    """Metrics with dots in their names lie in nested objects."""
    for name, value in metrics.items():
        if "value" in value and "unit" in value:
            yield before + name, value
        else:
            yield from _flat(value, f"{before}{name}.")
