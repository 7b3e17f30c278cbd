"""The page of the experiment says what the figures say."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/han_sander_2016"))
sys.dont_write_bytecode = True
import han_sander_2016_page as page

HEADS = ["model", "triangles", "motion", "keyframes", "method", "cut", "k", "acmr", "ratio", "seconds"]


def motion(name, ratios):
    """Ratios of least, original, dot-rule, k-means, occlusion-order with 5 and with 1; lambda 3 as k-means."""
    ways = [("least", "", "0"), ("original", "", "1"), ("dot-rule", "growth = 1.3", "0"),
            ("animated-kmeans", "growth = 1.3", "5"), ("occlusion-order", "", "5"), ("occlusion-order", "", "1"),
            ("dot-rule", "lambda = 3", "0"), ("animated-kmeans", "lambda = 3", "5")]
    ratios = ratios + [ratios[3], ratios[3]]
    return [["one", "12", name, "7", *way, "0.7", str(ratio), "1.5"] for way, ratio in zip(ways, ratios)]


LINES = [*motion("Walk", [1.1, 1.5, 1.4, 1.2, 1.125, 1.15]), *motion("Run", [1, 1.5, 1.8, 1.2, 1.05, 1.8])]


def figures_of(lines):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "figures.tsv"
        path.write_text("\n".join("\t".join(row) for row in [HEADS, *lines]) + "\n", encoding="utf-8")
        return page.Figures(path)


class Tables(unittest.TestCase):
    def test_parts_are_geometric_means_of_excesses(self):
        table = page.parts(figures_of(LINES))
        # Above 1: .2/.4 and .2/.8; above the least: .1/.3 and .2/.8.
        self.assertIn("| animated-kmeans single | dot-rule per keyframe | 0.35 (worst 0.50, 2 motions) "
                      "| 0.29 (worst 0.33, 2 motions) |", table)
        self.assertIn("| occlusion-order, k = 5 | animated-kmeans single | 0.40 (worst 0.63, 2 motions) "
                      "| 0.25 (worst 0.25, 2 motions) |", table)

    def test_small_excesses_are_left_out(self):
        lines = [*LINES, *motion("Idle", [1, 1.02, 1.01, 1.005, 1.004, 1.004])]
        self.assertIn("2 motions", page.parts(figures_of(lines)).split("\n")[5])

    def test_motions_are_averaged(self):
        self.assertIn("| 0.700, 1.6000 |", page.overall(figures_of(LINES)))
        self.assertIn("| one | growth = 1.3 | 12 | 2 | 7/7 |", page.overall(figures_of(LINES)))

    def test_missing_rows_are_told(self):
        with self.assertRaisesRegex(SystemExit, "one Run lacks"):
            figures_of(LINES[:-1])

    def test_the_page_is_what_the_figures_in_the_tree_give(self):
        figures = page.Figures(ROOT / "benchmarks/han_sander_2016/figures.tsv")
        self.assertEqual(page.PAGE.read_text(encoding="utf-8"), page.replaced(page.PAGE, page.tables(figures)))


if __name__ == "__main__":
    unittest.main()
