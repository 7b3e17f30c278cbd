#!/usr/bin/python3
"""Makes the tables and the plot of docs/results/overdraw-error.md from the figures of overdraw-error-bench:

    benchmarks/overdraw_error/overdraw_error_page.py FIGURES.tsv

Debian's python3, for the sake of its matplotlib. What stands between the page's two markers is replaced.
"""

import csv
import sys
from collections import defaultdict
from pathlib import Path
from statistics import geometric_mean

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/results/overdraw-error.md"
PLOT = ROOT / "docs/results/overdraw-error.svg"
sys.path.insert(0, str(ROOT / "benchmarks/plots"))
from page import replaced


class Figures:
    """Rows of the file by who measured how: (evaluator, sampling, views, size) -> model -> row."""

    def __init__(self, path):
        self.truths, self.by_way = {}, defaultdict(dict)
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file, delimiter="\t"):
                if row["evaluator"] == "truth":
                    self.truths[row["model"]] = row
                else:
                    way = row["evaluator"], row["sampling"], row["views"], row["size"]
                    self.by_way[way][row["model"]] = row
        missing = [way for way, rows in self.by_way.items() if set(rows) != set(self.truths)]
        if missing:
            sys.exit(f"{missing[0]} lacks models: means need whole runs")

    def mean(self, way, column):
        """Geometric, over the models. An error of 0 counts as what the truth is known to."""
        return geometric_mean(max(float(row[column]), float(self.truths[model]["error"]), 1e-7)
                              for model, row in self.by_way[way].items())

    def fixed(self):
        return [way for way in self.by_way if way[2]]

    def wanted(self):
        return [way for way in self.by_way if not way[2]]


def name(evaluator, sampling):
    return evaluator + (f", {sampling}" if sampling else "")


def table(heads, rows, texts=1):
    lines = [heads, ["---"] * texts + ["---:"] * (len(heads) - texts), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def truths(figures):
    rows = [[model, f"{float(row['within']):.5f}", f"{float(row['error']):.0e}"] for model, row in figures.truths.items()]
    return table(["model", "overdraw", "known to"], rows)


def grid(figures, evaluator, sampling):
    """Error and time for each number of views (down) and size (across)."""
    ways = [way for way in figures.fixed() if way[:2] == (evaluator, sampling)]
    sizes = sorted({int(way[3]) for way in ways})
    counts = sorted({int(way[2]) for way in ways})
    rows = []
    for count in counts:
        row = [str(count)]
        for size in sizes:
            way = evaluator, sampling, str(count), str(size)
            known = way in figures.by_way
            row.append(f"{figures.mean(way, 'error'):.1e}, {figures.mean(way, 'milliseconds'):.3g} ms" if known else "")
        rows.append(row)
    return table(["views"] + [f"{size} x {size}" for size in sizes], rows)


def wanted(figures):
    rows = []
    for way in figures.wanted():
        models = figures.by_way[way].values()
        trials = sum(int(row["seeds"]) for row in models)
        within = sum(int(row["within"]) for row in models)
        rows.append([way[1], f"{within} of {trials}", f"{figures.mean(way, 'error'):.1e}",
                     f"{figures.mean(way, 'claimed'):.1e}", f"{figures.mean(way, 'milliseconds'):.3g}"])
    return table(["option", "nearer to the truth than wanted", "error", "reported", "ms"], rows)


def tables(figures):
    kinds = list(dict.fromkeys(way[:2] for way in figures.fixed()))
    text = "\n### The models\n\n" + truths(figures)
    for kind in kinds:
        text += f"\n### {name(*kind)}\n\n" + grid(figures, *kind)
    text += "\n### `overdraw-raster` where an error is asked for\n\n" + wanted(figures)
    return text


def panel(figures):
    from quality_against_time import Panel, Point

    points = []
    for way in figures.by_way:
        evaluator, sampling, count, size = way
        family = name(evaluator, sampling) if count else f"{evaluator}, error = e"
        label = f"{count} / {size}" if count else sampling.removeprefix("error = ")
        points.append(Point(family, label, figures.mean(way, "milliseconds"), figures.mean(way, "error")))
    return Panel("", points)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    from quality_against_time import write_svg

    figures = Figures(sys.argv[1])
    PAGE.write_text(replaced(PAGE, tables(figures)), encoding="utf-8")
    write_svg(PLOT, [panel(figures)], "ms on one thread", "error of the ratio", worst=0.05, columns=1, size=(9.5, 7),
              is_log=True)


if __name__ == "__main__":
    main()
