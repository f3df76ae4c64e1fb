"""What tests and measurements on a cluster share: workers that are processes, and one who kills them."""

import os
import signal
import tempfile
import unittest

from distributed import Client, LocalCluster

SCENE = {"dimensionless": {"mu": "50", "beta": "1", "sigma": "1"}, "run": {"intervals": 2000}}
GRID = {"beta": "0:1:60", "sigma": "0:1.5:60", "speed": "1,5"}
LAW = {"dimensionless": {"beta": "3/5", "sigma": "1/5"}}


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write_log(path, rows):
    position, state = 0, 12345
    with open(path, "w", encoding="utf-8") as file:
        file.write("tau,count\n")
        for i in range(rows):
            state = (1103515245 * state + 12345) % 2**31
            position += state % 5 - 2
            file.write(f"{i}{'.25' if state % 97 == 0 else ''},{position}\n")


class Killer:
    """Kills a worker with −9 each time that so much is done."""

    def __init__(self, client, times):
        self.client, self.left, self.killed = client, times, []

    def __call__(self, done, total):
        if self.left and done * (self.left + 1) >= total:
            self.left -= 1
            pids = []
            while not pids:
                # One that was killed may still be asked.
                found = self.client.run(os.getpid, on_error="ignore").values()
                pids = [pid for pid in found if pid not in self.killed]
            os.kill(pids[0], signal.SIGKILL)
            self.killed.append(pids[0])


class OnTwoWorkers(unittest.TestCase):
    """Tests with a cluster of two processes and a folder of their own."""

    @classmethod
    def setUpClass(cls):
        cls.cluster = LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
        )
        cls.client = Client(cls.cluster)

    @classmethod
    def tearDownClass(cls):
        cls.client.close()
        cls.cluster.close()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
