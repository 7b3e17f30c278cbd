"""A folder in parts with GNU parallel: a part is killed in the midst of its work and run again, and the joined report and
all outputs are those of one process. Arguments: the program, and a folder that is made anew."""

import subprocess
import sys
import unittest

import processes
from folders import FOLDER, PROGRAM, QUICK, ROOT, contents, make_library, report, without_times

PARTS = 5
SCRIPT = ROOT / "hosts/farm/parallel.sh"

# The program, killed in the midst of its work where it works on part 2 for the first time.
KILLED_PROGRAM = f"""#!/bin/sh
case "$*" in *' 2/{PARTS} '*) mkdir killed 2>/dev/null || exec '{PROGRAM}' "$@" ;; *) exec '{PROGRAM}' "$@" ;; esac
'{PROGRAM}' "$@" &
until [ "$(ls built/*/* 2>/dev/null | wc -l)" -gt 0 ]; do sleep 0.05; done
kill -KILL $!
wait $!
"""


class Parallel(unittest.TestCase):
    def setUp(self):
        make_library()
        self.program = FOLDER / "foredraw"
        self.program.write_text(KILLED_PROGRAM)
        self.program.chmod(0o755)

    def run_parts(self, *words, code):
        command = ["env", f"FOREDRAW={self.program}", "JOBS=2", str(SCRIPT), str(PARTS), "report.json", "library", *words]
        ended = subprocess.run(command, cwd=FOLDER, capture_output=True, text=True, timeout=300)
        self.assertEqual(ended.returncode, code, ended.stdout + ended.stderr)
        return ended.stderr

    def test_parts_do_what_one_process_does(self):
        one = subprocess.run([PROGRAM, "optimize", "library", "-o", "one", "--report", "one.json", "--threads", "1", *QUICK], cwd=FOLDER,
                             capture_output=True, text=True)
        self.assertEqual(one.returncode, 2, one.stderr)  # for bad.glb
        self.run_parts("-o", "built", *QUICK, code=2)
        self.assertTrue((FOLDER / "killed").exists())
        self.assertTrue(contents("built") == contents("one"))
        self.assertTrue(without_times(report("report.json", "built")) == without_times(report("one.json", "one")))

    def test_a_mistake_is_told_and_ends_it(self):
        (FOLDER / "killed").mkdir()
        told = self.run_parts("-o", "built", "-p", "tipsfy", code=1)
        self.assertIn("did you mean 'tipsify'?", told)
        self.assertFalse((FOLDER / "report.json").exists())


if __name__ == "__main__":
    processes.run_tests(unittest)
