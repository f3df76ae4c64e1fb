"""What callers give: wrong types are named with what is expected, and names and paths may be any."""

import datetime
import os
import pathlib
import pickle
import sys
import tempfile
import threading
import time
import unittest
import warnings
from array import array

import passivity
from passivity import results

SCENE = {"dimensionless": {"mu": 50, "beta": 1, "sigma": 1}}
SKETCH = {"dimensionless": {"mu": 10}}
ROTARY = {
    "device": {"inertia": "6.28e-6 kg m^2", "coulomb": "2e-3 N m"},
    "sampling": {"period": "1 ms"},
    "encoder": {"counts_per_revolution": 8192},
    "wall": {"stiffness": "2 N m/rad"},
}
# From rest under 4 KΔ, of a device with μ = 10 and no friction: n²/5 ticks.
PUSH = "count,f\n" + "".join(f"{n * n // 5},4\n" for n in range(30))


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        return path


class WrongTypes(InFolder):
    def test_each_argument_is_named(self):
        log = self.path("push.csv", PUSH)
        calls = {
            passivity.identify: (
                (log, SKETCH),
                {"date": 3, "device": 3, "count_error": "1", "force_error": True, "columns": 3, "delimiter": 3,
                 "decimal_comma": "no", "out": b"a", "progress": 3},
            ),
            passivity.audit: (([0, 1], SCENE), {"unit": 3, "t_unit": 3, "f_unit": b"N", "law": 1, "out": 3}),
            passivity.simulate: ((SCENE,), {"speed": [1], "method": 3, "trace": 1, "progress": 3}),
            passivity.sweep: ((SCENE,), {"beta": object(), "sigma": b"1", "vary": 3, "resume": "no", "out": 3}),
        }  # fmt: skip
        for call, (given, wrong) in calls.items():
            for name, value in wrong.items():
                more = {"beta": 1, "sigma": 1} if call is passivity.sweep and name in ("resume", "out") else {}
                said = f"^{name}: expected .*, found {type(value).__name__}$"
                with self.subTest(name=name), self.assertRaisesRegex(TypeError, said):
                    call(*given, **{name: value}, **more)

    def test_a_truth_value_is_no_number(self):
        calls = {
            "speed": lambda: passivity.simulate(SCENE, speed=True),
            "beta": lambda: passivity.sweep(SCENE, beta=[0, True], sigma=1),
            "sigma": lambda: passivity.sweep(SCENE, beta=0, sigma=True),
            "vary: mass": lambda: passivity.sweep(SCENE, vary={"mass": [True], "beta": 1}),
        }
        for name, call in calls.items():
            with self.subTest(name=name), self.assertRaisesRegex(ValueError, f"^{name}: expected .* found True$"):
                call()

    def test_half_of_a_character_is_no_text(self):
        for call in (
            lambda: passivity.identify("log.csv", SKETCH, device="\udcff"),
            lambda: passivity.audit([0, 1], SCENE, unit="\udcff"),
            lambda: passivity.check("a\n\udcff"),
        ):
            with self.assertRaisesRegex(ValueError, "half of a character"):
                call()


class Columns(InFolder):
    def intervals(self, header, columns):
        log = self.path("log.csv", f"{header}\n0\n1\n")
        return passivity.audit(log, ROTARY, columns=columns).intervals

    def test_a_name_in_a_mapping_is_one_name(self):
        forms = [
            ('"a,b"', {"count": "a,b"}),
            ('"pos, f=torque"', {"count": "pos, f=torque"}),
            ('"a ""b"""', {"count": 'a "b"'}),
            ("a=b", {"count": "a=b"}),
            ("pos (a", {"count": "pos (a"}),
            ('""', {"count": ""}),
            ('"a,b"', {"x": "a,b [deg]"}),
            ('"a,b [deg]"', {"x": "a,b [deg]"}),
            ('"a,b [deg]"', {"x": "-a,b"}),
            ("pos", {"x": "-pos [deg]"}),
            ("pos", ["x=pos [deg]"]),
        ]
        for header, columns in forms:
            with self.subTest(columns=columns):
                self.assertEqual(self.intervals(header, columns), 1)
        # No other role is read from a name, nor from a role.
        log = self.path("log.csv", "pos,torque\n0,0\n1,0\n")
        with self.assertRaisesRegex(passivity.TraceError, "there is no column `pos, f=torque`"):
            passivity.audit(log, ROTARY, columns={"count": "pos, f=torque"})
        with self.assertRaisesRegex(ValueError, "^columns: expected what a column says"):
            passivity.audit(log, ROTARY, columns={"count=pos, f": "torque"})

    def test_a_time_in_two_columns_and_lists(self):
        log = self.path("log.csv", '"s,a",n,p,f [N m]\n0,0,0,0\n0,1000000,1,0\n')
        times = {"t": "s,a [s] + n [ns]", "count": "p"}
        self.assertEqual(passivity.audit(log, ROTARY, columns=times).timing.uneven, 0)
        parts = ['t="s,a" [s] + n [ns]', "count=p"]
        self.assertEqual(passivity.audit(log, ROTARY, columns=parts).timing.uneven, 0)


class Places(InFolder):
    @unittest.skipUnless(sys.platform == "linux", "elsewhere names are text")
    def test_a_folder_whose_name_is_not_utf_8(self):
        folder = pathlib.Path(self.folder, os.fsdecode(b"d\xff"))
        folder.mkdir()
        scene, log, out = folder / "s.toml", folder / "l.csv", folder / "g.csv"
        scene.write_text("[dimensionless]\nmu = 50\nbeta = 1\nsigma = 1\n")
        log.write_text("count\n0\n1\n")
        self.assertEqual(passivity.check(scene).scene, "s")
        self.assertEqual(passivity.audit(log, scene).verdict, "holds")
        swept = passivity.sweep(scene, beta="0:1:2", sigma=1, speed=2, intervals=50, out=out)
        self.assertEqual(len(swept.columns["beta"]), 2)
        log.write_text(PUSH)
        with open(folder / "d.toml", "w", encoding="utf-8") as file:
            file.write("[dimensionless]\nmu = 10\n")
        self.assertEqual(passivity.identify(log, folder / "d.toml", effort=1).samples, 30)

    def test_a_sketch_that_cannot_be_read_is_refused_as_every_scene_is(self):
        log = self.path("push.csv", PUSH)
        latin = self.path("latin.toml", b"[sampling]\nperiod = '1 \xb5s'\n")
        large = self.path("large.toml", "#" * 300_000)
        for sketch in (self.folder, latin, large, self.folder + "/absent.toml", self.folder + "/a\0b"):
            said = []
            for call in (passivity.check, lambda sketch: passivity.identify(log, sketch)):
                with self.assertRaises(passivity.SceneError) as caught:
                    call(sketch)
                error = caught.exception
                said.append((str(error), error.line, error.column, error.kind, error.diagnostics))
            self.assertEqual(said[0], said[1])

    def test_an_answer_without_a_scene(self):
        log, out = self.path("push.csv", PUSH), os.path.join(self.folder, "device.toml")
        still = self.path("still.csv", "count,f\n" + "0,0\n" * 5 + "0,9\n" * 5 + "99,0\n" * 5)
        with self.assertWarnsRegex(UserWarning, "device.toml is not written: no parameters fit") as warned:
            found = passivity.identify(still, SKETCH, effort=1, out=out)
        self.assertEqual((found.toml, found.refuted_by.row), (None, 11))
        self.assertEqual((warned.filename, os.path.exists(out)), (__file__, False))
        with self.assertWarnsRegex(UserWarning, "how small the inertia is.*or try more `effort`"):
            found = passivity.identify(log, SKETCH, inertia="free", effort=1, out=out)
        self.assertEqual((found.toml, found.parameters.inertia.lo), (None, 0))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = passivity.identify(still, SKETCH, effort=1)
            passivity.identify(log, SKETCH, effort=5, out=out, date=datetime.date(2024, 5, 1))
        with open(out, encoding="utf-8") as file:
            self.assertIn("# Recorded: 2024-05-01\n", file.read())

    def test_what_is_said_of_a_recording(self):
        log = self.path("push.csv", PUSH)
        for day in ("2024-05-01", datetime.date(2024, 5, 1), datetime.datetime(2024, 5, 1, 12, 30)):
            found = passivity.identify(log, SKETCH, effort=5, date=day)
            self.assertIn("# Recorded: 2024-05-01\n", found.toml)
        for name, value in (("date", "today"), ("date", ""), ("device", " - "), ("device", "TODO")):
            with self.assertRaisesRegex(ValueError, f"^{name}: expected .*, found `{value}`$"):
                passivity.identify("none.csv", SKETCH, **{name: value})
        with self.assertRaisesRegex(ValueError, "^effort: expected a whole number from 1 to 100000, found 0$"):
            passivity.identify(log, SKETCH, effort=0)

    def test_a_folder_that_is_not_there_is_refused_before_the_search(self):
        log, told = self.path("push.csv", PUSH), []
        for out in (os.path.join(self.folder, "nowhere", "device.toml"), os.path.join(log, "device.toml")):
            with self.assertRaises((OSError, ValueError)):
                passivity.identify(log, SKETCH, out=out, progress=lambda *done: told.append(done))
        self.assertEqual((told, os.listdir(self.folder)), ([], ["push.csv"]))


class Kept(InFolder):
    def test_the_points_of_another_sweep_are_refused(self):
        for name in ("grid.csv", "grid.parquet"):
            out = os.path.join(self.folder, name)

            def swept(beta):
                return passivity.sweep(SCENE, beta=beta, sigma="0:1:3", speed=2, intervals=50, out=out)

            unseen, other = swept("0:1:3"), swept("0:1:2")
            with self.assertRaisesRegex(ValueError, f"{name}: this is no longer the file"):
                unseen.columns
            self.assertIn("no longer the file", unseen._repr_html_())
            if name == "grid.csv":
                self.assertEqual(len(other.columns["beta"]), 6)
                # The same bytes are the same points, and what was seen is kept.
                swept("0:1:3")
                self.assertEqual((len(unseen.columns["beta"]), len(other.columns["beta"])), (9, 6))

    def test_results_go_through_every_protocol(self):
        motion = passivity.simulate(SCENE, speed=3, intervals=20)
        report = passivity.audit([0.0, 1.0, 0.0], {"dimensionless": {"beta": 0, "sigma": 0}})
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            for result in (motion, report, passivity.check(SCENE)):
                again = pickle.loads(pickle.dumps(result, protocol))
                self.assertEqual((type(again), again), (type(result), result))
            self.assertIsInstance(again.spare, results.Record)
            columns = pickle.loads(pickle.dumps(motion, protocol)).columns
            self.assertEqual(list(columns["xi0"]), list(motion.columns["xi0"]))
            self.assertEqual(pickle.loads(pickle.dumps(report, protocol)).certificate, report.certificate)


class Copies(unittest.TestCase):
    def test_other_threads_run_while_columns_are_copied(self):
        def enough(done, total):
            raise RuntimeError("copied")

        counts = [0, 1, 3, 2] * 3_000_000
        columns = {"of 64 bits": array("q", counts), "of 32 bits": array("i", counts)}
        columns["with gaps"] = memoryview(columns["of 64 bits"] * 2)[::2]
        for name, values in columns.items():
            longest = 1.0
            # What other programs on a busy machine add is not the call's own: the least of a few counts.
            for _ in range(5):
                ticks, done = [time.perf_counter()], threading.Event()

                def tick():
                    while not done.is_set():
                        time.sleep(0.002)
                        ticks.append(time.perf_counter())

                thread = threading.Thread(target=tick)
                thread.start()
                with self.assertRaisesRegex(RuntimeError, "copied"):
                    passivity.audit(values, SCENE, progress=enough)
                done.set()
                thread.join()
                longest = min(longest, max(b - a for a, b in zip(ticks, ticks[1:])))
            self.assertLess(longest, 0.1, name)


if __name__ == "__main__":
    unittest.main()
