"""What is raised."""

from typing import Any, Dict, List, Sequence

Diagnostic = Dict[str, Any]


class Error(Exception):
    """Something is wrong with a file, a pipeline or a stage. The text says what, where, and what to do about it.

    Attributes
    ----------
    diagnostics : list of dict
        What the library said, warnings among it: severity, code, message, hint, file, line, column, inside, places
        (docs/reference/report.md).
    result
        What was made all the same, where only a part failed: what the function would have returned. Otherwise None.
    """

    def __init__(self, text: str, diagnostics: Sequence[Diagnostic] = (), result: Any = None) -> None:
        super().__init__(text)
        self.diagnostics: List[Diagnostic] = list(diagnostics)
        self.result = result

    def __reduce__(self) -> Any:
        return type(self), (str(self), self.diagnostics)  # a result may hold a scene, which stays in its process


class Cancelled(Error):
    """Somebody ended the run by :meth:`Context.cancel`."""


def _line(diagnostic: Diagnostic) -> str:
    """As the program says it: "file:5:23: error: stages[1]: message", and the hint on a line of its own."""
    said = diagnostic.get
    place = said("file") or ""
    if said("line"):
        place += f":{said('line')}:{said('column')}"
    text = f"{place}: " if place else ""
    text += f"{said('severity')}: "
    if said("inside"):
        text += f"{said('inside')}: "
    text += said("message") or ""
    if (said("places") or 1) > 1:
        text += f" (and {said('places') - 1} more like it)"
    if said("hint"):
        text += f"\n    hint: {said('hint')}"
    return text


def told(diagnostics: Sequence[Diagnostic]) -> str:
    """The errors among them, a line each."""
    return "\n".join(_line(diagnostic) for diagnostic in diagnostics if diagnostic.get("severity") == "error")
