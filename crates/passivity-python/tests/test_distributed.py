"""Sweeps and audits on a cluster of separate processes, some of which are killed."""

import json
import os
import threading
import time
import unittest

import passivity
from cluster import GRID, LAW, SCENE, Killer, OnTwoWorkers, read, write_log
from distributed import Client, LocalCluster
from passivity import distributed


class OnACluster(OnTwoWorkers):
    def path(self, name):
        return os.path.join(self.folder, name)

    def test_a_sweep_whose_workers_are_killed_is_that_of_one_run(self):
        whole = passivity.sweep(SCENE, out=self.path("whole.parquet"), **GRID)
        killer = Killer(self.client, 2)
        result = distributed.sweep(
            self.client, SCENE, GRID, out=self.path("grid.parquet"), shards=24, progress=killer
        )
        self.assertEqual(len(killer.killed), 2)
        self.assertEqual(read(self.path("whole.parquet")), read(self.path("grid.parquet")))
        self.assertEqual((result.points, result.exact), (whole.points, whole.exact))
        self.assertFalse(os.path.exists(self.path("grid.parquet.parts")))

    def test_an_audit_whose_workers_are_killed_is_that_of_one_run(self):
        log = self.path("log.csv")
        write_log(log, 200_000)
        killer = Killer(self.client, 2)
        report = distributed.audit(self.client, log, LAW, shards=16, progress=killer)
        self.assertEqual(len(killer.killed), 2)
        whole = passivity.audit(log, LAW)
        self.assertEqual(json.dumps(report), json.dumps(whole))
        self.assertEqual(report.certificate, whole.certificate)

    def test_sizes_are_measured(self):
        log = self.path("log.csv")
        write_log(log, 50_000)
        both = distributed.audit(self.client, [log, log], LAW, seconds=0.05)
        self.assertEqual(both, [passivity.audit(log, LAW)] * 2)
        grid = {**GRID, "intervals": 100_000}
        result = distributed.sweep(self.client, SCENE, grid, out=self.path("g.csv"), seconds=0.05)
        self.assertGreater(result.shards, 1)
        passivity.sweep(SCENE, out=self.path("whole.csv"), **grid)
        self.assertEqual(read(self.path("g.csv")), read(self.path("whole.csv")))

    def test_another_scheduler_goes_on_with_what_is_there(self):
        class Stop(Exception):
            pass

        def stop(done, total):
            if done * 3 > total:
                raise Stop

        out, parts = self.path("grid.parquet"), self.path("parts")
        log, pieces = self.path("log.csv"), self.path("pieces")
        write_log(log, 20_000)
        cluster = LocalCluster(n_workers=1, threads_per_worker=1, processes=True, dashboard_address=":0")
        with Client(cluster) as client:
            with self.assertRaises(Stop):
                distributed.sweep(
                    client, SCENE, GRID, out=out, parts=parts, shards=12, progress=stop
                )
            with self.assertRaises(Stop):
                distributed.audit(client, log, LAW, parts=pieces, shards=12, progress=stop)
        cluster.close()
        self.assertFalse(os.path.exists(out))
        kept = [name for name in os.listdir(parts) if name.startswith("part-")]
        self.assertTrue(kept)
        # Other work is not mixed with it.
        with self.assertRaisesRegex(ValueError, "other work"):
            distributed.sweep(self.client, SCENE, {**GRID, "speed": "2"}, out=out, parts=parts)
        result = distributed.sweep(self.client, SCENE, GRID, out=out, parts=parts, keep=True)
        self.assertLessEqual(result.simulated_shards, 12 - len(kept))
        passivity.sweep(SCENE, out=self.path("whole.parquet"), **GRID)
        self.assertEqual(read(out), read(self.path("whole.parquet")))
        report = distributed.audit(self.client, log, LAW, parts=pieces)
        self.assertEqual(report, passivity.audit(log, LAW))

    def test_any_store(self):
        out = self.path("grid.parquet")
        result = distributed.sweep(
            self.client, SCENE, GRID, out=out, parts=f"file://{self.path('store')}", shards=3, keep=True
        )
        self.assertEqual(result.shards, 3)
        self.assertEqual(len(os.listdir(self.path("store"))), 4)
        import pyarrow.dataset

        parts = pyarrow.dataset.dataset(self.path("store"), format="parquet", exclude_invalid_files=True)
        self.assertEqual(parts.count_rows(), result.points)

    def test_mistakes_come_back(self):
        with self.assertRaises(passivity.SceneError):
            distributed.sweep(self.client, {"nonsense": {}}, GRID, out=self.path("x.csv"))
        with self.assertRaises(passivity.SimulationError):
            distributed.sweep(self.client, SCENE, {"beta": "0:1"}, out=self.path("x.csv"))
        bad = self.path("bad.csv")
        with open(bad, "w", encoding="utf-8") as file:
            file.write("nonsense\n1\n")
        with self.assertRaises(passivity.TraceError) as caught:
            distributed.audit(self.client, bad, LAW)
        self.assertEqual(caught.exception.kind, "header")

    def test_a_border_takes_few_points(self):
        grid = {"beta": "0:1:161", "sigma": "0:0.8:161", "speed": "5", "intervals": 500}
        border = distributed.border(self.client, SCENE, grid)
        self.assertLess(border.simulated * 5, border.points)
        whole = passivity.sweep(SCENE, **grid).columns["exact"]
        for index, outcome in border.outcomes.items():
            self.assertEqual(whole[index], outcome)

        def differs(i, j):
            return len({whole[(i + a) * 161 + j + b] for a in (0, 1) for b in (0, 1)}) > 1

        every = {(i, j, 0) for i in range(160) for j in range(160) if differs(i, j)}
        self.assertEqual(set(border.cells), every)
        quick = distributed.border(None, SCENE, grid, thorough=False)
        self.assertLess(quick.simulated, border.simulated)
        self.assertLessEqual(set(quick.cells), every)
        self.assertGreater(len(quick.cells), 0.9 * len(every))


if __name__ == "__main__":
    unittest.main()
