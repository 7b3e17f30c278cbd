"""The page of the vertex-cache contest says what the figures say, and the same figures give the same picture."""

import importlib.util
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "benchmarks/vertex_order"), str(ROOT / "benchmarks/plots")]
sys.dont_write_bytecode = True
import vertex_orders_page as page

HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None
HEADS = ["order", "setting", "size", "meshes", "arrangement", "triangles", "repetitions", page.TIME,
         *("ACMR " + cache for cache in page.CACHES), "ATVR", "OVR"]


def line(order, setting, size, meshes, time, acmr, ovr):
    return [order, setting, size, meshes, "own", "1000", "7" if time else "", time] + [acmr] * len(page.CACHES) + ["1.2", ovr]


def figures_of(lines):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "figures.tsv"
        path.write_text("\n".join("\t".join(row) for row in [HEADS, *lines]) + "\n", encoding="utf-8")
        return page.Figures(path)


LINES = [
    line("as it comes", "", "below 10k", "small", "", "2", "1.5"),
    line("fast", "", "below 10k", "small", "10", "0.8", "1.1"),
    line(*page.PEER, "below 10k", "small", "20", "0.7", "1.2"),
    line("as it comes", "", "above 800k", "large", "", "3", ""),
    line("fast", "", "above 800k", "large", "40", "0.6", ""),
    line(*page.PEER, "above 800k", "large", "20", "0.7", ""),
    line("fast", "", "grid", "grid 2x2", "10", "0.9", "1"),
    line(*page.PEER, "grid", "grid 2x2", "20", "0.75", "1"),
    line("strips", "plain", "grid", "grid 2x2", "", "0.55", "1"),
]
FAST = ("fast", "")


def row_of(table, first):
    return next([cell.strip() for cell in row.split("|")[1:-1]] for row in table.splitlines() if row.startswith(first))


class Tables(unittest.TestCase):
    def test_means_are_geometric_of_times_and_arithmetic_of_the_rest_without_grids(self):
        row = row_of(page.means(figures_of(LINES)), "| `fast`")
        self.assertEqual(row[2:6], ["20.0", "1.00", "1.0000", "0.7000"])
        self.assertEqual(row[-1], "1.1000")  # of the set that was drawn

    def test_sizes_stand_apart(self):
        self.assertEqual(row_of(page.size_classes(figures_of(LINES)), "| `fast`")[2:], ["0.50, 1.1429", "2.00, 0.8571"])

    def test_what_was_not_timed_has_no_time(self):
        self.assertEqual(row_of(page.means(figures_of(LINES)), "| as it comes")[2:5], ["", "", "3.5714"])

    def test_strips_stand_beside_the_orders_of_grids(self):
        grids = page.grids(figures_of(LINES + [line("as it comes", "", "grid", "grid 2x2", "", "1", "1")]))
        self.assertEqual(row_of(grids, "| `strips`")[1:], ["plain", "0.5500"])

    def test_rows_are_as_long_as_their_heads(self):
        figures = figures_of(LINES)
        for table in (page.means(figures), page.size_classes(figures), page.grids(figures)):
            self.assertEqual(len({row.count("|") for row in table.splitlines()}), 1, table)

    def test_the_page_says_of_how_many_repetitions_the_times_are(self):
        self.assertIn("Times are medians of 7,", page.tables(figures_of(LINES + [LINES[0][:2] + ["grid", "grid 2x2"] + LINES[0][4:]])))

    def test_missing_figures_are_named(self):
        with self.assertRaisesRegex(SystemExit, "fast has no figures on large, own"):
            page.means(figures_of([row for row in LINES if row[0] != "fast" or row[3] != "large"]))

    def test_the_page_is_what_the_figures_in_the_tree_give(self):
        text = page.PAGE.read_text(encoding="utf-8")
        figures = page.Figures(ROOT / "benchmarks/vertex_order/figures.tsv")
        self.assertEqual(text, page.replaced(page.PAGE, page.tables(figures)))


class Labels(unittest.TestCase):
    def test_stand_beside_their_points_and_cover_nothing_where_there_is_room(self):
        from label_places import label_places, overlap

        points = [(50, 50), (54, 50), (54, 53), (98, 50), (50, 100)]
        area, taken, size = (0, 0, 100, 100), (60, 40, 90, 45), (20, 7)
        places = label_places(points, [size] * len(points), area, [taken])
        boxes = [(x, y, x + size[0], y + size[1]) for x, y in places]
        things = [taken] + boxes + [(x - 3, y - 3, x + 3, y + 3) for x, y in points]
        for i, box in enumerate(boxes):
            self.assertAlmostEqual(overlap(box, area), size[0] * size[1], msg=f"label {i} leaves the area")
            self.assertEqual(sum(overlap(box, thing) for thing in things), overlap(box, box), f"label {i} covers something")
            self.assertLess(abs(places[i][0] - points[i][0]) + abs(places[i][1] - points[i][1]), 60)

    def test_stand_to_the_right_of_points_that_are_alone(self):
        from label_places import label_places

        self.assertEqual(label_places([(10, 10)], [(20, 6)], (0, 0, 100, 100)), [(15, 7)])


@unittest.skipUnless(HAS_MATPLOTLIB, "Matplotlib is not installed")
class Plot(unittest.TestCase):
    def test_the_front_holds_what_nothing_beats(self):
        from quality_against_time import Point, pareto_front

        fast, good, beaten, equal = Point("a", "", 1, 9), Point("b", "", 5, 2), Point("c", "", 6, 2), Point("d", "", 5, 2)
        self.assertEqual(pareto_front([good, beaten, equal, fast]), [fast, good])

    def test_the_same_figures_give_the_same_picture_with_text_as_text_in_the_page_s_colour(self):
        from quality_against_time import Panel, Point, write_svg

        panels = [Panel("title of a panel", [Point("fast", "16", 10, 0.8), Point("good", "", 40, 0.6)], [("limit", 0.5)])]
        with tempfile.TemporaryDirectory() as folder:
            pictures = []
            for name in ("one.svg", "two.svg"):
                write_svg(Path(folder) / name, panels, "time", "quality", worst=0.7)
                pictures.append((Path(folder) / name).read_text(encoding="utf-8"))
        self.assertEqual(*pictures)
        self.assertIn("title of a panel</text>", pictures[0])
        self.assertIn("16 at 0.80</text>", pictures[0])
        self.assertIn("fill: currentColor", pictures[0])
        self.assertNotIn("#010203", pictures[0])
        self.assertNotIn("dc:date", pictures[0])


if __name__ == "__main__":
    unittest.main()
