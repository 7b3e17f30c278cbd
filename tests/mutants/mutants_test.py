"""What may be changed, where a changed line is found again, and which tests come first."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from changes import changes
from code_lines import code_lines
from mutant import Mutant, Source, apply, place
from test_plan import CONFORMANCE, OWN, REST, ROOM, TestPlan, distance


def changed(kind, line, above="{", below="}"):
    code = dict(code_lines(line)).get(0)
    return changes(kind, line, code, above, below) if code else []


class Changes(unittest.TestCase):
    def test_only_code_is_changed(self):
        for line in ['text = "a + 1 < b";  // i + 1', "#if A < 2", "static_assert(a < 2);", "/* a = 1; */", "std::vector<int> a;"]:
            for kind in ["operator", "constant", "condition"]:
                self.assertEqual(changed(kind, line), [], line)

    def test_kinds(self):
        self.assertEqual(changed("operator", "a = b + c;"), ["a = b - c;"])
        self.assertEqual(changed("constant", "a = b[1] + 0.5f;"), ["a = b[2] + 0.5f;", "a = b[0] + 0.5f;", "a = b[1] + 2 * 0.5f;"])
        self.assertEqual(changed("condition", "if (a < f(b)) {"), ["if (a <= f(b)) {", "if (!(a < f(b))) {"])
        self.assertEqual(changed("condition", "for (int i = 0; i < n; ++i) {"), [])
        self.assertEqual(changed("deletion", "  a.b = c(d);"), ["  ;"])
        self.assertEqual(changed("deletion", "if (a) return b;"), [";"])

    def test_whole_statements_are_deleted(self):
        for line, above, below in [("const int a = b;", "{", "}"), ("return a;", "{", "}"), ("a = b;", "c =", "}"),
                                   ("if (a) b();", "{", "else c();"), ("f(a, b));", "{", "}")]:
            self.assertEqual(changed("deletion", line, above, below), [], line)


class Places(unittest.TestCase):
    TEXT = "int a() {\n  b();\n  c = 1;\n}\n\nint d() {\n  c = 1;\n  e();\n}\n"

    def tree(self, files):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name, text in files.items():
            (Path(folder.name) / name).parent.mkdir(parents=True, exist_ok=True)
            (Path(folder.name) / name).write_text(text)
        return folder.name

    def mutant(self, number):
        function, above, below = Source(self.TEXT).around(number)
        return Mutant("m01", "constant", "plugins/x/y.cpp", function, above, "c = 1;", below, "c = 2;")

    def test_a_line_is_found_by_its_function(self):
        tree = self.tree({"plugins/x/y.cpp": self.TEXT})
        self.assertEqual(place(self.mutant(2), tree), ("plugins/x/y.cpp", 2))
        self.assertEqual(place(self.mutant(6), tree), ("plugins/x/y.cpp", 6))

    def test_a_line_is_found_where_its_file_moved_and_grew(self):
        tree = self.tree({"framework/z/y.cpp": "int f;\n" + self.TEXT, "plugins/x/other.cpp": "int a() {\n  c = 1;\n}\n"})
        self.assertEqual(place(self.mutant(2), tree), ("framework/z/y.cpp", 3))

    def test_a_line_that_is_gone_is_not_taken_for_another(self):
        tree = self.tree({"plugins/x/y.cpp": "int a() {\n  b();\n}\n\nint g() {\n  h();\n  c = 1;\n  i();\n}\n"})
        self.assertIsNone(place(self.mutant(2), tree))

    def test_apply_keeps_all_other_lines(self):
        tree = self.tree({"plugins/x/y.cpp": self.TEXT})
        self.assertEqual(apply(self.mutant(2), tree, "plugins/x/y.cpp", 2), self.TEXT)
        self.assertEqual((Path(tree) / "plugins/x/y.cpp").read_text(), self.TEXT.replace("c = 1;", "c = 2;", 1))


class Plan(unittest.TestCase):
    def test_distances(self):
        gltf = "framework/foredraw/io/gltf/private/gate.cpp"
        self.assertEqual(distance(gltf, "framework/io/gltf/gate_test.cpp"), OWN)
        self.assertEqual(distance(gltf, "framework/io/gltf/draco_test.cpp"), ROOM)
        self.assertEqual(distance(gltf, "framework/io/mesh/gate_test.cpp"), REST)
        plugin = "plugins/processors/weld/vertex_groups.cpp"
        self.assertEqual(distance(plugin, "plugins/processors/weld_files_test.cpp"), OWN)
        self.assertEqual(distance(plugin, "plugins/processors/prune_test.cpp"), REST)
        self.assertEqual(distance(plugin, "conformance/cards_test.cpp"), CONFORMANCE)
        self.assertIsNone(distance(plugin, "architecture/rules_test.cpp"))

    def test_steps_are_the_programs_that_hold_the_unit_nearest_first(self):
        with tempfile.TemporaryDirectory() as tree:
            suites = {"plugins/processors/weld_test.cpp": "Weld", "conformance/cards_test.cpp": "Cards",
                      "plugins/processors/prune_test.cpp": "Prune", "framework/base/text_test.cpp": "Text"}
            for file, suite in suites.items():
                path = Path(tree) / "tests" / file
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(f"TEST({suite}, a) {{}}")
            programs = {"Weld": "plugins", "Prune": "plugins", "All/Cards": "conformance", "Text": "base"}
            tests = [{"name": f"{program}.{suite}.a", "command": [program, f"--gtest_filter={suite}.a"]}
                     for suite, program in programs.items()]
            tests.append({"name": "packages.c", "command": ["cc"]})
            objects = {"plugins": ["weld.o"], "conformance": ["weld.o"], "base": ["base.o"]}
            plan = TestPlan(tree, tests, objects, {test["name"]: 1.0 for test in tests})
            steps = plan.steps("plugins/processors/weld/weld.cpp", {"weld.o"})
            self.assertEqual([[case.name for case in step.cases] for step in steps],
                             [["plugins.Weld.a"], ["conformance.All/Cards.a"], ["plugins.Prune.a"], ["packages.c"]])


unittest.main()
