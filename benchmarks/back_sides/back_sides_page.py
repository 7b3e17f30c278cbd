#!/usr/bin/python3
"""Makes the plots of docs/guides/sides.md, docs/guides/hidden.md and docs/guides/draw-sequence.md from their figures:

    benchmarks/back_sides/back_sides_page.py [benchmarks/back_sides/figures.tsv]

Debian's python3, for the sake of its matplotlib. Each row is a point of a page's plot: the panel, the family that it
belongs to, its label, and what it costs and leaves. overdraw.md says how rows are measured.
"""

import csv
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FIGURES = ROOT / "benchmarks/back_sides/figures.tsv"
sys.path.insert(0, str(ROOT / "benchmarks/plots"))
from quality_against_time import Panel, Point, write_svg

# Page: what a point costs, what it leaves, and whether that grows by factors.
AXES = {
    "sides": ("seconds of the processor", "pixels that changed, of a million", True),
    "hidden": ("samples: pictures, rays of a triangle, pictures that check", "pixels that changed, of a million", False),
    "draw-sequence": ("seconds of the processor, all stages", "fragments shaded for each pixel seen", False),
}


def panels_of(path):
    """Page -> its panels, in the rows' order."""
    pages = {page: {} for page in AXES}
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter="\t"):
            panel = pages[row["page"]].setdefault(row["panel"], Panel(row["panel"], []))
            panel.points.append(Point(row["family"], row["label"], float(row["cost"]), float(row["left"])))
    return {page: list(panels.values()) for page, panels in pages.items()}


def main():
    for page, panels in panels_of(sys.argv[1] if len(sys.argv) > 1 else FIGURES).items():
        cost, left, is_log = AXES[page]
        for panel in panels:
            panel.worst = 1.04 * max(point.quality for point in panel.points)
        write_svg(ROOT / f"docs/guides/{page}.svg", panels, cost, left, worst=0, columns=len(panels), size=(4.4, 3.2),
                  is_log=is_log)


if __name__ == "__main__":
    main()
