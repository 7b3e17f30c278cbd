"""One mutant: applied, built, tested until a test fails."""

import os
import re
import resource
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from mutant import apply, place

KILLED, SURVIVED, NOT_COMPILED, TIMEOUT, GONE = "killed", "survived", "not compiled", "timeout", "gone"
MEMORY = 8 << 30  # bytes of addresses for a test: a change may ask for more and more
SEED = "seed=49"  # of properties that are checked with random values


def properties(test):
    return {p["name"]: p["value"] for p in test.get("properties", [])}


def limited(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Run:
    """A run of a test program: `passed`, `timed_out`, `cases` that began, `failed` ones."""

    def __init__(self, program, cases):
        settings = properties(cases[0].test)
        environment = dict(os.environ, RC_PARAMS=SEED)
        environment.update(entry.split("=", 1) for entry in settings.get("ENVIRONMENT", []))
        usual = sum(case.usual for case in cases)
        with tempfile.TemporaryDirectory() as folder:
            flags, output = Path(folder) / "flags", Path(folder) / "output"
            flags.write_text("--gtest_filter=" + ":".join(case.filter for case in cases) + "\n")
            with output.open("wb") as to:
                process = subprocess.Popen(
                    [program, f"--gtest_flagfile={flags}", "--gtest_fail_fast"], stdout=to, stderr=subprocess.STDOUT,
                    cwd=settings.get("WORKING_DIRECTORY"), env=environment, start_new_session=True,
                    preexec_fn=lambda: limited(int(max(30, 10 * usual))))
                try:
                    status = process.wait(max(600, 50 * usual))  # for what waits; what computes has processor time
                except subprocess.TimeoutExpired:
                    status = -signal.SIGXCPU
                finally:
                    try:
                        os.killpg(process.pid, signal.SIGKILL)  # and what it began
                    except ProcessLookupError:
                        pass
                    process.wait()
            text = output.read_text(errors="replace")
        self.cases = re.findall(r"^\[ RUN      \] (\S+)", text, re.MULTILINE)
        self.failed = re.findall(r"^\[  FAILED  \] ([^\s,]+)", text, re.MULTILINE)
        self.timed_out = status in (-signal.SIGXCPU, -signal.SIGKILL)
        self.passed = status == 0


class Trial:
    def __init__(self, build, units, plan, report):
        self.build, self.units, self.plan, self.report = build, units, plan, report

    def google_tests(self, step):
        """(outcome, test) of the first case that fails among others and alone, or None."""
        cases = step.cases
        while cases:
            run = Run(step.program, cases)
            if run.passed:
                return None
            name = (run.failed or run.cases or [cases[0].filter])[0 if run.failed else -1]
            index = next((i for i, case in enumerate(cases) if case.filter == name), 0)
            if run.timed_out:
                return TIMEOUT, cases[index].name
            if not Run(step.program, [cases[index]]).passed:
                return KILLED, cases[index].name
            begun = set(run.cases)
            cases = [case for case in cases if case.filter not in begun and case is not cases[index]]
        return None

    def commands(self, step):
        chosen = "^(" + "|".join(re.escape(case.name) for case in step.cases) + ")$"
        done = subprocess.run(["ctest", "--stop-on-failure", "--repeat", "until-pass:2", "-R", chosen], cwd=self.build.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        if done.returncode == 0:
            return None
        failed = re.search(r"^\s*\d+ - (\S+) \((\w+)", done.stdout, re.MULTILINE)
        name = failed.group(1) if failed else "ctest"
        return (TIMEOUT if failed and failed.group(2) == "Timeout" else KILLED), name

    def tested(self, steps):
        for step in steps:
            self.report(f"  {Path(step.program).name or 'commands'}: {len(step.cases)} cases, usually {step.usual():.0f} s")
            if not self.build.make(step.program or "all"):
                return NOT_COMPILED, ""
            found = self.google_tests(step) if step.program else self.commands(step)
            if found:
                return found
        return SURVIVED, ""

    def __call__(self, mutant):
        """(outcome, test, file, number of the line, processor seconds)"""
        at = place(mutant, self.build.tree)
        if not at:
            return GONE, "", mutant.file, 0, 0
        file, number = at
        units = self.units.get(file, set())
        if not units:
            return GONE, "", file, number + 1, 0
        path = self.build.tree / file
        before = os.times()
        text = apply(mutant, self.build.tree, file, number)
        try:
            outcome, test = self.tested(self.plan.steps(file, units))
        finally:
            path.write_text(text, encoding="utf-8")
            time.sleep(0.01)
            os.utime(path)  # newer than what was made of the change
        after = os.times()
        seconds = after.children_user + after.children_system - before.children_user - before.children_system
        return outcome, test, file, number + 1, seconds
