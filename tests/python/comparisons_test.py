"""Comparisons have the figures that the program's have."""

import csv
import io
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import foredraw as fd
from meshes import PROGRAM, SPOT, sheet

BOTH = ["tipsify, vertex-fetch", "@cache-only"]


def rows_without_times(rows):
    return [tuple(row.values()) for row in rows if row["evaluator"] != "time"]


class Comparisons(unittest.TestCase):
    def test_have_the_rows_of_the_programs(self):
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "rows.csv"
            options = [part for pipeline in BOTH for part in ["-p", pipeline]]
            subprocess.run([PROGRAM, "compare", SPOT, *options, "--csv", table], check=True, capture_output=True)
            theirs = [row for row in csv.DictReader(io.StringIO(table.read_text(), newline="")) if not row["draw"]]
        ours = fd.compare(SPOT, BOTH)
        self.assertEqual(list(ours[0]), ["file", "branch", "pipeline", "evaluator", "metric", "value", "unit", "error"])

        def number(text):
            return float(text) if text else None

        expected = {
            (row["file"], row["pipeline"] or "input", row["evaluator"], row["metric"], number(row["value"]),
             row["unit"], number(row["error"]))
            for row in theirs if row["evaluator"] not in ("time", "memory")
        }
        mine = {row[:1] + row[2:] for row in rows_without_times(ours)}
        self.assertEqual(mine, expected)
        self.assertEqual({row["branch"]: row["pipeline"] for row in ours}, {0: "input", 1: BOTH[0], 2: BOTH[1]})
        times = [row for row in ours if row["evaluator"] == "time"]
        self.assertEqual([(row["branch"], row["metric"], row["unit"]) for row in times],
                         [(1, "all stages", "s"), (2, "all stages", "s")])
        self.assertTrue(all(row["value"] > 0 for row in times))

    def test_take_scenes_and_paths_one_or_several(self):
        positions, indices = sheet(50)
        made = fd.make([fd.Draw(indices, positions)])
        several = fd.compare([SPOT, str(SPOT), made], "@cache-only", rounds=3)
        self.assertEqual(len(several.report["files"]), 3)
        self.assertEqual(several.report["all"]["input"]["path"], "all 3 files")
        one = fd.compare(made, ["@cache-only"])
        self.assertEqual(len(one.report["files"]), 1)
        last = several.report["files"][2]["metrics"]
        self.assertEqual(last, one.report["files"][0]["metrics"])
        rounds = several.report["files"][0]["branches"][0]["report"]["stages"][0]["rounds"]
        self.assertEqual(len(rounds), 3)
        self.assertEqual(len(fd.compare([], "tipsify")), 0)

    def test_show_a_table_in_notebooks(self):
        for scenes in [SPOT, [SPOT, SPOT]]:
            comparison = fd.compare(scenes, ["weld, tipsify, vertex-fetch", "@cache-only"])
            page = xml.fromstring(f"<div>{comparison._repr_html_()}</div>")
            self.assertEqual([item.text for item in page.iter("li")], ["weld, tipsify, vertex-fetch", "@cache-only"])
            table = [[cell for cell in row] for row in page.iter("tr")]
            self.assertEqual({len(row) for row in table}, {5})
            acmr = next(row for row in table if row[1].text == "acmr")
            whole = comparison.report.get("all") or comparison.report["files"][0]
            figures = next(row for row in whole["metrics"] if row["metric"] == "acmr")
            self.assertEqual(acmr[2].text, f"{figures['input']:.4f}")
            shown = ["".join(cell.itertext()) for cell in acmr[3:]]
            self.assertEqual(shown, [f"{value:.4f}" for value in figures["values"]])
            best = [cell.find("b") is not None for cell in acmr[3:]]
            self.assertEqual(best, [value == min(figures["values"]) for value in figures["values"]])
        xml.fromstring(f"<div>{fd.compare([], 'tipsify')._repr_html_()}</div>")

    def test_say_what_is_wrong(self):
        with self.assertRaisesRegex(fd.Error, r"1:9: error: ") as caught:
            fd.compare(SPOT, ["tipsify", "tipsify("])
        self.assertIsNone(caught.exception.result)
        with self.assertRaisesRegex(fd.Error, "did you mean 'tipsify'"):
            fd.compare(SPOT, ["tipsify", "tipsfy"])
        with self.assertRaisesRegex(fd.Error, "particle-trim") as caught:
            fd.compare(SPOT, ["tipsify", "particle-trim(required=true)"])
        rest = caught.exception.result
        self.assertEqual({row["branch"] for row in rest}, {0, 1})
        xml.fromstring(f"<div>{rest._repr_html_()}</div>")
        with self.assertRaisesRegex(fd.Error, "none.glb"):
            fd.compare([SPOT, "none.glb"], "tipsify")
        with self.assertRaises(ValueError):
            fd.compare(SPOT, "tipsify", rounds=-1)

    def test_tell_how_far_they_are_and_end(self):
        heard = []

        def stops(what, part):
            heard.append(what)
            if len(heard) == 3:
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            fd.compare([SPOT, SPOT], BOTH, progress=stops)
        self.assertEqual(len(heard), 3)
