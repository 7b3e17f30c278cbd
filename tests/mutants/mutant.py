"""A mutant, and the place of its line in a tree: found by what stands around it, as files and lines move."""

import re
from dataclasses import dataclass, fields
from pathlib import Path

from code_lines import code_lines

PLACES = ("framework", "plugins", "evaluators")  # mutants are drawn from here
MOVED_TO = (*PLACES, "hosts")                    # and may be found there later
ENDINGS = (".cpp", ".h")


@dataclass(frozen=True)
class Mutant:
    id: str
    kind: str
    file: str
    function: str  # the first line of what the line is in: the nearest above that is not indented
    above: str     # the code line before it
    line: str
    below: str
    changed: str


def read_mutants(path):
    rows = [line.split("\t") for line in Path(path).read_text(encoding="utf-8").splitlines()]
    return [Mutant(*row) for row in rows[1:]]


def write_mutants(path, mutants):
    names = [field.name for field in fields(Mutant)]
    rows = [names] + [[getattr(mutant, name) for name in names] for mutant in mutants]
    Path(path).write_text("".join("\t".join(row) + "\n" for row in rows), encoding="utf-8")


class Source:
    """A file's lines, and what stands around each."""

    def __init__(self, text):
        self.lines = text.split("\n")
        self.code = list(code_lines(text))
        self.place_of = {number: place for place, (number, _) in enumerate(self.code)}

    def around(self, number):
        """(function, above, below) of a line of code, stripped, as they stand in the file."""
        function = next((self.lines[n] for n in range(number, -1, -1) if re.match(r"[A-Za-z]", self.lines[n])), "")
        place = self.place_of[number]
        near = [self.lines[self.code[p][0]].strip() if 0 <= p < len(self.code) else "" for p in (place - 1, place + 1)]
        return function, *near


def files_of(tree, folders=MOVED_TO):
    for folder in folders:
        for path in sorted((Path(tree) / folder).rglob("*")):
            if path.suffix in ENDINGS:
                yield path.relative_to(tree).as_posix()


def place(mutant, tree):
    """(file, number of the line, from 0) in a tree, or None where the line is gone or several are as like."""
    found = {}
    for file in files_of(tree):
        text = (Path(tree) / file).read_text(encoding="utf-8")
        if mutant.line not in text:
            continue
        source = Source(text)
        for number, _ in source.code:
            if source.lines[number].strip() != mutant.line:
                continue
            function, above, below = source.around(number)
            same_file = 4 if file == mutant.file else 3 * (Path(file).name == Path(mutant.file).name)
            likeness = (same_file + 3 * (function == mutant.function) + 2 * (above == mutant.above) +
                        2 * (below == mutant.below))
            found.setdefault(likeness, []).append((file, number))
    best = max(found, default=0)
    return found[best][0] if best >= 6 and len(found[best]) == 1 else None


def apply(mutant, tree, file, number):
    """Writes the changed line; answers with the text as it was."""
    path = Path(tree) / file
    text = path.read_text(encoding="utf-8")
    lines = text.split("\n")
    indent = lines[number][:len(lines[number]) - len(lines[number].lstrip())]
    lines[number] = indent + mutant.changed
    path.write_text("\n".join(lines), encoding="utf-8")
    return text
