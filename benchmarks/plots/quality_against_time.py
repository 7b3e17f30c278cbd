"""Quality against run time, or another cost, as an SVG picture: each panel shows what contestants reach in which time,
with the Pareto front and what is known to be the limit.

Legible on light and on dark pages: the page's own background shows through, text and axes take the page's colour, and
colours of points stand out on both. Text stays text. The same figures give the same file.
"""

from dataclasses import dataclass, field

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter

from label_places import label_places

# Stands for the page's own colour, which the library has no word for; replaced when the file is written.
PAGE = "#010203"
PAGE_STYLE = "<style>svg{color:#24292f}@media(prefers-color-scheme:dark){svg{color:#d0d7de}}</style>"
COLOURS = ["#d9822b", "#2f81f7", "#2ea043", "#a371f7", "#e5534b", "#1b9e9e", "#c6469b", "#8d8d3a"]
MARKERS = "os^Dv<>p"
LABEL_FONT, LIMIT_FONT = 6.5, 7


@dataclass
class Point:
    family: str  # what the legend names
    label: str  # what stands beside the point
    time: float
    quality: float


@dataclass
class Panel:
    title: str
    points: list[Point]
    limits: list[tuple[str, float]] = field(default_factory=list)  # name, quality
    axis: str = ""  # what the panel's own times are; else the picture's
    ticks: list[float] = field(default_factory=list)  # where they are written, evenly; else by factors
    worst: float = 0  # instead of the picture's; 0: that


def pareto_front(points):
    """Those that none is both at least as fast and at least as good as, and better in one; from fast to slow."""
    front = []
    for point in sorted(points, key=lambda p: (p.time, p.quality, p.family, p.label)):
        if not front or point.quality < front[-1].quality:
            front.append(point)
    return front


def families_of(panels):
    return list(dict.fromkeys(point.family for panel in panels for point in panel.points))


def draw_panel(axes, panel, style, worst, is_log):
    front = pareto_front(panel.points)
    axes.plot([p.time for p in front], [p.quality for p in front], color=PAGE, alpha=0.35, linewidth=5,
              solid_capstyle="round", solid_joinstyle="round", zorder=1)
    for name, quality in panel.limits:
        axes.axhline(quality, color=PAGE, linewidth=0.8, linestyle=(0, (4, 3)), zorder=0)
        axes.annotate(name, (1, quality), xycoords=("axes fraction", "data"), xytext=(-3, 2), ha="right",
                      textcoords="offset points", fontsize=LIMIT_FONT)
    for point in panel.points:
        colour, marker = style[point.family]
        axes.plot(point.time, min(point.quality, worst), marker, color=colour, markersize=5, zorder=3, clip_on=False)
    best = min([p.quality for p in panel.points] + [quality for _, quality in panel.limits])
    if is_log:
        axes.set_yscale("log")
    axes.set_ylim(best / 1.3 if is_log else best - 0.05 * (worst - best), worst)
    axes.set_xscale("linear" if panel.ticks else "log")
    axes.margins(x=0.08)
    times = [point.time for point in panel.points]
    subs = (1, 2, 5) if max(times) < 1000 * min(times) else (1,)  # what is written side by side
    axes.xaxis.set_major_locator(FixedLocator(panel.ticks) if panel.ticks else LogLocator(subs=subs))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda time, _: f"{time:g}"))
    axes.set_xlabel(panel.axis)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_title(panel.title, fontsize=9)
    axes.grid(color=PAGE, alpha=0.12, linewidth=0.6)


def size_of(text, font):
    """In points, about: nothing is known of the font that the reader's machine will take."""
    return 0.53 * font * len(text), font


def label_points(axes, panel, style, worst):
    """When nothing else moves any more."""
    to_points = 72 / axes.figure.dpi
    right, top = axes.transAxes.transform((1, 1)) * to_points
    left, bottom = axes.transAxes.transform((0, 0)) * to_points
    points = sorted(panel.points, key=lambda p: (p.quality, p.time, p.family, p.label))
    labels = [p.label if p.quality <= worst else f"{p.label} at {p.quality:.2f}".strip() for p in points]
    anchors = [axes.transData.transform((p.time, min(p.quality, worst))) * to_points for p in points]
    taken = []
    for name, quality in panel.limits:
        width, height = size_of(name, LIMIT_FONT)
        line = axes.transData.transform((1, quality))[1] * to_points
        taken.append((right - 3 - width, line, right, line + 2 + height))
    sizes = [size_of(label, LABEL_FONT) for label in labels]
    places = label_places(anchors, sizes, (left, bottom, right, top), taken)
    for point, label, anchor, place in zip(points, labels, anchors, places):
        axes.annotate(label, (point.time, min(point.quality, worst)), xytext=place - anchor, va="bottom",
                      textcoords="offset points", fontsize=LABEL_FONT, color=style[point.family][0], zorder=4)


def write_svg(path, panels, time_axis, quality_axis, worst, columns=2, size=(4.9, 3.6), is_log=False):
    """Draws the panels in rows of so many columns, each of that size in inches. All points of a family look alike in all
    panels; those worse than `worst` stand at the upper edge, with their figure. `is_log`: quality grows by factors."""
    plt.rcParams.update({
        "svg.fonttype": "none", "svg.hashsalt": "foredraw", "font.family": "sans-serif", "font.size": 8,
        "text.color": PAGE, "axes.labelcolor": PAGE, "axes.edgecolor": PAGE, "xtick.color": PAGE, "ytick.color": PAGE,
        "legend.frameon": False,
    })
    rows = -(-len(panels) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(size[0] * columns, size[1] * rows + 0.5), squeeze=False)
    style = {family: (COLOURS[i % len(COLOURS)], MARKERS[i % len(MARKERS)])
             for i, family in enumerate(families_of(panels))}
    for axes, panel in zip(grid.flat, panels):
        draw_panel(axes, panel, style, panel.worst or worst, is_log)
    for axes in grid.flat[len(panels):]:
        axes.set_visible(False)
    figure.supxlabel(time_axis, fontsize=9)
    figure.supylabel(quality_axis, fontsize=9)
    shown = [plt.Line2D([], [], color=c, marker=m, linestyle="", markersize=5, label=f) for f, (c, m) in style.items()]
    shown.append(plt.Line2D([], [], color=PAGE, alpha=0.35, linewidth=5, label="Pareto front"))
    figure.legend(handles=shown, loc="upper center", ncol=4, fontsize=8)
    figure.tight_layout(rect=(0.01, 0, 1, 1 - 0.5 / (size[1] * rows + 0.5)))
    for axes, panel in zip(grid.flat, panels):
        label_points(axes, panel, style, panel.worst or worst)
    figure.savefig(path, transparent=True, metadata={"Date": None, "Creator": None})
    plt.close(figure)

    with open(path, encoding="utf-8") as file:
        svg = file.read()
    svg = svg.replace(PAGE, "currentColor").replace("<defs>", PAGE_STYLE + "\n <defs>", 1)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(line.rstrip() for line in svg.splitlines()) + "\n")
