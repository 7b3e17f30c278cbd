#!/usr/bin/python3
"""Makes the tables and the plot of docs/results/vertex-orders.md from the figures of vertex-order-bench:

    benchmarks/vertex_order/vertex_orders_page.py FIGURES.tsv

Debian's python3, for the sake of its matplotlib. What stands between the page's two markers is replaced.
"""

import csv
import re
import sys
from collections import defaultdict
from pathlib import Path
from statistics import fmean, geometric_mean

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/results/vertex-orders.md"
PLOT = ROOT / "docs/results/vertex-orders.svg"
sys.path.insert(0, str(ROOT / "benchmarks/plots"))
from page import replaced

PEER = ("meshopt_optimizeVertexCacheFifo", "cache-size=16")  # what all are compared with
AS_IT_COMES = ("as it comes", "")
SIZES = ["below 10k", "10k to 300k", "above 800k"]
ARRANGEMENTS = {"own": "own order", "t": "/t", "tv": "/tv"}
CACHES = ["fifo-12", "fifo-16", "fifo-20", "fifo-24", "fifo-32", "lru-16", "nvidia", "amd", "intel"]
ACMR = "ACMR fifo-16"
TIME = "ns a triangle"


class Figures:
    """The raw figures, by who orders what."""

    def __init__(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file, delimiter="\t"))
        self.rows = {(who(row), row["meshes"], row["arrangement"]): row for row in rows}
        self.orders = list(dict.fromkeys(who(row) for row in rows if row["order"] != "strips"))
        self.meshes = defaultdict(list)  # by size
        for row in rows:
            if row["meshes"] not in self.meshes[row["size"]]:
                self.meshes[row["size"]].append(row["meshes"])
        self.repetitions = sorted({int(row["repetitions"]) for row in rows if row["repetitions"]})
        self.arrangements = [a for a in ARRANGEMENTS if any(row["arrangement"] == a for row in rows)]

    def values(self, order, column, sizes=SIZES, arrangements=None):
        """One for each mesh set and arrangement in which the figure was taken."""
        found = []
        for arrangement in arrangements or self.arrangements:
            for meshes in (m for size in sizes for m in self.meshes[size]):
                row = self.rows.get((order, meshes, arrangement))
                if row is None:
                    sys.exit(f"{name(order)} has no figures on {meshes}, {arrangement}: means need whole runs, "
                             "without --benchmark_filter")
                if row[column]:
                    found.append(float(row[column]))
        return found

    def time(self, order, *where):
        times = self.values(order, TIME, *where)
        return geometric_mean(times) if times else None

    def mean(self, order, column, *where):
        values = self.values(order, column, *where)
        return fmean(values) if values else None


def who(row):
    return row["order"], row["setting"]


def name(order):
    return " ".join(filter(None, order))


def cells(order):
    return [f"`{order[0]}`" if order != AS_IT_COMES else order[0], order[1].replace("cache-size=", "")]


def number(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def ratio(value, peers, digits):
    return "" if value is None or not peers else f"{value / peers:.{digits}f}"


def table(heads, rows):
    lines = [heads, ["---", "---"] + ["---:"] * (len(heads) - 2), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def means(figures):
    heads = ["order", "setting", "ns a triangle"]
    heads += [f"time, {ARRANGEMENTS[a]}" for a in figures.arrangements]
    heads += ["FIFO 16 / peer's"] + [c.replace("-", " ").upper() if c[-1].isdigit() else c for c in CACHES]
    heads += ["ATVR", "OVR"]
    rows = []
    for order in figures.orders:
        row = cells(order) + [number(figures.time(order), 1)]
        row += [ratio(figures.time(order, SIZES, [a]), figures.time(PEER, SIZES, [a]), 2) for a in figures.arrangements]
        row.append(ratio(figures.mean(order, ACMR), figures.mean(PEER, ACMR), 4))
        row += [number(figures.mean(order, "ACMR " + cache), 4) for cache in CACHES]
        row += [number(figures.mean(order, "ATVR"), 4), number(figures.mean(order, "OVR"), 4)]
        rows.append(row)
    once = number(each_vertex_once(figures, figures.arrangements), 4)
    blanks = [""] * (len(heads) - len(CACHES) - 5)
    return table(heads, rows + [["each vertex once", ""] + blanks + [""] + [once] * len(CACHES) + ["1", ""]])


def each_vertex_once(figures, arrangements):
    """The ACMR below which no order can come, whatever the cache: vertices a triangle, mean over the sets."""
    acmr, atvr = (figures.values(PEER, column, SIZES, arrangements) for column in (ACMR, "ATVR"))
    return fmean(misses / per_vertex for misses, per_vertex in zip(acmr, atvr))


def size_classes(figures):
    places = [([size], [a]) for size in SIZES if figures.meshes[size] for a in figures.arrangements]
    heads = ["order", "setting"] + [f"{size[0]}, {ARRANGEMENTS[a[0]]}" for size, a in places]
    rows = []
    for order in figures.orders:
        row = cells(order)
        for place in places:
            time = ratio(figures.time(order, *place), figures.time(PEER, *place), 2) or "-"
            row.append(time + ", " + ratio(figures.mean(order, ACMR, *place), figures.mean(PEER, ACMR, *place), 4))
        rows.append(row)
    return table(heads, rows)


def grids(figures):
    places = [(grid, a) for grid in figures.meshes["grid"] for a in figures.arrangements]
    heads = ["order", "setting"] + [f"{grid.removeprefix('grid ')}, {ARRANGEMENTS[a]}" for grid, a in places]
    strips = sorted({order for order, _, _ in figures.rows if order[0] == "strips"})
    rows = []
    for order in figures.orders + strips:
        found = [figures.rows.get((order, *place)) for place in places]
        rows.append(cells(order) + [number(row and float(row[ACMR]), 4) for row in found])
    return table(heads, rows)


def tables(figures):
    mesh_sets = "; ".join(f"{size}: {', '.join(figures.meshes[size])}" for size in SIZES if figures.meshes[size])
    return f"""
### All meshes

Means over the sets and their arrangements. Times are medians of {" or ".join(map(str, figures.repetitions))}, the ratios
over the peer's, `{PEER[0]}` for 16 entries; ACMR by cache.

{means(figures)}
### By size

Time over the peer's, then ACMR (FIFO of 16) over the peer's. {mesh_sets}.

{size_classes(figures)}
### Grids

ACMR, FIFO of 16. `strips` know that it is a grid.

{grids(figures)}
"""


def points(figures, sizes_or_grid, arrangement):
    from quality_against_time import Point

    found = []
    for order in figures.orders:
        if order == AS_IT_COMES:
            continue
        if sizes_or_grid == SIZES:
            time, acmr = figures.time(order, SIZES, [arrangement]), figures.mean(order, ACMR, SIZES, [arrangement])
        else:
            row = figures.rows[order, sizes_or_grid, arrangement]
            time, acmr = float(row[TIME]), float(row[ACMR])
        found.append(Point(order[0], re.sub(r"[\w-]+=", "", order[1]), time, acmr))
    return found


def panels(figures):
    from quality_against_time import Panel

    titles = {"own": "all meshes, in their own order", "t": "triangles shuffled (/t)",
              "tv": "triangles and vertices shuffled (/tv)"}
    regular = ("0.5, limit of large regular meshes", 0.5)
    result = [Panel(titles[a], points(figures, SIZES, a),
                    [("each vertex once", each_vertex_once(figures, [a])), regular]) for a in figures.arrangements]
    for grid in figures.meshes["grid"][-1:]:
        strips = [(f"{order[1]} strips", float(row[ACMR])) for (order, meshes, _), row in figures.rows.items()
                  if order[0] == "strips" and meshes == grid]
        result.append(Panel(f"{grid}, in its own order", points(figures, grid, "own"),
                            [*strips, regular]))
    return result


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    figures = Figures(sys.argv[1])
    PAGE.write_text(replaced(PAGE, tables(figures)), encoding="utf-8")
    from quality_against_time import write_svg

    write_svg(PLOT, panels(figures), "ns a triangle", "ACMR, FIFO of 16", worst=0.78)


if __name__ == "__main__":
    main()
