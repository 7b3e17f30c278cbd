#!/usr/bin/python3
"""Makes the tables and plots of docs/results/han-sander-2016.md from the figures of han-sander-2016-bench:

    benchmarks/han_sander_2016/han_sander_2016_page.py FIGURES.tsv

Debian's python3, for the sake of its matplotlib. What stands between the page's two markers is replaced.
"""

import csv
import sys
from collections import defaultdict
from pathlib import Path
from statistics import geometric_mean, mean

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/results/han-sander-2016.md"
PLOT = ROOT / "docs/results/han-sander-2016-{}.svg"
sys.path.insert(0, str(ROOT / "benchmarks/plots"))
from page import replaced

SMALLEST = 0.01  # excess above which a motion counts in the means
COLUMNS = [("original", "", "1", "original"),
           ("dot-rule", "patches", "0", "dot-rule per keyframe"),
           ("dot-rule", "lambda = 3", "0", "dot-rule per keyframe, lambda 3"),
           ("animated-kmeans", "patches", "5", "single"),
           ("animated-kmeans", "lambda = 3", "5", "single, lambda 3"),
           ("animated-kmeans joint", "patches", "5", "joint"),
           ("animated-kmeans joint", "lambda = 3", "5", "joint, lambda 3"),
           ("occlusion-order", "", "5", "occlusion-order, k = 5"),
           ("occlusion-order", "", "1", "occlusion-order, k = 1")]


class Figures:
    """Rows by motion, then by (method, patches, k); sweeps apart. Where a row's patches are not those of lambda 3, they are
    the model's own."""

    def __init__(self, path):
        self.motions, self.sweeps = defaultdict(dict), []
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file, delimiter="\t"):
                if row["method"].startswith("sweep "):
                    self.sweeps.append(row)
                    continue
                of_patches = row["cut"] not in ("", "lambda = 3")
                row["way"] = row["method"], "patches" if of_patches else row["cut"], row["k"]
                self.motions[row["model"], row["motion"]][row["way"]] = row
        for motion, rows in self.motions.items():
            for way in [column[:3] for column in COLUMNS if "joint" not in column[0]] + [("least", "", "0")]:
                if way not in rows:
                    sys.exit(f"{' '.join(motion)} lacks {' '.join(way)}: run the benchmark to its end")

    def models(self):
        return list(dict.fromkeys(model for model, _ in self.motions))

    def of_model(self, model):
        return [rows for (name, _), rows in self.motions.items() if name == model]

    def excess(self, rows, way, above_least=False):
        return float(rows[way]["ratio"]) - (float(rows["least", "", "0"]["ratio"]) if above_least else 1)

    def part(self, way, of, above_least):
        """Geometric mean over the motions in which what is compared with leaves more than the smallest excess; how many."""
        parts = [max(self.excess(rows, way, above_least), 1e-6) / self.excess(rows, of, above_least)
                 for rows in self.motions.values()
                 if way in rows and of in rows and self.excess(rows, of, above_least) > SMALLEST]
        return (geometric_mean(parts), max(parts), len(parts)) if parts else None


def table(heads, rows, texts=1):
    lines = [heads, ["---"] * texts + ["---:"] * (len(heads) - texts), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def overall(figures):
    heads = ["model", "patches", "triangles", "motions", "keyframes", "least"] + [column[3] for column in COLUMNS]
    lines = []
    for model in figures.models():
        motions = figures.of_model(model)
        first = motions[0]["animated-kmeans", "patches", "5"]
        keyframes = "/".join(rows["original", "", "1"]["keyframes"] for rows in motions)
        line = [model, first["cut"], first["triangles"], str(len(motions)), keyframes,
                f"{mean(float(rows['least', '', '0']['ratio']) for rows in motions):.3f}"]
        for column in COLUMNS:
            there = [rows[column[:3]] for rows in motions if column[:3] in rows]
            line.append(f"{mean(float(row['acmr']) for row in there):.3f}, {mean(float(row['ratio']) for row in there):.4f}"
                        if there else "")
        lines.append(line)
    return table(heads, lines, 2)


def by_motion(figures):
    ways = [column for column in COLUMNS if column[1] != "lambda = 3"]
    lines = [[model, motion.replace("|", "\\|")] + [f"{float(rows[way[:3]]['ratio']):.4f}" if way[:3] in rows else "" for way in ways]
             for (model, motion), rows in figures.motions.items()]
    return table(["model", "motion"] + [way[3] for way in ways], lines, 2)


def times(figures):
    ways = [column for column in COLUMNS if column[0] not in ("original", "dot-rule")]
    lines = []
    for model in figures.models():
        line = [model]
        for way in ways:
            seconds = [float(rows[way[:3]]["seconds"]) for rows in figures.of_model(model) if way[:3] in rows]
            line.append(" / ".join(f"{s:.2f}" for s in (seconds[:1] if "joint" in way[0] else seconds)))
        lines.append(line)
    return table(["model"] + [way[3] for way in ways], lines)


def parts(figures):
    single, five, one = COLUMNS[3][:3], COLUMNS[7][:3], COLUMNS[8][:3]
    asked = [("animated-kmeans single", single, "dot-rule per keyframe", COLUMNS[1][:3]),
             ("animated-kmeans single, lambda 3", COLUMNS[4][:3], "animated-kmeans single", single),
             ("animated-kmeans joint", COLUMNS[5][:3], "animated-kmeans single", single),
             ("occlusion-order, k = 5", five, "animated-kmeans single", single),
             ("occlusion-order, k = 1", one, "animated-kmeans single", single)]
    lines = []
    for name, way, of_name, of in asked:
        line = [name, of_name]
        for above_least in (False, True):
            found = figures.part(way, of, above_least)
            line.append(f"{found[0]:.2f} (worst {found[1]:.2f}, {found[2]} motions)" if found else "")
        lines.append(line)
    return table(["excess of", "as a part of that of", "OVR - 1", "OVR - least"], lines, 2)


def plot(figures, name, label, chosen, x_of):
    import matplotlib
    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "foredraw"  # the same bytes again
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(7, 4.2))
    for method, mark in (("animated-kmeans", "o"), ("occlusion-order", "s")):
        points = sorted((x_of(row), float(row["ratio"])) for row in figures.sweeps
                        if row["method"] == f"sweep {method}" and chosen(row))
        axes.plot(*zip(*points), marker=mark, label=method)
    axes.set_xlabel(label)
    axes.set_ylabel("overdraw")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(str(PLOT).format(name), metadata={"Date": None})


def tables(figures):
    text = ["## All results", overall(figures), "## Parts", parts(figures), "## By motion", by_motion(figures),
            "## Times", times(figures)]
    if figures.sweeps:
        text += ["## Sizes of patches and numbers of orders",
                 f"Of {figures.sweeps[0]['model']}, {figures.sweeps[0]['motion']}.\n",
                 "![overdraw against ACMR](han-sander-2016-acmr.svg)\n",
                 "![overdraw against orders](han-sander-2016-k.svg)\n"]
    return "\n".join(text)


def plots(figures):
    own = next(row["cut"] for row in figures.sweeps if row["k"] == "1")
    plot(figures, "acmr", "ACMR", lambda row: row["cut"] != own, lambda row: float(row["acmr"]))
    plot(figures, "k", "orders", lambda row: row["cut"] == own, lambda row: int(row["k"]))


def main():
    figures = Figures(sys.argv[1])
    if figures.sweeps:
        plots(figures)
    PAGE.write_text(replaced(PAGE, tables(figures)), encoding="utf-8")


if __name__ == "__main__":
    main()
