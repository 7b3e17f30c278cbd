"""Runs make what the program makes, tell how far they are, and end when they are asked to."""

import json
import pickle
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

import foredraw as fd
from foredraw import _header
from foredraw._library import library
from meshes import HELMET, PROGRAM, SPOT

LINE = "weld, lookahead, vertex-fetch"


class Runs(unittest.TestCase):
    def test_make_the_bytes_and_the_report_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            done = fd.optimize(fd.read(SPOT), LINE)
            done.scene.write(folder + "/ours.glb")
            subprocess.run([PROGRAM, "optimize", SPOT, "-o", folder + "/theirs.glb", "-p", LINE, "--report",
                            folder + "/report.json"], check=True, capture_output=True)
            theirs = fd.read(folder + "/theirs.glb")
            self.assertEqual(Path(folder, "ours.glb").read_bytes(), Path(folder, "theirs.glb").read_bytes())
            report = json.loads(Path(folder, "report.json").read_text())
        self.assertEqual(done.report["totals"], report["totals"])
        self.assertEqual(len(theirs.draws), 1)

    def test_pipelines_are_lines_presets_texts_and_paths(self):
        scene = fd.read(SPOT)
        text = 'pipeline = 1\nstages = ["tipsify"]\nmeasure = ["vertex-cache"]\n'
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "mine.toml"
            path.write_text(text)
            outcomes = [fd.optimize(scene, one).report["totals"]["metrics"] for one in [text, path]]
            with self.assertRaises(FileNotFoundError):
                fd.optimize(scene, Path(folder) / "none.toml")
        self.assertEqual(outcomes[0], outcomes[1])
        self.assertEqual(list(outcomes[0]), ["vertex-cache"])
        fd.optimize(scene, "@cache-only")

    def test_measures_what_is_asked_for(self):
        scene = fd.read(SPOT)
        rows = fd.figures(fd.measure(scene, "vertex-cache(cache-size=24)")["totals"])
        self.assertEqual({row["evaluator"] for row in rows}, {"vertex-cache"})
        by_name = {row["metric"]: row for row in rows}
        draw = scene.draws[0]
        self.assertAlmostEqual(by_name["acmr"]["value"], fd.vertex_cache(draw.indices, cache_size=24).acmr)
        self.assertEqual(by_name["acmr"]["unit"], "misses per triangle")
        self.assertIn("models.fifo-32.acmr", by_name)  # which lies nested in the report
        self.assertIn("overdraw-raster", fd.measure(scene)["totals"]["metrics"])

    def test_what_is_wrong_is_said(self):
        scene = fd.read(SPOT)
        with self.assertRaisesRegex(fd.Error, "pipeline:1:7: error: .*'tipsfy'\n    hint: did you mean") as caught:
            fd.optimize(scene, "weld, tipsfy")
        self.assertEqual(caught.exception.diagnostics[0]["code"], "unknown-plugin")
        self.assertIsNone(caught.exception.result)
        with self.assertRaisesRegex(fd.Error, "vertex-cach"):
            fd.measure(scene, "vertex-cach")
        with self.assertRaisesRegex(ValueError, "a zero byte"):
            fd.optimize(scene, "weld\0")
        copy = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((str(copy), copy.diagnostics), (str(caught.exception), caught.exception.diagnostics))

    def test_what_a_failed_stage_left_comes_with_the_error(self):
        def fails(*arguments):
            self.assertEqual(optimize(*arguments), _header.DONE)
            return _header.FAILED

        optimize = library().optimize
        with mock.patch.object(library(), "optimize", fails), self.assertRaises(fd.Error) as caught:
            fd.optimize(fd.read(SPOT), "tipsify")
        self.assertEqual(len(caught.exception.result.scene.draws), 1)
        self.assertEqual(caught.exception.result.report["command"], "optimize")
        self.assertNotIsInstance(caught.exception, fd.Cancelled)

    def test_threads_share_a_context_and_a_scene(self):
        scene, context, outputs = fd.read(SPOT), fd.Context(threads=2), []
        def run():
            outputs.append(fd.optimize(scene, LINE, context=context).scene.draws[0].indices.tobytes())
        threads = [threading.Thread(target=run) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((len(outputs), len(set(outputs))), (4, 1))
        for wrong in [-1, 2**32]:
            with self.assertRaises(ValueError):
                fd.Context(threads=wrong)


class Progress(unittest.TestCase):
    def test_is_told_on_the_thread_that_asked(self):
        heard = []
        fd.optimize(fd.read(SPOT), LINE, progress=lambda what, part: heard.append((what, part, threading.get_ident())))
        parts = [part for _, part, _ in heard]
        self.assertEqual(parts, sorted(parts))
        self.assertEqual(parts[-1], 1)
        self.assertIn("lookahead", [what for what, _, _ in heard])
        self.assertEqual({thread for _, _, thread in heard}, {threading.get_ident()})

    def test_may_end_its_run_and_no_other(self):
        scene, context, heard, statuses, done = fd.read(SPOT), fd.Context(), [], {}, []
        in_c = library().optimize

        def optimize(*arguments):
            status = statuses[arguments[2]] = in_c(*arguments)
            return status

        def stops(what, part):
            heard.append(what)
            if len(heard) == 2:
                raise RuntimeError("enough")

        other = threading.Thread(target=lambda: done.append(fd.optimize(scene, "@default", context=context)))
        with mock.patch.object(library(), "optimize", optimize):
            other.start()
            with self.assertRaisesRegex(RuntimeError, "enough"):
                fd.optimize(scene, LINE, context=context, progress=stops)
            other.join()
        self.assertEqual(len(heard), 2)
        self.assertEqual(statuses, {LINE.encode(): _header.CANCELLED, b"@default": _header.DONE})
        self.assertEqual(len(done), 1)
        fd.optimize(scene, "tipsify", context=context)  # which goes on to be of use


class Ending(unittest.TestCase):
    def setUp(self):
        self.context = fd.Context()
        self.over = threading.Event()

    def assert_ends(self, end, kind):
        """What end() begins, on another thread, while a run of seconds goes on."""
        scene, in_c, statuses, begun = fd.read(HELMET), library().optimize, [], threading.Event()

        def optimize(*arguments):
            begun.set()
            statuses.append(in_c(*arguments))
            return statuses[0]

        def ends():
            begun.wait()
            worked = time.process_time()
            while time.process_time() < worked + 0.1:  # into a stage
                time.sleep(0.01)
            end()

        other = threading.Thread(target=ends)
        other.start()
        with mock.patch.object(library(), "optimize", optimize), self.assertRaises(kind):
            fd.optimize(scene, "@default", context=self.context)
        self.over.set()
        other.join()
        self.assertEqual(statuses, [_header.CANCELLED])
        self.assert_over()

    def assert_over(self):
        self.assertNotIn("foredraw", [thread.name for thread in threading.enumerate()])
        fd.optimize(fd.read(SPOT), "tipsify", context=self.context)  # which goes on to be of use

    def test_by_control_c(self):
        main = threading.main_thread().ident
        self.assert_ends(lambda: signal.pthread_kill(main, signal.SIGINT), KeyboardInterrupt)

    def test_by_control_c_while_progress_is_told(self):
        def interrupts(what, part):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            fd.optimize(fd.read(HELMET), "@default", context=self.context, progress=interrupts)
        self.assert_over()

    def test_by_control_c_before_it_begins(self):
        """Which comes while the worker starts: it begins nothing, or is cancelled."""

        class Interrupted(threading.Thread):
            def start(self):
                if is_early:
                    raise KeyboardInterrupt
                super().start()
                raise KeyboardInterrupt

        for is_early in [True, False]:
            with mock.patch.object(threading, "Thread", Interrupted), self.assertRaises(KeyboardInterrupt):
                fd.optimize(fd.read(HELMET), "@default", context=self.context)
            self.assert_over()

    def test_by_cancel(self):
        def cancels():
            while not self.over.wait(0.02):  # one that comes before the run begins is none
                self.context.cancel()

        self.assert_ends(cancels, fd.Cancelled)
