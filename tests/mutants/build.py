"""The build folder of a tree: which objects a file is compiled into, which programs these are linked into."""

import json
import os
import re
import shlex
import subprocess
import tempfile
from pathlib import Path

PRESET = "release-tests"


class Build:
    def __init__(self, tree):
        self.tree = Path(tree).resolve()
        self.folder = self.tree / "build/release"

    def make(self, *targets):
        """True if the targets were built: names of ninja, or paths of programs in the folder of the build."""
        targets = [os.path.relpath(target, self.folder) if os.path.isabs(target) else target for target in targets]
        return subprocess.run(["ninja", "-C", self.folder, *targets], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode == 0

    def output(self, *command):
        return subprocess.run(command, cwd=self.folder, stdout=subprocess.PIPE, check=True, text=True).stdout

    def units(self):
        """For each file of the tree: the objects that include it."""
        units = {}
        root = str(self.tree) + "/"
        for line in self.output("ninja", "-t", "deps").splitlines():
            if not line.startswith(" "):
                target = line.split(": #deps")[0]
                continue
            file = os.path.normpath(self.folder / line.strip())
            if file.startswith(root) and target.endswith(".o"):
                units.setdefault(file[len(root):], set()).add(target)
        return units

    def inputs(self, program):
        """All that a program is linked from or started with, directly or not."""
        name = os.path.relpath(program, self.folder)
        return {line for line in self.output("ninja", "-t", "inputs", name).splitlines() if line.endswith((".o", ".cpp"))}

    def prepare(self):
        """Builds the tree as it is, once for each commit, and answers with the tests of ctest and the objects of each
        test program."""
        commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=self.tree, stdout=subprocess.PIPE, check=True,
                                text=True).stdout.strip()
        kept = self.folder / "mutants.json"
        if kept.exists():
            known = json.loads(kept.read_text())
            if known["commit"] == commit:
                return known["tests"], known["objects"]
        if not (self.folder / "build.ninja").exists():
            subprocess.run(["cmake", "--preset", PRESET], cwd=self.tree, check=True)
        if not self.make("all"):
            raise SystemExit(f"mutants: the tree does not build: ninja -C {self.folder}")
        tests = json.loads(self.output("ctest", "--show-only=json-v1"))["tests"]
        tests = [one for test in tests for one in self.cases_of(test)]
        programs = {test["command"][0] for test in tests if is_google_test(test)}
        objects = {program: sorted(self.inputs(program)) for program in sorted(programs)}
        kept.write_text(json.dumps({"commit": commit, "tests": tests, "objects": objects}))
        return tests, objects

    def cases_of(self, test):
        """The cases of the first shard of a program, which are those of all its shards, as tests; another test as it is."""
        shard = re.fullmatch(r"(\w+)\.[a-z]+_(\d)", test["name"])
        if not shard:
            return [test]
        program, number = shard.groups()
        if number != "0":
            return []
        listed = self.output(test["command"][0], "--gtest_list_tests", *test["command"][1:2])
        suite, cases = "", []
        for line in listed.splitlines():
            if line.startswith("  "):
                cases.append(suite + line.split("#")[0].strip())
            else:
                suite = line.split("#")[0].strip()
        properties = [one for one in test.get("properties", []) if one["name"] != "ENVIRONMENT"]
        return [dict(test, name=f"{program}.{case}", properties=properties,
                     command=[test["command"][0], f"--gtest_filter={case}"]) for case in cases]

    def commands(self):
        """The compiler's command of each object, as a list."""
        entries = json.loads((self.folder / "compile_commands.json").read_text())
        commands = (shlex.split(entry["command"]) for entry in entries)
        return {command[command.index("-o") + 1]: command for command in commands}

    def compiled(self, command, source, seconds=300):
        """The object that a command makes of another source, or None. It is in a folder of its own for that time."""
        with tempfile.TemporaryDirectory() as folder:
            to = str(Path(folder) / "unit.o")
            command = list(command)
            command[command.index("-o") + 1] = to
            command[command.index("-c") + 1] = str(source)
            try:
                done = subprocess.run(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                      timeout=seconds)
            except subprocess.TimeoutExpired:
                return None
            return Path(to).read_bytes() if done.returncode == 0 else None


def is_google_test(test):
    return any(argument.startswith("--gtest_filter=") for argument in test.get("command", []))
