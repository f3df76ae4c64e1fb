"""The package as a user has it: run with `python -m unittest` where it is installed."""

import json
import os
import tempfile
import unittest
from array import array
from decimal import Decimal
from fractions import Fraction

import passivity

SCENE = {"dimensionless": {"mu": 50, "beta": "3/5", "sigma": Fraction(3, 5)}}
SKETCH = {"dimensionless": {"mu": 10}}

try:
    import numpy
except ImportError:
    numpy = None


class Check(unittest.TestCase):
    def test_verdict(self):
        report = passivity.check(SCENE)
        self.assertEqual(report["verdict"], "passive")
        self.assertEqual(report["spare"]["viscous"]["lo"], "1/10")

    def test_scene_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.toml")
            with open(path, "w", encoding="utf-8") as file:
                file.write('[dimensionless]\nbeta = "2/5"\nsigma = "2/5"\n')
            self.assertEqual(passivity.check(path)["verdict"], "not_passive")

    def test_mistakes(self):
        with self.assertRaisesRegex(ValueError, "nonsense"):
            passivity.check({"nonsense": {}})
        with self.assertRaises(ValueError):
            passivity.check("/no/such/scene.toml")
        with self.assertRaises(ValueError):
            passivity.check({"dimensionless": {"beta": float("nan"), "sigma": 1}})


class Interval(unittest.TestCase):
    def test_counterexample_to_22(self):
        for half in ("1/2", 0.5, Fraction(1, 2), Decimal("0.5")):
            row = passivity.interval(1, half, beta="3/5", sigma=Decimal("0.6"))
            self.assertEqual(row["bound_22"], "3/8")
            self.assertEqual(Fraction(row["generated_quantized"]), Fraction(1, 2))
            self.assertTrue(row["violates_quantized"])
        with self.assertRaisesRegex(ValueError, "xi1"):
            passivity.interval(0, "x", beta=1, sigma=1)
        with self.assertRaises(ValueError):
            passivity.interval(0, float("nan"), beta=1, sigma=1)
        with self.assertRaisesRegex(ValueError, r"^beta: '\\udcff' is not a number$"):
            passivity.interval(0, 1, beta="\udcff", sigma=1)

    def test_a_float_is_the_dyadic_rational_that_it_is(self):
        floats = [0.1] if numpy is None else [0.1, numpy.float64(0.1), numpy.float32(0.1), numpy.float16(0.1)]
        for x in floats:
            row = passivity.interval(x, 1, beta=1, sigma=1)
            self.assertEqual(Fraction(row["xi0"]), Fraction(*x.as_integer_ratio()))
        if numpy is not None:
            with self.assertRaisesRegex(ValueError, "^xi0: inf is not a number"):
                passivity.interval(numpy.float32("inf"), 1, beta=1, sigma=1)

    def test_a_sweep_of_nothing_is_refused_in_pythons_words(self):
        for grid in ({}, {"vary": {}}, {"vary": {"stiffness": "1:2:3 N/m"}}):
            with self.assertRaisesRegex(ValueError, "^expected `beta` and `sigma`, or two or three parameters"):
                passivity.sweep(SCENE, **grid)


class Audit(unittest.TestCase):
    def test_counts_from_sequences_and_arrays(self):
        counts = [0, 1, 3, 2, -1]
        forms = [counts, tuple(counts), array("q", counts), array("i", counts)]
        if numpy is not None:
            forms += [numpy.array(counts), numpy.array(counts, dtype=numpy.int16)]
            forms.append(numpy.repeat(counts, 2)[::2])
        reports = [passivity.audit(form, SCENE) for form in forms]
        for report in reports:
            self.assertEqual(report, reports[0])
        self.assertEqual(reports[0]["intervals"], 4)
        self.assertEqual(reports[0]["positions"], "count")
        self.assertEqual(reports[0]["verdict"], "holds")

    def test_files_agree_with_arrays(self):
        with tempfile.TemporaryDirectory() as folder:
            trace = os.path.join(folder, "trace.csv")
            rows = os.path.join(folder, "rows.csv")
            with open(trace, "w", encoding="utf-8") as file:
                file.write("tau,xi\n0,0\n1,0.5\n2.5,-0.25\n")
            report = passivity.audit(trace, SCENE, out=rows)
            with open(rows, encoding="utf-8") as file:
                self.assertEqual(len(file.readlines()), 3)
        self.assertEqual(
            report, passivity.audit([0.0, 0.5, -0.25], SCENE, t=[0, 1, 2.5], t_unit=None)
        )
        self.assertEqual(report["timing"]["late"], 1)

    def test_units(self):
        scene = {
            "sampling": {"rate": "1 kHz"},
            "encoder": {"resolution": "0.25 mm"},
            "wall": {"stiffness": "1 N/mm"},
        }
        report = passivity.audit([0.0, 0.5], scene, unit="mm", t=[0.0, 0.25], t_unit="s")
        self.assertEqual(report["rows"][0]["xi1"], "2")
        self.assertEqual(report["rows"][0]["dtau"], "250")

    def test_mistakes(self):
        report = passivity.audit([0.0, 1.0, float("nan"), 2.0], SCENE)
        self.assertEqual(report["error"]["row"], 3)
        self.assertEqual(report["intervals"], 1)
        for wrong in (["a"], [[1, 2]], [2**70, 0], [1j]):
            with self.assertRaises(ValueError):
                passivity.audit(wrong, SCENE)
        with self.assertRaises(ValueError):
            passivity.audit([1, 2], SCENE, t=[0.0], t_unit=None)
        if numpy is not None:
            with self.assertRaises(ValueError):
                passivity.audit(numpy.zeros((2, 2)), SCENE)


class Simulate(unittest.TestCase):
    def test_motion_and_its_audit(self):
        scene = {**SCENE, "start": {"velocity": "10"}, "run": {"intervals": 5000}}
        result = passivity.simulate(scene)
        self.assertEqual(result["outcome"]["exact"], "at_rest")
        columns = result.columns
        self.assertEqual(columns["xi0"][0], 0.0)
        self.assertEqual(columns["v0"][0], 10.0)
        positions = list(columns["xi0"]) + [columns["xi1"][-1]]
        report = passivity.audit(positions, scene)
        self.assertEqual(report["verdict"], "holds")
        ours = float(Fraction(report["totals"]["generated_linear"]))
        self.assertAlmostEqual(ours, result["totals"]["generated_linear"], delta=1e-9)


class Errors(unittest.TestCase):
    def test_a_scene_says_where(self):
        text = '[sampling]\nperiod = "1 ms"\n[wall]\nstifness = "2 N m/rad"\n'
        with self.assertRaises(passivity.SceneError) as caught:
            passivity.check(text)
        error = caught.exception
        self.assertIsInstance(error, ValueError)
        self.assertEqual((error.kind, error.line), ("missing_key", 3))
        self.assertIsNotNone(json.loads(error.diagnostics))

    def test_a_scene_of_what_is_no_number_says_where(self):
        for value in (float("nan"), float("inf"), Decimal("nan")):
            with self.subTest(value=value), self.assertRaises(passivity.SceneError) as caught:
                passivity.check({"dimensionless": {"beta": 1, "sigma": value}})
            self.assertEqual(caught.exception.key, "dimensionless.sigma")

    def test_what_is_no_scene_is_named(self):
        for wrong in (b"x", 3, None):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(TypeError, "scene: expected the path"):
                passivity.check(wrong)

    def test_a_trace_says_where(self):
        with self.assertRaises(passivity.TraceError) as caught:
            passivity.audit([0.0, 1.0], SCENE, unit="kg")
        self.assertEqual((caught.exception.kind, caught.exception.column), ("unit", "x [kg]"))

    def test_a_text_is_the_path_of_a_log(self):
        for trace in ("nowhere.csv", ["nowhere.csv", "1/2"], ("nowhere.csv",)):
            with self.subTest(trace=trace), self.assertRaisesRegex(passivity.TraceError, "^`nowhere.csv`: .* path of a file$"):
                passivity.audit(trace, SCENE)

    def test_an_empty_text_is_a_scene_without_anything(self):
        for call in (passivity.check, passivity.simulate, lambda scene: passivity.audit([0, 1], scene)):
            with self.assertRaisesRegex(passivity.SceneError, "the scene has no"):
                call("")

    def test_a_number_that_is_too_large_has_a_row(self):
        columns = [([0, 1, 2**70], 3), ([0.5, 2**2000], 2), (memoryview(array("Q", [1, 2**63])), 2)]
        for values, row in columns:
            with self.assertRaisesRegex(ValueError, f"^trace: row {row}: "):
                passivity.audit(values, SCENE)

    def test_how_many_is_a_whole_number_in_a_range(self):
        limits = {
            "intervals": (1, 10**9, lambda n: passivity.simulate(SCENE, speed=3, intervals=n)),
            "effort": (1, 100_000, lambda n: passivity.identify("log.csv", SKETCH, effort=n)),
            "threads": (0, 1024, lambda n: passivity.audit([0, 1], SCENE, threads=n)),
        }
        for name, (least, most, call) in limits.items():
            for wrong in (least - 1, -(2**70), most + 1, 2**70, 1.5, "7", True):
                said = f"^{name}: expected a whole number from {least} to {most}, found {wrong!r}$"
                with self.subTest(wrong=wrong), self.assertRaisesRegex(ValueError, said):
                    call(wrong)
        for wrong in ({"intervals": 0}, {"threads": -1}):
            with self.assertRaisesRegex(ValueError, "expected a whole number"):
                passivity.sweep(SCENE, beta=1, sigma=1, **wrong)

    def test_a_motion_that_cannot_be(self):
        with self.assertRaises(passivity.SimulationError):
            passivity.simulate({"dimensionless": {"beta": 1, "sigma": 1}})


if __name__ == "__main__":
    unittest.main()
