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


class Places(InFolder):
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
