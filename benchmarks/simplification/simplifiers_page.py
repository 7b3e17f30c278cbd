#!/usr/bin/python3
"""Makes the tables and the plot of docs/results/simplifiers.md from the figures of simplifiers-bench:

    benchmarks/simplification/simplifiers_page.py FIGURES.tsv

Debian's python3, for the sake of its matplotlib. What stands between the page's two markers is replaced.
"""

import csv
import sys
from collections import defaultdict
from pathlib import Path
from statistics import geometric_mean

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/results/simplifiers.md"
PLOT = ROOT / "docs/results/simplifiers.svg"
sys.path.insert(0, str(ROOT / "benchmarks/plots"))
from page import replaced
from quality_against_time import Panel, Point, write_svg

OURS, PEER = "quadric-collapse, optimal", "meshopt_simplifyWithUpdate"
ON_TWO = "quadric-collapse, two threads"
LINDSTROM_TURK = "cgal-collapse, Lindstrom-Turk"


class Figures:
    """Rows of the file: [kept][simplifier][mesh], from fine to coarse."""

    def __init__(self, path):
        self.rows = defaultdict(lambda: defaultdict(dict))
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file, delimiter="\t"):
                self.rows[row["kept"]][row["simplifier"]][row["mesh"]] = row

    def ratios(self, kept, name, column, to=PEER):
        """Of each mesh that both were run on."""
        ours, theirs = self.rows[kept][name], self.rows[kept][to]
        return {mesh: float(row[column]) / float(theirs[mesh][column]) for mesh, row in ours.items() if mesh in theirs}

    def mean(self, kept, name, column, to=PEER):
        return geometric_mean(self.ratios(kept, name, column, to).values())


def table(heads, rows, texts=1):
    lines = [heads, ["---"] * texts + ["---:"] * (len(heads) - texts), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def percent(kept):
    return f"{100 * float(kept):g} %"


def all_simplifiers(figures):
    rows = []
    for name in next(iter(figures.rows.values())):
        cells = []
        for kept in figures.rows:
            cells += [f"{figures.mean(kept, name, column):.2f}" for column in ("rms", "largest", "seconds")]
        meshes = len(figures.ratios(next(iter(figures.rows)), name, "rms"))
        rows.append([name, str(meshes), *cells])
    heads = [f"{figure}, {percent(kept)}" for kept in figures.rows for figure in ("rms", "largest", "time")]
    return table(["simplifier", "meshes", *heads], rows)


def mesh_by_mesh(figures):
    rows = []
    for kept, simplifiers in figures.rows.items():
        for mesh, own in simplifiers[OURS].items():
            peer = simplifiers[PEER][mesh]
            ratios = [f"{figures.ratios(kept, OURS, column)[mesh]:.3f}" for column in ("rms", "largest")]
            rows.append([mesh, own["triangles"], percent(kept), f"{own['left']} / {peer['left']}",
                         f"{float(own['rms']):.4f}", *ratios,
                         f"{figures.ratios(kept, OURS, 'seconds')[mesh]:.2f}", f"{1000 * float(own['seconds']):.1f}"])
    rows.sort(key=lambda row: list(figures.rows["0.5"][OURS]).index(row[0]))
    return table(["mesh", "triangles", "kept", "left, ours / peer", "rms, % of the diagonal", "rms / peer's",
                  "largest / peer's", "time / peer's", "ours, ms"], rows)


def means_and_worst(figures, name, to):
    rows = []
    for kept in figures.rows:
        cells = []
        for column in ("rms", "largest", "seconds"):
            ratios = figures.ratios(kept, name, column, to).values()
            cells.append(f"{geometric_mean(ratios):.3f} ({max(ratios):.3f})")
        rows.append([percent(kept), *cells])
    return table(["kept", "rms, mean (worst)", "largest, mean (worst)", "time, mean (worst)"], rows)


def chain(figures, name):
    """Ours has all levels when it has the coarsest."""
    coarsest = list(figures.rows)[-1]
    return geometric_mean(
        float(own["seconds"]) / sum(float(rows[PEER][mesh]["seconds"]) for rows in figures.rows.values())
        for mesh, own in figures.rows[coarsest][name].items())


def large(figures, kept, least=50_000):
    """What two threads take there of the time of one."""
    rows = figures.rows[kept][OURS]
    ratios = figures.ratios(kept, ON_TWO, "seconds", OURS)
    return geometric_mean(ratio for mesh, ratio in ratios.items() if int(rows[mesh]["triangles"]) > least)


def panels(figures):
    made = []
    for kept, simplifiers in figures.rows.items():
        points = [Point(name, "", figures.mean(kept, name, "seconds"), figures.mean(kept, name, "rms"))
                  for name in simplifiers]
        made.append(Panel(f"{percent(kept)} of the triangles", points))
    return made


def main():
    figures = Figures(sys.argv[1])
    write_svg(PLOT, panels(figures), "time, of meshopt_simplifyWithUpdate's", "rms distance, of meshopt_simplifyWithUpdate's",
              worst=1.75)
    text = "## All simplifiers\n\n" + all_simplifiers(figures)
    text += "\n## `quadric-collapse` beside `meshopt_simplifyWithUpdate`\n\n" + means_and_worst(figures, OURS, PEER)
    text += (f"\nOne sequence for all four, beside four calls of the peer: {chain(figures, OURS):.2f} times the time, and on "
             f"two threads, by the clock, {chain(figures, ON_TWO):.2f} times. Two threads take ")
    text += ", ".join(f"{figures.mean(kept, ON_TWO, 'seconds', OURS):.2f}" for kept in figures.rows)
    text += " of the time of one, and on meshes of more than 50,000 triangles "
    text += ", ".join(f"{large(figures, kept):.2f}" for kept in figures.rows) + ".\n\n"
    text += mesh_by_mesh(figures)
    if any(LINDSTROM_TURK in simplifiers for simplifiers in figures.rows.values()):
        text += "\n## `quadric-collapse` beside CGAL's Lindstrom-Turk\n\n" + means_and_worst(figures, OURS, LINDSTROM_TURK)
    PAGE.write_text(replaced(PAGE, text), encoding="utf-8")


if __name__ == "__main__":
    main()
