"""The page of overdraw's errors says what the figures say."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/overdraw_error"))
sys.dont_write_bytecode = True
import overdraw_error_page as page

HEADS = ["model", "evaluator", "sampling", "views", "size", "seeds", "milliseconds", "error", "claimed", "within"]
LINES = [
    ["one", "truth", "", "9", "9", "2", "", "0.000001", "", "1.25"],
    ["two", "truth", "", "9", "9", "2", "", "0.0001", "", "1.5"],
    ["one", "raster", "", "12", "64", "5", "2", "0.001", "0.002", ""],
    ["two", "raster", "", "12", "64", "5", "8", "0.004", "0.002", ""],
    ["one", "raster", "error = 0.01", "", "", "13", "1", "0.001", "0.002", "13"],
    ["two", "raster", "error = 0.01", "", "", "13", "1", "0.00001", "0.002", "12"],
]


def figures_of(lines):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "figures.tsv"
        path.write_text("\n".join("\t".join(row) for row in [HEADS, *lines]) + "\n", encoding="utf-8")
        return page.Figures(path)


class Tables(unittest.TestCase):
    def test_means_are_geometric(self):
        self.assertIn("| 12 | 2.0e-03, 4 ms |", page.grid(figures_of(LINES), "raster", ""))

    def test_no_error_is_below_what_the_truth_is_known_to(self):
        self.assertIn("| 3.2e-04 |", page.wanted(figures_of(LINES)))  # of 0.001 and 0.0001

    def test_trials_are_summed(self):
        self.assertIn("| error = 0.01 | 25 of 26 |", page.wanted(figures_of(LINES)))

    def test_missing_models_are_told(self):
        with self.assertRaisesRegex(SystemExit, "lacks models"):
            figures_of(LINES[:-1])

    def test_the_page_is_what_the_figures_in_the_tree_give(self):
        figures = page.Figures(ROOT / "benchmarks/overdraw_error/figures.tsv")
        self.assertEqual(page.PAGE.read_text(encoding="utf-8"), page.replaced(page.PAGE, page.tables(figures)))


if __name__ == "__main__":
    unittest.main()
