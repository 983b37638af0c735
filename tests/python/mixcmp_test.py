"""The Python module: arrays in and out, and its results held against the program."""

import json
import os
import pathlib
import subprocess
import tempfile
import threading
import typing
import unittest
import unittest.mock

import mixcmp
import numpy as np

SCENE = """
[comparison]
name = "spheres"
f = "(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2"
g = "(ri + rj)^2"
[inputs]
"c*" = { range = [0, 100] }
"r*" = { range = [0, 100] }
[reference]
format = "s53e8"
[reduced]
format = "s8e8"
[system]
lanes = 2
references = 1
"""
DATA = """
[data]
items = "uniform_spheres"
count = 40
radius_max = 25
pairs = "all"
"""
TIE = [0, 3, 0, 4, 0, 0, 2, 3]  # f = g = 25


def program(*arguments: str) -> str:
    run = subprocess.run([os.environ["MIXCMP_PROGRAM"], *arguments], check=True, text=True,
                         stdout=subprocess.PIPE)
    return run.stdout


class ModuleTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "scene.toml"
        self.file.write_text(SCENE + DATA)
        self.scene = mixcmp.Scene.from_file(self.file)

    def test_check_is_that_of_the_program(self):
        printed = json.loads(program("check", str(self.file), "--json"))
        del printed["generate"]
        self.assertEqual(self.scene.check(), printed)
        self.assertTrue(program("check", str(self.file)).startswith(self.scene.summary()))

    def test_properties(self):
        self.assertEqual(self.scene.name, "spheres")
        self.assertEqual(self.scene.inputs,
                         ["cxi", "cxj", "cyi", "cyj", "czi", "czj", "ri", "rj"])
        self.assertEqual((self.scene.reference_format, self.scene.reduced_format),
                         ("s53e8", "s8e8"))
        self.assertEqual(self.scene.comparison_count, 780)
        self.assertIn("(ri + rj)^2", repr(self.scene))

    def test_rows_that_numpy_would_convert_with_a_loss_of_meaning_are_refused(self):
        system = mixcmp.System(self.scene)
        row = [[0, 3, 0, 4, 0, 0, 2, 3]]
        hidden = np.ma.array(row, mask=[[0, 0, 0, 0, 0, 0, 0, 1]])
        for rows in (np.array(row, dtype=complex), hidden, np.array(row).astype(str),
                     np.array(row, dtype="m8[s]"), [["a"] * 8], [[1], [1, 2]],
                     [[10 ** 400] * 8]):
            with self.assertRaisesRegex(mixcmp.Error, "^rows: no real numbers"):
                system.emulate(rows)
        expected = system.emulate(np.array(row, dtype=float)).verdict
        for rows in (row, np.asfortranarray(row), np.array(row, dtype=">i2"),
                     np.array(row, dtype=object), np.ma.array(row)):
            self.assertEqual(system.emulate(rows).verdict, expected)

    def test_verdicts_are_those_of_numpy_and_of_the_golden_model(self):
        rows = self.scene.operands()
        self.assertEqual(rows.shape, (780, 8))
        differences = rows[:, 0:6:2] - rows[:, 1:6:2]
        f, g = (differences ** 2).sum(axis=1), (rows[:, 6] + rows[:, 7]) ** 2
        expected = np.where(f < g, mixcmp.Verdict.LESS, mixcmp.Verdict.GREATER)
        system = mixcmp.System(self.scene)
        answers = system.emulate(rows)
        np.testing.assert_array_equal(answers.verdict, expected)
        np.testing.assert_array_equal(self.scene.true_verdicts(rows), expected)
        self.assertGreater(answers.recomputed.sum(), 0)
        self.assertLess(answers.recomputed.mean(), 0.2)
        self.assertFalse(answers.undecided.any())
        golden = system.evaluate(rows)
        np.testing.assert_array_equal(golden.verdict, answers.verdict)
        np.testing.assert_array_equal(golden.recomputed, answers.recomputed)

    def test_arrays_of_any_type_and_layout(self):
        system = mixcmp.System(self.scene)
        rows = np.array([TIE, TIE[::-1]], dtype=np.float32)
        for same in (rows, rows.tolist(), np.asfortranarray(rows), rows.repeat(2, axis=0)[::2]):
            np.testing.assert_array_equal(system.emulate(same).verdict,
                                          system.emulate(rows).verdict)
        self.assertEqual(len(system.emulate(np.empty((0, 8))).verdict), 0)

    def test_a_tie_is_undecided_where_nothing_recomputes(self):
        scene = mixcmp.Scene.from_text(SCENE, ["system.references=0"])
        self.assertTrue(mixcmp.System(scene).emulate([TIE]).undecided[0])
        answers = mixcmp.System(self.scene).emulate([TIE])
        self.assertEqual(answers.verdict[0], mixcmp.Verdict.EQUAL)
        self.assertTrue(answers.recomputed[0])

    def test_mistakes_are_exceptions_with_their_place(self):
        with self.assertRaises(mixcmp.Error) as raised:
            mixcmp.Scene.from_text(SCENE.replace("s8e8", "s99e8"), folder=self.folder)
        error = raised.exception
        self.assertEqual((error.field, error.received), ("reduced.format", '"s99e8"'))
        self.assertEqual(error.line, 12)
        self.assertIn("accepted", str(error))
        self.assertIsInstance(error, ValueError)
        system = mixcmp.System(self.scene)
        for wrong in ([1.0] * 8, np.zeros((2, 7)), np.zeros((2, 8, 1))):
            with self.assertRaisesRegex(mixcmp.Error, r"accepted \(comparisons, 8\)"):
                system.emulate(wrong)
        for wrong in ([TIE[:-1] + [2j]], [TIE[:-1] + ["2"]], [["2"] * 8], [TIE, [1.0]],
                      [TIE[:-1] + [None]], np.array([TIE[:-1] + ["2"]], dtype=object)):
            with self.assertRaisesRegex(mixcmp.Error, "rows: no real numbers"):
                system.emulate(wrong)
        for name, call in {"first": lambda: self.scene.operands(first=-1),
                           "count": lambda: self.scene.operands(count=-1),
                           "group": lambda: system.evaluate([TIE], group=-1),
                           "threads": lambda: mixcmp.profile(self.scene, threads=-1),
                           "error_samples": lambda: mixcmp.profile(self.scene, error_samples=-1),
                           "lane_mhz": lambda: mixcmp.plan(self.scene, lane_mhz=-5.0)}.items():
            with self.assertRaises(mixcmp.Error) as raised:
                call()
            self.assertEqual(raised.exception.field, name)
        with self.assertRaisesRegex(mixcmp.Error, "folder"):
            system.generate("")
        with self.assertRaisesRegex(mixcmp.Error, "row 0, cxi.*out of range"):
            system.emulate([[1e200] + [0] * 7])
        with self.assertRaisesRegex(mixcmp.Error, "no such group"):
            system.emulate([TIE], group=1)
        with self.assertRaises(mixcmp.Error):
            mixcmp.Scene.from_file(self.folder / "absent.toml")

    def test_files_are_those_of_the_program(self):
        program("generate", str(self.file), "--no-prove", "-o", str(self.folder / "program"))
        system = mixcmp.System(self.scene)
        system.generate(self.folder / "module")
        names = {each.name for each in (self.folder / "program").iterdir()}
        self.assertEqual(set(system.files()), names)
        for name, text in system.files().items():
            self.assertEqual((self.folder / "program" / name).read_text(), text, name)
            self.assertEqual((self.folder / "module" / name).read_text(), text, name)
        self.assertEqual((system.lane_count, system.reference_count, system.certified),
                         (2, 1, True))
        self.assertEqual(system.lanes[0].format, "s8e8")

    def test_profile_counts_what_the_program_counts(self):
        printed = json.loads(program("profile", str(self.file), "--first", "8", "--last", "10",
                                     "--json"))
        counted = mixcmp.profile(self.scene, first_precision=8, last_precision=10)
        for scheme in printed["recomputation_rates"][0]["schemes"]:
            ours = counted.schemes[scheme["scheme"]]
            self.assertEqual(ours.certified, scheme["certified"])
            for name in ("precision", "undecided", "wrong", "wrong_by_lane"):
                self.assertEqual(getattr(ours, name).tolist(),
                                 [each[name] for each in scheme["precisions"]])
        errors = printed["relative_errors"][0]["precisions"]
        np.testing.assert_allclose(counted.f_error, [each["f_error"] for each in errors],
                                   rtol=1e-15)
        np.testing.assert_allclose(counted.f_bound, [each["f_bound"] for each in errors],
                                   rtol=1e-15)

    def test_profile_takes_arrays(self):
        rows = self.scene.operands()
        scene = mixcmp.Scene.from_text(SCENE).with_operands(rows)
        ours = mixcmp.profile(scene, first_precision=8, last_precision=8)
        files = mixcmp.profile(self.scene, first_precision=8, last_precision=8)
        self.assertEqual(ours.schemes["relative"].undecided.tolist(),
                         files.schemes["relative"].undecided.tolist())
        with self.assertRaisesRegex(mixcmp.Error, "needs data"):
            mixcmp.profile(mixcmp.Scene.from_text(SCENE))

    def test_progress_is_told_and_ends_nothing_where_it_raises(self):
        scene = mixcmp.Scene.from_file(self.file, ["data.count=400"])
        steps = []

        def progress(step, share):
            steps.append((step, share))
            raise RuntimeError("from a callback")

        with unittest.mock.patch("sys.unraisablehook") as hook:
            counted = mixcmp.profile(scene, first_precision=8, last_precision=8,
                                     progress=progress)
        self.assertEqual(counted.comparisons, 79800)
        self.assertEqual({step for step, _ in steps}, {"relative errors", "recomputation rates"})
        self.assertTrue(all(0 <= share <= 1 for _, share in steps))
        self.assertEqual(hook.call_count, len(steps))

    def test_threads_share_a_system(self):
        rows = np.repeat(self.scene.operands(), 50, axis=0)
        system = mixcmp.System(self.scene)
        expected = system.emulate(rows).verdict
        results = [None] * 4

        def run(k):
            results[k] = system.emulate(rows).verdict

        threads = [threading.Thread(target=run, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            np.testing.assert_array_equal(result, expected)

    def test_verify_has_the_report_of_the_program(self):
        lines = []
        run = mixcmp.verify(self.scene, simulator="icarus", truth="all", first=60,
                            work=self.folder / "work", progress=lines.append)
        self.assertTrue(run.passed, run.text)
        self.assertEqual((run.comparisons, run.mismatches, run.violations), (60, 0, 0))
        self.assertIn("60 of 60 comparisons", lines[-1])
        printed = json.loads(program("verify", str(self.file), "--simulator", "icarus", "--truth",
                                     "all", "--first", "60", "--work",
                                     str(self.folder / "work"), "--quiet", "--json"))
        for report in (printed, run.report):
            for time in ("build_seconds", "run_seconds"):
                del report[time]
        self.assertEqual(run.report, printed)
        with self.assertRaisesRegex(mixcmp.Error, "accepted full_rate, stressed"):
            mixcmp.verify(self.scene, traffic="fast")
        with self.assertRaisesRegex(mixcmp.Error, "needs data"):
            mixcmp.verify(mixcmp.Scene.from_text(SCENE))
        with self.assertRaises(mixcmp.Error) as raised:
            mixcmp.verify(self.scene, only=780)
        self.assertEqual(raised.exception.field, "only")

    def test_plan_needs_a_table(self):
        with self.assertRaisesRegex(mixcmp.Error, "mixcmp characterise"):
            mixcmp.plan(self.scene)

    def test_plan_is_a_scene_again(self):
        table = self.folder / "table.csv"
        table.write_text(TABLE)
        found = mixcmp.plan(self.scene, table=table, last_precision=14)
        self.assertGreater(found.best.throughput_per_s, found.baseline_per_s)
        self.assertEqual([point.precision for point in found.points], [8, 12])
        (self.folder / "plan.toml").write_text(found.toml)
        system = mixcmp.System(mixcmp.Scene.from_file(self.folder / "plan.toml"))
        self.assertEqual((system.lane_count, system.reference_count),
                         (found.best.lanes, found.best.references))
        self.assertIn("p_L", found.text)

    def test_every_public_name_has_a_docstring_and_types(self):
        for name in mixcmp.__all__:
            self.assertTrue(getattr(mixcmp, name).__doc__, name)
        hints = typing.get_type_hints(mixcmp.profile)
        self.assertIs(hints["return"], mixcmp.Profile)
        self.assertIs(typing.get_type_hints(mixcmp.PlanPoint)["clock_mhz"], float)
        self.assertIs(typing.get_type_hints(mixcmp.LaneGroup)["count"], int)
        self.assertIn("points", typing.get_type_hints(mixcmp.Plan))


TABLE = """\
# device: virtex6-lx760
# scene: spheres
# command: made up
# target_mhz: 250
kind,name,format,inputs,bound,multipliers,initiation_interval,ports,latency_cycles,luts,\
registers,dsps,memories,carries,shift_luts,mhz,low_mhz,high_mhz,seeds,clock_source,timing_seeds,hash,tools
lane,,s8e8,exact,relative,embedded,0,0,20,2000,2000,4,0,0,0,,,,,,0,00,made up
lane,,s12e8,exact,relative,embedded,0,0,20,2500,2500,4,0,0,0,,,,,,0,00,made up
reference,,s53e8,,,embedded,1,0,30,8000,8000,40,0,0,0,,,,,,0,00,made up
fifo,,,,,,0,64,0,300,300,0,0,0,0,,,,,,0,00,made up
crossbar,,,,,,0,1,0,10,10,0,0,0,0,,,,,,0,00,made up
crossbar,,,,,,0,256,0,2000,2000,0,0,0,0,,,,,,0,00,made up
"""

if __name__ == "__main__":
    unittest.main()
