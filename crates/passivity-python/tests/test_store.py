"""Sweeps and audits whose parts are in a store that is not local: an S3 server on this machine, asked over HTTP
by workers that are processes of their own."""

import json
import os
import unittest

import fsspec
import passivity
import pyarrow.dataset
from cluster import GRID, LAW, SCENE, Killer, OnTwoWorkers, read, write_log
from moto.server import ThreadedMotoServer
from passivity import distributed


class Stop(Exception):
    pass


def stop(done, total):
    if done * 3 > total:
        raise Stop


class OnS3(OnTwoWorkers):
    @classmethod
    def setUpClass(cls):
        cls.server = ThreadedMotoServer(ip_address="127.0.0.1", port=0)
        cls.server.start()
        host, port = cls.server.get_host_and_port()
        cls.options = {
            "key": "any",
            "secret": "any",
            "client_kwargs": {"endpoint_url": f"http://{host}:{port}"},
        }
        cls.store = fsspec.filesystem("s3", **cls.options)
        cls.store.mkdir("lab")
        super().setUpClass()

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        cls.server.stop()

    def names(self, place):
        self.store.invalidate_cache()
        return sorted(name.rsplit("/", 1)[-1] for name in self.store.ls(place, detail=False))

    def test_a_sweep_is_that_of_one_run(self):
        whole = os.path.join(self.folder, "whole.parquet")
        passivity.sweep(SCENE, out=whole, **GRID)
        asked = {"out": "s3://lab/grid.parquet", "storage_options": self.options, "shards": 12}
        with self.assertRaises(Stop):
            distributed.sweep(self.client, SCENE, GRID, progress=stop, **asked)
        kept = [name for name in self.names("lab/grid.parquet.parts") if name.startswith("part-")]
        self.assertTrue(kept)
        self.assertFalse(self.store.exists("lab/grid.parquet"))
        killer = Killer(self.client, 1)
        result = distributed.sweep(self.client, SCENE, GRID, progress=killer, **asked)
        self.assertEqual(len(killer.killed), 1)
        self.assertLessEqual(result.simulated_shards, 12 - len(kept))
        self.store.invalidate_cache()
        self.assertEqual(self.store.cat_file("lab/grid.parquet"), read(whole))
        self.assertFalse(self.store.exists("lab/grid.parquet.parts"))

    def test_parts_are_a_dataset(self):
        result = distributed.sweep(
            self.client,
            SCENE,
            GRID,
            out=os.path.join(self.folder, "grid.parquet"),
            parts="s3://lab/parts",
            storage_options=self.options,
            merge=False,
        )
        names = self.names("lab/parts")
        self.assertEqual(len(names), result.shards + 1)
        parts = [f"lab/parts/{name}" for name in names if name.endswith(".parquet")]
        rows = pyarrow.dataset.dataset(parts, filesystem=self.store, format="parquet").count_rows()
        self.assertEqual(rows, result.points)

    def test_an_audit_goes_on(self):
        log = os.path.join(self.folder, "log.csv")
        write_log(log, 40_000)
        asked = {"parts": "s3://lab/pieces", "storage_options": self.options, "shards": 9}
        with self.assertRaises(Stop):
            distributed.audit(self.client, log, LAW, progress=stop, **asked)
        self.assertGreater(len(self.names("lab/pieces")), 1)
        report = distributed.audit(self.client, log, LAW, **asked)
        self.assertEqual(json.dumps(report), json.dumps(passivity.audit(log, LAW)))
        self.assertEqual(len(self.names("lab/pieces")), 10)


if __name__ == "__main__":
    unittest.main()
