"""The tests that can see a change of a file, nearest first."""

import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from build import is_google_test

OWN, ROOM, CONFORMANCE, GOLDEN, REST = range(5)
SUITE = re.compile(r"\b(?:TEST|TEST_F|TEST_P|TYPED_TEST|TYPED_TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+)\s*,")
READS_TEXT = "architecture"  # judges how sources are written: it would see every change, and says nothing of tests


@dataclass
class Case:
    name: str      # for ctest
    filter: str    # for its program
    usual: float   # seconds
    test: dict     # what ctest says of it


@dataclass
class Step:
    program: str   # empty: tests of ctest that are commands
    cases: list = field(default_factory=list)

    def usual(self):
        return sum(case.usual for case in self.cases)


def usual_times(files):
    """Seconds of each test in a run of the tree as it is, without those that did not pass: by JUnit files of ctest, and by
    those of GoogleTest, whose names are that of the program and what follows a dot."""
    times = {}
    for file in map(Path, files):
        root = xml.parse(file).getroot()
        for case in root.iter("testcase"):
            is_case = root.tag == "testsuites"
            name = f"{file.name.split('.')[0]}.{case.get('classname')}.{case.get('name')}" if is_case else case.get("name")
            ran = case.get("result", "completed") == "completed" and case.find("skipped") is None
            if case.get("status") == "run" and ran and case.find("failure") is None:
                times[name] = float(case.get("time"))
    return times


def suites(tree):
    """The source files, below tests/, of each suite of GoogleTest's."""
    found = {}
    folder = Path(tree) / "tests"
    for path in sorted(folder.rglob("*.cpp")):
        for suite in SUITE.findall(path.read_text(encoding="utf-8", errors="replace")):
            found.setdefault(suite, set()).add(path.relative_to(folder).as_posix())
    return found


def mirrored(file):
    """(folder below tests/, beginning of the tests' names) of a file; for a plugin that is all of its tests."""
    parts = [part for part in PurePosixPath(file).parts[:-1] if part not in ("foredraw", "private")]
    if parts[0] in ("plugins", "evaluators") and len(parts) > 1:
        return "/".join(parts[:-1]), parts[-1]
    return "/".join(parts), PurePosixPath(file).stem


def distance(file, source):
    """How far a test's source is from a file: OWN to REST. None for what reads sources only."""
    folder, name = mirrored(file)
    place = PurePosixPath(source)
    top = place.parts[0]
    if top == READS_TEXT:
        return None
    if str(place.parent) == folder:
        if re.match(name + r"(_\w+)?_test$", place.stem):
            return OWN
        if not file.startswith(("plugins/", "evaluators/")):
            return ROOM
    return {"conformance": CONFORMANCE, "golden": GOLDEN}.get(top, REST)


class TestPlan:
    def __init__(self, tree, tests, objects, usual):
        """`tests` and `objects` are those of Build.prepare(), `usual` those of usual_times()."""
        self.sources, self.objects = suites(tree), objects
        self.programs, self.commands = [], []
        for test in tests:
            labels = next((p["value"] for p in test.get("properties", []) if p["name"] == "LABELS"), [])
            if test["name"] not in usual or "long" in labels or test["name"].startswith(READS_TEXT + "."):
                continue
            if is_google_test(test):
                chosen = next(a for a in test["command"] if a.startswith("--gtest_filter=")).partition("=")[2]
                self.programs.append((test["command"][0], Case(test["name"], chosen, usual[test["name"]], test)))
            else:
                self.commands.append(Case(test["name"], "", usual[test["name"]], test))

    def steps(self, file, units):
        """Steps of the tests whose programs hold one of the objects `units`; last, all tests that are commands, the quick
        ones before the slow ones."""
        name = mirrored(file)[1].replace("_", "")
        steps = {}
        for program, case in self.programs:
            if not units.intersection(self.objects[program]):
                continue
            suite = case.filter.split(".")[0]
            places = [self.sources[part] for part in suite.split("/") if part in self.sources]
            far = [distance(file, source) for source in (places[0] if places else ["rest"])]
            if None in far:
                continue
            calls_name = name in re.sub(r"[^a-z0-9]", "", case.name.lower())
            steps.setdefault((min(far), not calls_name and min(far) in (CONFORMANCE, GOLDEN), program), []).append(case)
        ordered = [(far, other, Step(program, cases)) for (far, other, program), cases in steps.items()]
        ordered.sort(key=lambda row: (row[0], row[1], row[2].usual()))
        quick = Step("", [case for case in self.commands if case.usual < 5])
        slow = Step("", [case for case in self.commands if case.usual >= 5])
        return [step for _, _, step in ordered] + [step for step in (quick, slow) if step.cases]
