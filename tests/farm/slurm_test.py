"""A folder as a Slurm array: a task is requeued while it works, one is cancelled and run again, and the joined report and
all outputs are those of one process. Arguments: the program, and a folder that is made anew."""

import subprocess
import unittest

import processes
import slurm
from folders import FOLDER, PROGRAM, QUICK, ROOT, contents, make_library, report, without_times

SCRIPT = ROOT / "hosts/farm/foredraw.sbatch"
PARTS, REQUEUED, CANCELLED = 8, 2, 5

# The program, stopped in the midst of its work where a part is held. The first try of a part is held, and no other.
HELD_PROGRAM = f"""#!/bin/sh
for word; do
  [ "$last" = --shard ] && shard=$word
  last=$word
done
number=${{shard%/*}}
case " {REQUEUED} {CANCELLED} " in *" $number "*) mkdir "held/$number" 2>/dev/null || exec '{PROGRAM}' "$@" ;;
  *) exec '{PROGRAM}' "$@" ;;
esac
'{PROGRAM}' "$@" &
until [ "$(ls built/*/* 2>/dev/null | wc -l)" -gt 0 ]; do sleep 0.05; done
kill -STOP $!
echo $! > "held/$number/process"
wait $!
"""


class Array(unittest.TestCase):
    def setUp(self):
        make_library()
        (FOLDER / "held").mkdir()
        self.program = FOLDER / "foredraw"
        self.program.write_text(HELD_PROGRAM)
        self.program.chmod(0o755)

    def submitted(self, cluster, *words):
        return cluster.run("sbatch", "--parsable", *words, cwd=FOLDER, environment={"FOREDRAW": str(self.program)}).strip()

    def array(self, cluster, tasks):
        return self.submitted(cluster, f"--array={tasks}", str(SCRIPT), str(PARTS), "parts", "library", "-o", "built",
                              "--cache", "cache", *QUICK)

    def join_after(self, cluster, dependency):
        return self.submitted(cluster, f"--dependency={dependency}", "--kill-on-invalid-dep=yes",
                              "--wrap", f"'{PROGRAM}' join-reports parts/*-of-{PARTS}.json -o report.json")

    def wait_for(self, cluster, job, state):
        found = {}

        def has_ended():
            found.update(cluster.job(job))
            return found.get("JobState") in ("COMPLETED", "FAILED", "CANCELLED", "NODE_FAIL", "TIMEOUT")

        cluster.wait_until(f"{job} is {state}", has_ended, 120)
        self.assertEqual(found["JobState"], state, f"{job}, told: {self.told()}")

    def told(self):
        return "".join(path.read_text(errors="replace") for path in FOLDER.glob("slurm-*.out"))[-3000:]

    def test_an_array_does_what_one_process_does(self):
        one = subprocess.run([PROGRAM, "optimize", "library", "-o", "one", "--report", "one.json", "--threads", "1", *QUICK], cwd=FOLDER,
                             capture_output=True, text=True)
        self.assertEqual(one.returncode, 2, one.stderr)  # for bad.glb
        with slurm.Slurm(FOLDER / "cluster") as cluster:
            self.run_array(cluster)
        self.assertFalse(processes.descendants(), "daemons and tasks have ended")
        self.assertTrue(contents("built") == contents("one"))
        joined = report("report.json", "built")
        self.assertTrue(without_times(joined) == without_times(report("one.json", "one")))
        self.assertEqual([file["outcome"] for file in joined["files"]].count("lost"), 1)

    def run_array(self, cluster):
        array = self.array(cluster, f"1-{PARTS}%2")
        join = self.join_after(cluster, f"afterok:{array}")

        held = FOLDER / "held"
        cluster.wait_until("a part is held", (held / f"{REQUEUED}/process").exists)
        self.assertEqual(cluster.job(f"{array}_{REQUEUED}")["JobState"], "RUNNING")
        self.assertFalse((FOLDER / f"parts/{REQUEUED}-of-{PARTS}.json").exists(), "it is at work")
        cluster.run("scontrol", "requeue", f"{array}_{REQUEUED}")

        cluster.wait_until("the other part is held", (held / f"{CANCELLED}/process").exists)
        self.assertEqual(cluster.job(join)["JobState"], "PENDING")
        cluster.run("scancel", f"{array}_{CANCELLED}")

        for task in range(1, PARTS + 1):
            self.wait_for(cluster, f"{array}_{task}", "CANCELLED" if task == CANCELLED else "COMPLETED")
        self.assertEqual(cluster.job(f"{array}_{REQUEUED}")["Restarts"], "1")
        self.wait_for(cluster, join, "CANCELLED")  # for a part is missing
        self.assertFalse((FOLDER / "report.json").exists())
        self.assertEqual(len(list((FOLDER / "parts").iterdir())), PARTS - 1)

        again = self.array(cluster, CANCELLED)
        join = self.join_after(cluster, f"afterok:{again},afterany:{array}")
        self.wait_for(cluster, join, "FAILED")  # as one process ends where a file failed
        self.assertEqual(cluster.job(join)["ExitCode"], "2:0")
        self.assertEqual(cluster.job(f"{again}_{CANCELLED}")["ExitCode"], "0:0")


if __name__ == "__main__":
    processes.run_tests(unittest)
