#!/usr/bin/python3
"""Makes the tables and the plot of docs/results/particle-trim.md from the figures of particle-trim-bench, and from
those of sprite-fill in tests/golden/sprites.tsv:

    benchmarks/particle_trim/particle_trim_page.py FIGURES.tsv

Debian's python3, for the sake of its matplotlib. What stands between the page's two markers is replaced.
"""

import csv
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/results/particle-trim.md"
PLOT = ROOT / "docs/results/particle-trim.svg"
FILLED = ROOT / "tests/golden/sprites.tsv"
sys.path.insert(0, str(ROOT / "benchmarks/plots"))
from page import replaced

THRESHOLDS = ["0", "0.1"]
MIPS = ", mip-levels = 2"
ATLAS = "generated_atlas"
DEFAULT_EDGES = "24"
BESIDE = ["upright rectangle", "turned rectangle", "parallelogram", "hull"]
# Persson's one texture, of his paper: the upright rectangle and polygons of 3 to 8 vertices.
PUBLISHED = {"rectangle": 69.23, "3": 70.66, "4": 60.16, "5": 55.60, "6": 53.94, "7": 52.31, "8": 51.90}


def setting(row):
    return row["threshold"] + ("" if row["mip levels"] == "0" else f", mip-levels = {row['mip levels']}")


class Figures:
    """Threshold and mip levels are one: "0.1", or "0.1, mip-levels = 2". Areas by (method, edges, vertices, threshold) ->
    texture -> row; times in milliseconds of work by (texture, method, edges, vertices, threshold, threads)."""

    def __init__(self, path):
        self.areas, self.hull_edges, self.times, self.passed = defaultdict(dict), {}, {}, {}
        self.sprites_of = {}
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file, delimiter="\t"):
                method, texture = row["method"], row["texture"]
                if method == "hull":
                    self.hull_edges[texture, setting(row)] = row["vertices"]
                    self.sprites_of[texture] = int(row["sprites"])
                way = method, row["hull edges"], "" if method in BESIDE else row["vertices"], setting(row)
                if row["worked"]:
                    self.times[texture, *way, row["threads"]] = float(row["worked"])
                    self.passed[texture, *way, row["threads"]] = float(row["milliseconds"])
                if row["area"] and texture != ATLAS:
                    self.areas[way][texture] = row
        self.textures = list(self.areas["hull", "", "", "0"])
        missing = [way for way, areas in self.areas.items() if set(areas) != set(self.textures)]
        if missing:
            sys.exit(f"{missing[0]} lacks textures: means need whole runs")
        self.sprites = sum(self.sprites_of[texture] for texture in self.textures)

    def area(self, way):
        """In the mean over all sprites, each counting alike."""
        return sum(float(row["area"]) * int(row["sprites"]) for row in self.areas[way].values()) / self.sprites

    def areas_from_to(self, way):
        rows = self.areas[way].values()
        return min(float(row["least area"]) for row in rows), max(float(row["most area"]) for row in rows)

    def time(self, way):
        """Of a sprite, in the mean."""
        return sum(self.times[texture, *way, "1"] for texture in self.textures) / self.sprites

    def vertices(self, method, edges):
        return sorted({int(n) for m, e, n, _ in self.areas if (m, e) == (method, edges)})

    def edges(self):
        return sorted({int(edges) for _, edges, _, _ in self.areas if edges})


def table(heads, rows, texts=1):
    lines = [heads, ["---"] * texts + ["---:"] * (len(heads) - texts), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def percent(fraction):
    return f"{100 * fraction:.2f}"


def mean_and_range(figures, way):
    if way not in figures.areas:
        return ""
    least, most = figures.areas_from_to(way)
    return f"{percent(figures.area(way))} ({100 * least:.1f} to {100 * most:.1f})"


def by_vertices(figures):
    rows = []
    for name in BESIDE:
        if (name, "", "", "0") in figures.areas:
            row = [name]
            for threshold in THRESHOLDS:
                row += [mean_and_range(figures, (name, "", "", threshold)), ""]
            rows.append(row)
    for n in figures.vertices("optimal", ""):
        row = [f"{n} vertices"]
        for threshold in THRESHOLDS:
            for method, edges in (("optimal", ""), ("persson", DEFAULT_EDGES)):
                row.append(mean_and_range(figures, (method, edges, str(n), threshold)))
        rows.append(row)
    heads = ["shape", *(f"threshold {t}: {m}" for t in THRESHOLDS for m in ("optimal", "persson"))]
    return table(heads, rows)


def beside_persson(figures):
    """His figures for one texture, ours for the corpus: all in per cent of the frame."""
    rows = [["upright rectangle", f"{PUBLISHED['rectangle']:.2f}", mean_and_range(figures, ("upright rectangle", "", "", "0")), ""]]
    for n in range(3, 9):
        rows.append([f"{n} vertices", f"{PUBLISHED[str(n)]:.2f}",
                     mean_and_range(figures, ("persson", DEFAULT_EDGES, str(n), "0")),
                     mean_and_range(figures, ("optimal", "", str(n), "0"))])
    return table(["shape", "his texture", "corpus, persson", "corpus, optimal"], rows)


def with_mipmaps(figures):
    ways = [(name, "", "") for name in BESIDE if (name, "", "", "0") in figures.areas] + [
        ("optimal", "", "8"), ("persson", DEFAULT_EDGES, "8")]
    rows = [[name + (f", {n} vertices" if n else ""), *(mean_and_range(figures, (name, edges, n, threshold + with_mips))
                                                        for threshold in THRESHOLDS for with_mips in ("", MIPS))]
            for name, edges, n in ways]
    return table(["shape", *(f"threshold {t}{m or ', mip-levels = 0'}" for t in THRESHOLDS for m in ("", MIPS))], rows)


def times_of_eight(figures, threshold):
    rows = []
    for texture in figures.textures:
        time = {method: figures.times[texture, method, e, n, threshold, "1"]
                for method, e, n in (("alpha", "", ""), ("hull", "", ""), ("optimal", "", "8"), ("persson", DEFAULT_EDGES, "8"))}
        rows.append([texture.replace("_", " "), str(figures.sprites_of[texture]), figures.hull_edges[texture, threshold],
                     *(f"{time[method]:.2f}" for method in ("alpha", "hull", "optimal", "persson")),
                     f"{time['persson'] / time['optimal']:.2f}"])
    return table(["texture", "sprites", "hull: edges", "alpha, ms", "and hulls, ms", "and all, optimal, ms", "persson, ms",
                  "persson / optimal"], rows)


def atlas(figures):
    rows = []
    for threshold in [threshold + mips for threshold in THRESHOLDS for mips in ("", MIPS)]:
        for method, edges in (("optimal", ""), ("persson", DEFAULT_EDGES)):
            key = ATLAS, method, edges, "8", threshold
            rows.append([threshold, method, *(f"{kind[*key, threads]:.0f}" for threads in "12" for kind in (figures.passed, figures.times))])
    return table(["threshold", "method", "1 thread: ms", "of work", "2 threads: ms", "of work"], rows, texts=2)


def errors(figures):
    rows = []
    for method, edges in [("persson", str(edges)) for edges in figures.edges()] + [("optimal", "")]:
        row = [f"persson, hull-edges = {edges}" if edges else method]
        for threshold in THRESHOLDS:
            way, best = (method, edges, "8", threshold), ("optimal", "", "8", threshold)
            row += [percent(figures.area(way)), f"{100 * (figures.area(way) / figures.area(best) - 1):.2f}", f"{figures.time(way):.2f}"]
        rows.append(row)
    return table(["", *(head for t in THRESHOLDS for head in (f"threshold {t}: area, %", "above the smallest, %", "ms a sprite"))], rows)


def filled():
    """Of tests/golden/sprites.tsv: pixels that show, filled before, and after each trimming."""
    rows, sums = [], defaultdict(float)
    for line in FILLED.read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            continue
        name, *trimmings = line.split("\t")
        row = [name.replace("_", " ")]
        for i, trimming in enumerate(trimmings):
            _, needed, before, after = trimming.split()
            if i in (0, 3):  # as many pixels show at each of the first three
                row.append(f"{int(before) / int(needed):.2f}")
                sums[i, "before"] += int(before)
                sums[i, "needed"] += int(needed)
            row.append(f"{int(after) / int(needed):.2f}")
            sums[i, "after"] += int(after)
        rows.append(row)
    needed = [sums[0, "needed"]] * 3 + [sums[3, "needed"]]
    last = ["all"]
    for i in range(4):
        last += [f"{sums[i, 'before'] / needed[i]:.2f}"] if i in (0, 3) else []
        last.append(f"{sums[i, 'after'] / needed[i]:.2f}")
    return table(["texture", "quad", "3 vertices", "4", "8", "with mipmaps: quad", "8"], rows + [last])


def tables(figures):
    text = "\n### Area by vertices\n\n" + by_vertices(figures)
    text += "\n### Beside the published figures\n\n" + beside_persson(figures)
    text += "\n### Eight vertices where smaller versions may be sampled\n\n" + with_mipmaps(figures)
    for threshold in [threshold + mips for threshold in THRESHOLDS for mips in ("", MIPS)]:
        text += f"\n### Time, 8 vertices, threshold {threshold}\n\n" + times_of_eight(figures, threshold)
    text += "\n### A large atlas\n\n" + atlas(figures)
    text += "\n### The reduced hull: error against time\n\n" + errors(figures)
    return text + "\n### Pixels filled for each that shows\n\n" + filled()


def panels(figures):
    from quality_against_time import Panel, Point

    made = []
    for threshold, worst, worst_of_time in (("0", 0.69, 0.61), ("0.1", 0.48, 0.37)):
        limits = [(name, figures.area((name, "", "", threshold))) for name in ("upright rectangle", "parallelogram", "hull")
                  if (name, "", "", threshold) in figures.areas]
        points = [Point(method, "", n, figures.area((method, edges, str(n), threshold)))
                  for method, edges in (("persson", DEFAULT_EDGES), ("optimal", "")) for n in figures.vertices(method, edges)]
        made.append(Panel(f"threshold {threshold}", points, limits, axis="vertices",
                          ticks=[3, 4, 5, 6, 7, 8, 10, 12, 14, 16], worst=worst))
        points = []
        for method, edges in [("persson", str(edges)) for edges in figures.edges()] + [("optimal", "")]:
            for n in (4, 6, 8):
                way = method, edges, str(n), threshold
                points.append(Point(method, f"{edges} / {n}" if edges else str(n), figures.time(way), figures.area(way)))
        made.append(Panel(f"threshold {threshold}", points, axis="ms a sprite, on one thread", worst=worst_of_time))
    return made


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    from quality_against_time import write_svg

    figures = Figures(sys.argv[1])
    PAGE.write_text(replaced(PAGE, tables(figures)), encoding="utf-8")
    write_svg(PLOT, panels(figures), "", "area, of the frame", worst=1, size=(5.4, 3.8))


if __name__ == "__main__":
    main()
