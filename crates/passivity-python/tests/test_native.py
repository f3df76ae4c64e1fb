"""Habits of the ecosystem: containers, errors with places, interrupts, progress, results in notebooks."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import unittest
from array import array
from fractions import Fraction

import passivity

SCENE = {"dimensionless": {"mu": 50, "beta": "3/5", "sigma": Fraction(3, 5)}}
ROTARY = {
    "device": {"inertia": "6.28e-6 kg m^2", "viscous": "9e-6 N m s/rad", "coulomb": "2e-3 N m"},
    "sampling": {"period": "1 ms"},
    "encoder": {"counts_per_revolution": 8192},
    "wall": {"stiffness": "2 N m/rad"},
}
COUNTS = [0, 1, 3, 2, -1]


def pushed():
    """A log of a device with μ = 10, β = 0 and σ = 1, pushed with 10 KΔ for ten samples: it coasts to rest."""

    def way(n):
        return 45 * n * n // 100 if n <= 10 else 45 + (900 * (n - 10) - 5 * (n - 10) ** 2) // 100

    rows = (f"{way(min(n, 100))},{10 if n < 10 else 0}\n" for n in range(120))
    return "count,f\n" + "".join(rows)


SKETCH = {"dimensionless": {"mu": 10}}
FLOATS = [0.0, 0.5, 1.25, -0.5]


def optional(name):
    try:
        return __import__(name)
    except ImportError:
        return None


numpy, pandas, polars, pyarrow = map(optional, ("numpy", "pandas", "polars", "pyarrow"))


class Containers(unittest.TestCase):
    def test_integers_are_counts_and_floats_are_positions(self):
        forms = {"list": list, "tuple": tuple}
        if numpy is not None:
            forms |= {
                "list of numpy": lambda x: list(numpy.array(x)),
                "numpy": numpy.array,
                "big-endian": lambda x: numpy.array(x).astype(numpy.array(x).dtype.newbyteorder(">")),
                "strided": lambda x: numpy.repeat(x, 2)[::2],
                "objects": lambda x: numpy.array(x, dtype=object),
                "unmasked": lambda x: numpy.ma.array(x).filled(0),
            }
        if pandas is not None:
            forms |= {"pandas": pandas.Series, "index": pandas.Index}
            forms["nullable"] = lambda x: pandas.Series(x).astype({"i": "Int64", "f": "Float64"}[numpy.array(x).dtype.kind])
        if polars is not None:
            forms["polars"] = lambda x: polars.Series("a", x)
            forms["polars chunks"] = lambda x: polars.concat(
                [polars.Series("a", x[:2]), polars.Series("a", x[2:])], rechunk=False
            )
        if pyarrow is not None:
            forms["arrow"] = pyarrow.array
            forms["arrow slice"] = lambda x: pyarrow.array([x[0], *x])[1:]
            forms["arrow chunks"] = lambda x: pyarrow.chunked_array([x[:1], x[1:]])
        for values, kind, code in ((COUNTS, "count", "q"), (FLOATS, "xi", "d")):
            expected = passivity.audit(array(code, values), SCENE)
            self.assertEqual(expected["positions"], kind)
            for name, form in forms.items():
                with self.subTest(name=name, kind=kind):
                    self.assertEqual(passivity.audit(form(values), SCENE), expected)

    def test_smaller_numbers_are_the_same(self):
        expected = passivity.audit(COUNTS, SCENE)
        if numpy is not None:
            for kind in ("int8", "int16", "int32", "int64"):
                self.assertEqual(passivity.audit(numpy.array(COUNTS, dtype=kind), SCENE), expected)
            positive = passivity.audit([0, 1, 3], SCENE)
            for kind in ("uint8", "uint64"):
                self.assertEqual(passivity.audit(numpy.array([0, 1, 3], dtype=kind), SCENE), positive)
        if pyarrow is not None:
            for kind in (pyarrow.int8(), pyarrow.int16(), pyarrow.int32()):
                self.assertEqual(passivity.audit(pyarrow.array(COUNTS, kind), SCENE), expected)

    @unittest.skipIf(pyarrow is None or numpy is None, "of Arrow and NumPy")
    def test_floats_of_16_bits(self):
        values = numpy.array([3, 0, 0.5, -0.25], dtype=numpy.float16)
        expected = passivity.audit(values[1:], SCENE)
        halves = pyarrow.array(values)
        for column in (halves.slice(1), pyarrow.chunked_array([halves.slice(1, 1), halves.slice(2)])):
            self.assertEqual(passivity.audit(column, SCENE), expected)

    def test_a_column_of_nothing_is_too_short(self):
        columns = [[], (), array("q"), array("d")]
        if numpy is not None:
            columns.append(numpy.array([]))
        if polars is not None:
            columns.append(polars.Series([], dtype=polars.Int64))
        if pyarrow is not None:
            columns.append(pyarrow.array([], pyarrow.int64()))
        for values in columns:
            with self.subTest(values=repr(values)):
                report = passivity.audit(values, SCENE, t=[], t_unit=None, f=array("d"))
                self.assertEqual((report.verdict, report.samples), ("broken", 0))
                self.assertIn("two samples", report.error.message)

    def test_an_integer_among_floats_is_a_double(self):
        self.assertEqual(passivity.audit([2**53, 0.5], SCENE).positions, "xi")
        with self.assertRaisesRegex(ValueError, "trace: no double is 9007199254740993"):
            passivity.audit([2**53 + 1, 0.5], SCENE)

    def test_what_is_no_column_is_refused(self):
        wrong = [{1, 2}, frozenset([1]), {1: 2}, b"12", [True, False], [1, "2"], [None, 1], [Fraction(1, 3)]]
        if numpy is not None:
            wrong += [numpy.ma.array([1, 2], mask=[0, 1]), numpy.array([True]), numpy.array([1j])]
            wrong += [numpy.array([2**63], dtype=numpy.uint64), numpy.array(["2"]), numpy.zeros((2, 2))]
        if pandas is not None:
            wrong.append(pandas.Series([1, None], dtype="Int64"))
        if polars is not None:
            wrong += [polars.Series([1, None]), polars.Series(["a"]), polars.Series([True])]
        if pyarrow is not None:
            wrong += [pyarrow.array([1, None]), pyarrow.array(["a"]), pyarrow.chunked_array([[1], [None]])]
        for values in wrong:
            with self.subTest(values=repr(values)), self.assertRaises(ValueError):
                passivity.audit(values, SCENE)

    def test_a_count_that_does_not_fit_is_an_error_of_its_row(self):
        columns = [[0, 2**63]]
        if numpy is not None:
            columns.append(numpy.array([0, 2**63], dtype=numpy.uint64))
        if polars is not None:
            columns.append(polars.Series([0, 2**63], dtype=polars.UInt64))
        if pyarrow is not None:
            columns.append(pyarrow.array([0, 2**63], pyarrow.uint64()))
            columns.append(pyarrow.chunked_array([[0], [2**63]], pyarrow.uint64()))
        for values in columns:
            with self.subTest(values=repr(values)), self.assertRaisesRegex(ValueError, "trace: row 2: expected an integer from"):
                passivity.audit(values, SCENE)

    def test_forces_and_times(self):
        stiff = {"dimensionless": {"mu": 50, "beta": "3/5", "sigma": "3/5"}}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "log.csv")
            with open(path, "w", encoding="utf-8") as file:
                # Whole numbers may be off by half a unit, in a file as in memory.
                file.write("tau,count,f\n0,0,0\n1,1,-1\n2.5,3,-3\n3.5,2,-2\n")
            expected = passivity.audit(path, stiff)
        report = passivity.audit([0, 1, 3, 2], stiff, t=[0, 1, 2.5, 3.5], t_unit=None, f=[0, -1, -3, -2])
        self.assertEqual(report, expected)
        self.assertEqual(report.account, "applied")
        law = passivity.audit([0, 1, 3, 2], stiff, t=[0, 1, 2.5, 3.5], t_unit=None, f=[0, 1, 3, 2], law=True)
        self.assertEqual(law.account, "law")
        report = passivity.audit([0, 1, 3, 2], ROTARY, f=[0.0, 1.0, 0.0, 0.0], f_unit="mN m")
        self.assertEqual(report.force.compared, 4)
        for wrong in ({"f": [1.0]}, {"f_unit": "N"}, {"f": [1.0, 2.0], "f_unit": "kg"}):
            with self.assertRaises(ValueError):
                passivity.audit([1, 2], ROTARY, **wrong)


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        path = os.path.join(self.folder.name, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path

    def read(self, path):
        with open(path, encoding="utf-8") as file:
            return file.read()


class Files(InFolder):
    def test_columns_and_several_files(self):
        log = self.path("log.csv", "time;pos\n0,0;0\n1,0;1\n")
        report = passivity.audit(
            log, ROTARY, columns={"t": "time [ms]", "count": "pos"}, delimiter=";", decimal_comma=True
        )
        self.assertEqual((report.intervals, report.timing.uneven), (1, 0))
        a, b = self.path("a.csv", "count\n0\n1\n"), self.path("b.csv", "count\n3\n")
        self.assertEqual(passivity.audit([a, b], SCENE), passivity.audit([0, 1, 3], SCENE))

    def test_nothing_that_is_read_is_written_over(self):
        scene = self.path("scene.toml", '[dimensionless]\nmu = "50"\nbeta = "1"\nsigma = "1"\n')
        log = self.path("log.csv", "count\n0\n1\n")
        link = self.path("link.csv")
        os.symlink(log, link)
        grid = {"beta": "0:1:2", "sigma": "1/2", "speed": 5}
        for out in (scene, log, link, self.folder.name, "/dev/null"):
            before = self.read(log), self.read(scene)
            with self.assertRaises(ValueError, msg=out):
                passivity.audit(log, scene, out=out)
            if out != log:
                with self.assertRaises(ValueError, msg=out):
                    passivity.sweep(scene, out=out, **grid)
            self.assertEqual(before, (self.read(log), self.read(scene)))

    def test_sweep(self):
        grid = {"beta": "0:1:3", "sigma": [Fraction(1, 4), 0.5], "speed": 5, "intervals": 500}
        told = []
        out = self.path("grid.csv")
        report = passivity.sweep(SCENE, out=out, progress=lambda *done: told.append(done), **grid)
        self.assertEqual((report.points, report.simulated, told[-1]), (6, 6, (6, 6)))
        self.assertEqual(report.axes, ["beta", "sigma", "speed"])
        again = passivity.sweep(SCENE, out=out, resume=True, **grid)
        self.assertEqual((again.simulated, again.exact), (0, report.exact))
        here = passivity.sweep(SCENE, **grid)
        self.assertEqual(here.columns, report.columns)
        self.assertIn("<svg", report._repr_html_())
        varied = passivity.sweep(
            ROTARY, vary={"stiffness": "0.5:2:3 N m/rad", "velocity": "1,5 rad/s"}, intervals=50
        )
        self.assertEqual((varied.points, varied.axes[0]), (6, "stiffness [N m/rad]"))
        with self.assertRaises(passivity.SimulationError):
            passivity.sweep(SCENE, beta="0:1", sigma="1")
        if pyarrow is not None:
            table = passivity.sweep(SCENE, out=self.path("grid.parquet"), **grid).to_arrow()
            self.assertEqual(table.to_pydict(), report.columns)

    @unittest.skipUnless(polars and pyarrow and numpy, "needs polars, pyarrow and numpy")
    def test_polars_in_and_out_without_copies(self):
        frame = polars.DataFrame({"time": [0.0, 1.0, 2.5, 3.0], "count": [0, 1, 3, 2]})
        given = passivity.audit(frame["count"], SCENE, t=frame["time"], t_unit=None)
        self.assertEqual(given, passivity.audit([0, 1, 3, 2], SCENE, t=[0, 1, 2.5, 3], t_unit=None))
        for name in frame.columns:
            read, _ = passivity._arrays.numbers(frame[name], name)
            there = frame[name].to_numpy(allow_copy=False)
            self.assertEqual(numpy.asarray(read).ctypes.data, there.ctypes.data)
        table = passivity.sweep(SCENE, beta="0:1:5", sigma="0:1:5", speed=2, intervals=50).to_arrow()
        points = polars.from_arrow(table)
        self.assertEqual(points.shape, (25, 8))
        address = points["beta"].to_numpy(allow_copy=False).ctypes.data
        self.assertEqual(address, table["beta"].chunk(0).buffers()[1].address)


class Identify(InFolder):
    def test_bounds_hold_what_is_true(self):
        log = self.path("push.csv", pushed())
        sketch = self.path("sketch.toml", "[dimensionless]\nmu = 10\n")
        told = []
        found = passivity.identify(log, sketch, effort=5, progress=lambda done, most: told.append((done, most)))
        self.assertIsInstance(found, passivity.Identification)
        viscous, coulomb = found.parameters.viscous, found.parameters.coulomb
        self.assertTrue(viscous.lo <= 0 <= viscous.hi and coulomb.lo <= 1 <= coulomb.hi, found.parameters)
        self.assertTrue(coulomb.lo <= coulomb.best <= coulomb.hi)
        self.assertEqual((found.samples, found.refuted_by, found.parameters.inertia), (120, None, None))
        self.assertEqual(len(found.logs[0].sha256), 64)
        self.assertTrue(told and all(most == 5_000_000 for _, most in told), told)
        self.assertEqual(told, sorted(told))
        # What was found is a scene, and the sketch may come in every form.
        self.assertTrue(passivity.check(found.toml)["sigma"]["lo"] != passivity.check(found.toml)["sigma"]["hi"])
        with open(sketch, encoding="utf-8") as file:
            text = file.read()
        for other in (SKETCH, text):
            self.assertEqual(passivity.identify(log, other, effort=5).parameters, found.parameters)
        # A picture, a table, and two logs that say no less than one.
        self.assertTrue(found.svg().startswith("<svg") and found.svg() in found._repr_html_())
        shorter = self.path("shorter.csv", "\n".join(pushed().split("\n")[:-2]) + "\n")
        both = passivity.identify([log, shorter], SKETCH, effort=10).parameters.coulomb
        self.assertLessEqual(both.hi - both.lo, (coulomb.hi - coulomb.lo) * 1.01)
        if pyarrow is not None:
            self.assertEqual(found.to_arrow()["parameter"].to_pylist(), ["viscous", "coulomb"])

    def test_a_scene_is_written(self):
        log, out = self.path("push.csv", pushed()), self.path("device.toml")
        found = passivity.identify(log, SKETCH, effort=5, out=out, device="knob 3", date="2026-11-22")
        self.assertEqual(self.read(out), found.toml)
        self.assertIn("# Device: knob 3\n# Recorded: 2026-11-22\n", found.toml)
        with self.assertRaises(ValueError):
            passivity.identify(log, SKETCH, out=log)
        self.assertEqual(self.read(log), pushed())

    def test_a_log_that_does_not_fit_is_refuted_there(self):
        still = self.path("still.csv", "count,f\n" + "0,0\n" * 5 + "0,9\n" * 5 + "99,0\n" * 5)
        found = passivity.identify(still, SKETCH, effort=1)
        self.assertEqual((found.refuted_by.row, found.toml), (11, None))
        self.assertIsNone(found.parameters.viscous)

    def test_mistakes_say_where(self):
        log = self.path("push.csv", pushed())
        torn = self.path("torn.csv", "count,f\n0,0\n1,x\n")
        with self.assertRaises(passivity.TraceError) as caught:
            passivity.identify([log, torn], SKETCH)
        self.assertEqual((caught.exception.row, caught.exception.column), (2, "f"))
        self.assertEqual(caught.exception.file, torn)
        with self.assertRaisesRegex(passivity.TraceError, "the force"):
            passivity.identify(self.path("bare.csv", "count\n0\n1\n"), SKETCH)
        with self.assertRaises(passivity.SceneError) as caught:
            passivity.identify(log, '[dimensionless]\nmu = "ten"\n')
        self.assertEqual((caught.exception.line, caught.exception.key), (2, "dimensionless.mu"))
        moving = self.path("moving.csv", "count,f\n0,0\n5,0\n9,0\n")
        with self.assertRaisesRegex(passivity.IdentificationError, "moving.csv: row 2") as caught:
            passivity.identify(moving, SKETCH)
        self.assertFalse(caught.exception.not_covered)
        with self.assertRaisesRegex(passivity.IdentificationError, "the same log as"):
            passivity.identify([log, log], SKETCH)
        lag = {**ROTARY, "amplifier": {"time_constant": "1 ms"}}
        rotary = self.path("rotary.csv", "count,f [N m]\n0,0\n0,0\n")
        with self.assertRaises(passivity.IdentificationError) as caught:
            passivity.identify(rotary, lag)
        self.assertTrue(caught.exception.not_covered)
        for wrong in ({"inertia": "known"}, {"effort": 0}, {"count_error": -1}):
            with self.assertRaises(ValueError):
                passivity.identify(log, SKETCH, **wrong)
        with self.assertRaises(TypeError):
            passivity.identify([0, 1, 3], SKETCH)


class Results(unittest.TestCase):
    def test_fields_are_attributes(self):
        verdict = passivity.check(SCENE)
        self.assertIsInstance(verdict, passivity.Verdict)
        self.assertIsInstance(verdict, dict)
        self.assertEqual(verdict.spare.viscous["lo"], verdict["spare"]["viscous"].lo)
        with self.assertRaisesRegex(AttributeError, "nonsense"):
            verdict.nonsense
        self.assertEqual(json.loads(json.dumps(verdict)), verdict)
        self.assertIn("passive", verdict._repr_html_())

    def test_a_name_is_shown_as_text(self):
        record = passivity.Record.from_json('{"scene": "<script>"}')
        self.assertNotIn("<script>", record._repr_html_())

    def test_certificate(self):
        report = passivity.audit([0.0, 1.0, 0.0], {"dimensionless": {"beta": 0, "sigma": 0}})
        self.assertEqual(report.verdict, "fails")
        self.assertEqual(report.certificate.log.row, report.first_violation.row)
        self.assertIsNone(passivity.audit([0, 0], SCENE).certificate)

    def test_motion(self):
        told = []
        result = passivity.simulate(
            SCENE, speed=10, intervals=5000, progress=lambda *done: told.append(done)
        )
        self.assertIn("<svg", result._repr_html_())
        self.assertEqual(result, {**passivity.simulate(SCENE, speed="10", intervals=5000), "seconds": result["seconds"]})
        if numpy is not None:
            self.assertEqual(result.columns["xi0"].dtype, numpy.float64)

    def test_arrow(self):
        if pyarrow is None:
            with self.assertRaisesRegex(ImportError, "pip install pyarrow"):
                passivity.check(SCENE).to_arrow()
            return
        self.assertEqual(passivity.check(SCENE).to_arrow()["verdict"].to_pylist(), ["passive"])
        motion = passivity.simulate(SCENE, speed=3, intervals=20)
        self.assertEqual(motion.to_arrow()["xi0"].to_pylist(), list(motion.columns["xi0"]))
        self.assertEqual(passivity.audit([0, 1, 2], SCENE).to_arrow().num_rows, 2)


class Interrupts(unittest.TestCase):
    """An interrupt ends every call within 0.2 s, for it looks for one every 0.05 s; other threads run meanwhile."""

    LONG = {
        "simulate": "passivity.simulate(SCENE, speed=100, intervals=10**9, trace=False, progress=ready)",
        "sweep": "passivity.sweep(SCENE, beta='0:1:400', sigma='0:0.4:400', speed=[1, 5], intervals=10**9, progress=ready)",
        "identify": "passivity.identify(LOG, {'dimensionless': {'mu': 10}}, inertia='free', effort=10000, progress=ready)",
        "audit": "passivity.audit(array('d', [0.1, 0.7, 2.9, 1.3, -0.2]) * (8 * 10**6), SCENE, progress=ready)",
    }

    def test_interrupt(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        log = os.path.join(folder.name, "push.csv")
        with open(log, "w", encoding="utf-8") as file:
            file.write(pushed())
        for name, call in self.LONG.items():
            with self.subTest(call=name):
                # What other programs on a busy machine add is not the call's own: the least of a few counts.
                self.assertTrue(any(self.ends_after(call, log) < 0.2 for _ in range(5)))

    def ends_after(self, call, log):
        """How long a call goes on after an interrupt, in seconds."""
        program = f"""
            import passivity, sys, time
            from array import array
            SCENE = {{"dimensionless": {{"mu": 50, "beta": "1", "sigma": "1/5"}}}}
            LOG = {log!r}
            def ready(done, total):
                print("ready", flush=True)
            try:
                {call}
            except KeyboardInterrupt:
                print(time.time(), flush=True)
        """
        command = [sys.executable, "-c", textwrap.dedent(program)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as child:
            try:
                # What tells how far it is has begun.
                self.assertEqual(child.stdout.readline(), "ready\n")
                sent = time.time()
                child.send_signal(signal.SIGINT)
                caught = next(line for line in child.stdout if line != "ready\n")
                self.assertEqual(child.wait(10), 0)
            finally:
                child.kill()
        return float(caught) - sent

    def test_what_progress_raises_ends_the_call(self):
        def enough(done, total):
            if done:
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            passivity.simulate(SCENE, speed=100, intervals=10**9, trace=False, progress=enough)

    def test_other_threads_run(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.005)

        thread = threading.Thread(target=tick)
        thread.start()
        passivity.sweep(SCENE, beta="0:0.4:40", sigma="0:0.3:40", speed=5, intervals=20_000)
        done.set()
        thread.join()
        self.assertLess(max(b - a for a, b in zip(ticks, ticks[1:])), 0.5)


if __name__ == "__main__":
    unittest.main()
