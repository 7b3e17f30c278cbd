"""Techniques written in Python: orderers, clusterers, remeshers and evaluators, which pipelines name like the built-in
ones."""

import traceback
from ctypes import POINTER, byref, c_char_p, c_uint32, c_uint64, sizeof
from typing import Any, Callable, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _header as c
from ._arrays import lent, numbers
from ._library import library
from ._texts import Told, check, text_for_c
from .contexts import Context, default_context
from .lent_draws import LentDraw

_INFINITE = float("inf")


class Option(NamedTuple):
    """An option of a technique: :func:`number`, :func:`integer`, :func:`boolean`, :func:`text` or :func:`choice`."""

    name: str
    type: int
    initial: Any
    doc: str = ""
    unit: str = ""
    least: float = -_INFINITE
    most: float = _INFINITE
    choices: Tuple[str, ...] = ()


def number(name: str, initial: float, least: float = -_INFINITE, most: float = _INFINITE, unit: str = "",
           doc: str = "") -> Option:
    """A floating-point option, `least` to `most`."""
    return Option(name, c.NUMBER, float(initial), doc, unit, least, most)


def integer(name: str, initial: int, least: float = -_INFINITE, most: float = _INFINITE, unit: str = "",
            doc: str = "") -> Option:
    """A whole number, `least` to `most`."""
    return Option(name, c.INTEGER, int(initial), doc, unit, least, most)


def boolean(name: str, initial: bool, doc: str = "") -> Option:
    """True or false."""
    return Option(name, c.BOOLEAN, bool(initial), doc)


def text(name: str, initial: str, doc: str = "") -> Option:
    """Any text."""
    return Option(name, c.TEXT, initial, doc)


def choice(name: str, choices: Sequence[str], initial: Optional[str] = None, doc: str = "") -> Option:
    """One of several words; the first, unless `initial` says which."""
    return Option(name, c.CHOICE, choices[0] if initial is None else initial, doc, choices=tuple(choices))


class Metric(NamedTuple):
    """A figure of an evaluator."""

    name: str
    unit: str = ""
    doc: str = ""
    higher_is_better: bool = False


class Keep(Exception):
    """Raise it where nothing can be gained: what there is stays, and the report has the reason."""


class HandedDraw(LentDraw):
    """A draw as a technique is handed it. Arrays are read-only, and good within the call alone: copy what you keep."""

    def __init__(self, draw: c.Draw, host: c.Host) -> None:
        self._handle = None  # type: ignore[assignment]
        self._number = 0
        self._lent = draw
        self._host = host

    @property
    def seed(self) -> int:
        """For random numbers: of the pipeline's seed, the stage and the draw."""
        return self._host.seed

    @property
    def cancelled(self) -> bool:
        """Ask in loops that last, and return soon if so."""
        return bool(self._host.cancelled(self._host.self))

    @property
    def cluster_offsets(self) -> np.ndarray:
        """Cluster i holds the triangles [i] to [i + 1] - 1; empty where there are none."""
        draw = self._triangles
        return lent(None, draw.cluster_offsets, np.uint32, (draw.cluster_count + 1 if draw.cluster_count else 0,))

    def count_overdraw(self, order: Any = None) -> Tuple[int, int]:
        """Fragments that are shaded, and those that stay, over all views of the pipeline, where the triangles of this
        draw alone are drawn in an order, ``order[new] = old``; None: as they stand. What is seen is captured at the
        first call. Of orderers and evaluators that are decorated with `uses_overdraw`."""
        shaded, visible, first = c_uint64(), c_uint64(), None
        if order is not None:
            given = numbers(order, "the order")
            if len(given) != self.triangle_count:
                raise ValueError(f"the order has {len(given)} numbers, but there are {self.triangle_count} triangles")
            first = given.ctypes.data_as(POINTER(c_uint32))
        status = self._host.count_overdraw(self._host.self, first, byref(shaded), byref(visible))
        if status == c.MISTAKE:
            raise ValueError("decorate an orderer of triangles or an evaluator with uses_overdraw=True to ask for it")
        if status != c.DONE:
            raise ValueError(library().status_text(status).decode())
        return shaded.value, visible.value


class Technique:
    """A function with the name and the options that pipelines know it by. :func:`add` makes it known to them."""

    def __init__(self, kind: int, name: str, function: Callable[..., Any], options: Sequence[Option],
                 metrics: Sequence[Metric], traits: Tuple[str, str, str], reference: str, acts_on: str = "",
                 pays_if: str = "", flags: int = 0) -> None:
        self.name, self.function, self.options = name, function, tuple(options)
        self._kind = kind
        summary = (function.__doc__ or name).strip().splitlines()[0]
        self._choices = [(c_char_p * len(one.choices))(*(_bytes(word) for word in one.choices)) for one in options]
        self._plugin = c.Plugin(
            sizeof(c.Plugin), kind, *map(_bytes, (name, summary, reference, *traits)),
            (c.Option * len(options))(*map(_option, options, self._choices)),
            (c.Metric * len(metrics))(*(c.Metric(*map(_bytes, one[:3]), one.higher_is_better) for one in metrics)),
            len(options), len(metrics), 0, None, c.Run(self._run), _bytes(acts_on), _bytes(pays_if), flags, 0,
        )

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        return self.function(*arguments, **named)

    def _run(self, _user: Any, draw: Any, values: Any, answer: Any, host: Any) -> int:
        told = host.contents
        try:
            handed = HandedDraw(draw.contents, told)
            named = {one.name.replace("-", "_"): _value(one, values[i]) for i, one in enumerate(self.options)}
            found = self.function(handed, **named)
            if handed.cancelled:
                return c.CANCELLED
            if self._kind == c.EVALUATOR:
                _tell(found, told)
            elif self._kind == c.REMESHER:
                _write_remesh(*found, answer.contents)
            else:
                _write(numbers(found, "the answer"), answer.contents)
            return c.DONE
        except Keep as reason:
            told.keep(told.self, str(reason).encode())
            return c.DONE
        except BaseException as problem:  # nobody above could catch it
            told.fail(told.self, _said(problem).encode())
            return c.FAILED


def add(technique: Technique, *, context: Optional[Context] = None) -> Technique:
    """Make a technique known to the pipelines of a context: of the default one, unless you name another. Do it before
    other threads use the context."""
    context, said = context or default_context(), Told()
    status = library().add_plugin(context._pointer, byref(technique._plugin), said.out)
    check(status, said.take())
    context._techniques.append(technique)
    return technique


def _maker(kind: int, doc: str) -> Callable[..., Callable[[Callable[..., Any]], Technique]]:
    def decorator(name: str, options: Sequence[Option] = (), *, metrics: Sequence[Metric] = (), needs: str = "",
                  provides: str = "", breaks: str = "", reference: str = "own", acts_on: str = "", pays_if: str = "",
                  lossless: bool = False,
                  uses_overdraw: bool = False) -> Callable[[Callable[..., Any]], Technique]:
        flags = (c.LOSSLESS if lossless else 0) | (c.USES_OVERDRAW if uses_overdraw else 0)
        return lambda function: Technique(kind, name, function, options, metrics, (needs, provides, breaks), reference,
                                          acts_on, pays_if, flags)

    decorator.__doc__ = doc
    return decorator


_PARAMETERS = """

    Parameters
    ----------
    name : str
        Lower-case letters, digits and hyphens; that of no other technique.
    options : sequence of Option
        The function is called with the draw and these by name; hyphens are underscores in Python.
    metrics : sequence of Metric
        Of an evaluator.
    needs, provides, breaks : str
        Traits with blanks between, such as "clustered": without which a plan is refused; that hold afterwards; that may
        hold no longer.
    acts_on : str
        Traits; draws without them are skipped.
    pays_if : str
        Where it may raise :class:`Keep`: when there is something to gain.
    lossless : bool
        A remesher that draws the same triangles with the same vertex data: it is certified.
    uses_overdraw : bool
        An orderer of triangles or an evaluator that calls ``draw.count_overdraw``.
    """

orderer = _maker(c.TRIANGLE_ORDERER, "Decorate a function that answers with an order of a draw's triangles, "
                                     "``order[new] = old``." + _PARAMETERS)
vertex_orderer = _maker(c.VERTEX_ORDERER, "Decorate a function that answers with an order of vertices, "
                                          "``order[new] = old``." + _PARAMETERS)
clusterer = _maker(c.CLUSTERER, "Decorate a function that answers with offsets into a draw's triangles, from 0 to "
                                "their number." + _PARAMETERS)
remesher = _maker(c.REMESHER, "Decorate a function that answers with other triangles of a draw's vertices: indices of "
                              "the new vertices, three a triangle, and ``vertex_from[new] = old``, of which every "
                              "attribute is copied. There may be no more of either than before." + _PARAMETERS)
evaluator = _maker(c.EVALUATOR, "Decorate a function that answers with a dict of figures: a count, or (numerator, "
                                "denominator), or these and a standard error." + _PARAMETERS)


def _bytes(words: str) -> bytes:
    return text_for_c(words, "a text")


def _option(option: Option, choices: Any) -> c.Option:
    is_text = option.type in (c.TEXT, c.CHOICE)
    initial = c.Value(
        int(option.initial) if option.type in (c.BOOLEAN, c.INTEGER) else 0,
        option.initial if option.type == c.NUMBER else 0.0,
        _bytes(option.initial) if is_text else None,
    )
    return c.Option(*map(_bytes, (option.name, option.doc, option.unit)), option.type, len(choices), choices, initial,
                    option.least, option.most)


def _value(option: Option, value: c.Value) -> Union[bool, int, float, str]:
    if option.type == c.BOOLEAN:
        return bool(value.integer)
    if option.type == c.INTEGER:
        return value.integer
    return value.number if option.type == c.NUMBER else value.text.decode()


def _write(found: np.ndarray, answer: c.Answer) -> None:
    if len(found) > answer.count:
        raise ValueError(f"the answer has {len(found)} numbers, but at most {answer.count} are asked for")
    if len(found) > 0:
        np.ctypeslib.as_array(answer.values, (len(found),))[:] = found
    answer.count = len(found)


def _write_remesh(indices: Any, vertex_from: Any, answer: c.Answer) -> None:
    vertices = c.Answer(answer.vertex_from, answer.vertex_count)
    _write(numbers(np.asarray(indices).reshape(-1), "the indices"), answer)
    _write(numbers(vertex_from, "vertex_from"), vertices)
    answer.vertex_count = vertices.count


def _tell(figures: dict, host: c.Host) -> None:
    for name, figure in figures.items():
        if isinstance(figure, tuple):
            numerator, denominator, error = (*figure, 0.0)[:3]
            host.measure(host.self, name.encode(), numerator, denominator, error)
        else:
            host.count(host.self, name.encode(), figure)


def _said(problem: BaseException) -> str:
    """What it is, and where in the technique it came from."""
    frames = traceback.extract_tb(problem.__traceback__)[1:]
    where = f" (line {frames[-1].lineno} of {frames[-1].filename})" if frames else ""
    return f"{type(problem).__name__}: {problem}{where}"
