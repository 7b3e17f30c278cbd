"""The page of trimmed particles says what the figures say."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/particle_trim"))
sys.dont_write_bytecode = True
import particle_trim_page as page

HEADS = ["texture", "threshold", "mip levels", "method", "hull edges", "vertices", "threads", "sprites", "area", "least area",
         "most area", "milliseconds", "worked"]


def lines_of(texture, areas):
    lines = []
    for threshold in page.THRESHOLDS:
        for mips in "02":
            def line(method, edges, n, scale, time):
                scaled = [scale * area for area in areas]
                three = [sum(scaled) / len(areas), min(scaled), max(scaled)] if scale else ["", "", ""]
                lines.append([texture, threshold, mips, method, edges, n, "1", str(len(areas)), *map(str, three), "100", time])

            line("alpha", "", "", 0, "1")
            line("hull", "", "14 to 20", 0.75, "2")
            for n in "48":
                line("optimal", "", n, 1, "3")
                line("persson", "24", n, 1.25, "9")
    return lines


LINES = lines_of("one", [0.4]) + lines_of("two", [0.2, 0.6])


def figures_of(lines):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "figures.tsv"
        path.write_text("\n".join("\t".join(row) for row in [HEADS, *lines]) + "\n", encoding="utf-8")
        return page.Figures(path)


class Tables(unittest.TestCase):
    def test_every_sprite_counts_alike(self):
        self.assertIn("| 8 vertices | 40.00 (20.0 to 60.0) | 50.00 (25.0 to 75.0) |", page.by_vertices(figures_of(LINES)))

    def test_times_are_of_the_work_of_all_sprites(self):
        self.assertAlmostEqual(figures_of(LINES).time(("optimal", "", "8", "0")), 2)  # of 3 + 3 for three sprites

    def test_the_ratio_is_of_the_whole(self):
        self.assertIn("| two | 2 | 14 to 20 | 1.00 | 2.00 | 3.00 | 9.00 | 3.00 |", page.times_of_eight(figures_of(LINES), "0"))

    def test_a_reduced_hull_is_held_against_the_smallest(self):
        self.assertIn("| persson, hull-edges = 24 | 50.00 | 25.00 | 6.00 |", page.errors(figures_of(LINES)))

    def test_what_is_beside_stands_there_where_it_was_measured(self):
        self.assertIn("| hull | 30.00 (15.0 to 45.0) |", page.by_vertices(figures_of(LINES)))
        self.assertNotIn("parallelogram", page.by_vertices(figures_of(LINES)))

    def test_missing_textures_are_told(self):
        with self.assertRaisesRegex(SystemExit, "lacks textures"):
            figures_of([line for line in LINES if line[0] != "two" or line[3] != "optimal"])

    def test_the_page_is_what_the_figures_in_the_tree_give(self):
        figures = page.Figures(ROOT / "benchmarks/particle_trim/figures.tsv")
        self.assertEqual(page.PAGE.read_text(encoding="utf-8"), page.replaced(page.PAGE, page.tables(figures)))


if __name__ == "__main__":
    unittest.main()
