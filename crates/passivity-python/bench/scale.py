"""Measures sweeps and audits on local clusters: what a point and a row cost, what a task costs, how well two
workers do beside two threads, in runs by turns; and that a large sweep and a large audit whose workers are killed are, to the
last byte, those of one run. Prints one JSON object a line.

    python bench/scale.py --points 10000000 --rows 100000000 --folder /tmp/scale

The package must be installed with its extras `distributed` and `arrow`.
"""

import argparse
import filecmp
import json
import os
import shutil
import statistics
import sys
import time

import numpy
import passivity
import pyarrow
import pyarrow.csv
from distributed import Client, LocalCluster
from passivity import distributed

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../tests"))
from cluster import Killer  # noqa: E402

SCENE = {"dimensionless": {"mu": "50", "beta": "1", "sigma": "1"}, "run": {"intervals": 3000}}
LAW = {"dimensionless": {"beta": "3/5", "sigma": "1/5"}}


def say(what, **figures):
    print(json.dumps({"what": what, **figures}), flush=True)


def grid(points):
    """A grid of Fig. 5 with about so many points."""
    side = max(2, round((points / 4) ** 0.5))
    return {"beta": f"0:1:{side}", "sigma": f"0:1.5:{side}", "speed": "1/2,1,2,5"}, 4 * side * side


def clock(work):
    begin = time.perf_counter()
    result = work()
    return time.perf_counter() - begin, result


class Enough(Exception):
    pass


def stop(done, total):
    if done * 2 > total:
        raise Enough


def nothing(_):
    return None


def overhead(client):
    """Seconds that a task costs which does nothing, when many are sent at once."""
    client.gather(client.map(nothing, range(8), pure=False))
    took, _ = clock(lambda: client.gather(client.map(nothing, range(64), pure=False)))
    return took / 64


def by_turns(pairs, plain, spread):
    """Both by turns, as others use the machine: how long each took in the middle, and how many times faster the
    second is than the first. The first run of the second, whose workers load the package, is told apart."""
    cold, result = clock(spread)
    times = []
    for _ in range(pairs):
        first, _ = clock(plain)
        second, result = clock(spread)
        times.append((first, second))
    plain, spread = zip(*times)
    return {
        "two_threads": statistics.median(plain),
        "cold": cold,
        "seconds": statistics.median(spread),
        "of_two_threads": statistics.median(a / b for a, b in times),
    }, result


def cluster(workers):
    return LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=":0"
    )


def log(path, rows):
    """A random walk of counts as CSV, with rests as a device has them."""
    random = numpy.random.default_rng(1)
    schema = pyarrow.schema([("count", pyarrow.int64())])
    last = 0
    with pyarrow.csv.CSVWriter(path, schema) as writer:
        for start in range(0, rows, 1 << 22):
            steps = random.integers(-2, 3, min(1 << 22, rows - start)) * random.integers(0, 2, 1)[0]
            counts = last + numpy.cumsum(steps)
            last = int(counts[-1])
            writer.write(pyarrow.table([pyarrow.array(counts)], schema))


def sweeps(folder, points, workers_tried, pairs):
    ranges, points = grid(points)
    whole, out = os.path.join(folder, "whole.parquet"), os.path.join(folder, "grid.parquet")
    seconds, _ = clock(lambda: passivity.sweep(SCENE, out=whole, threads=2, **ranges))
    say("sweep, two threads", points=points, seconds=seconds, us_per_point=1e6 * seconds * 2 / points)
    for workers in workers_tried:
        with cluster(workers) as local, Client(local) as client:
            each = overhead(client)
            figures, result = by_turns(
                pairs,
                lambda: passivity.sweep(SCENE, out=whole, threads=2, **ranges),
                lambda: distributed.sweep(client, SCENE, ranges, out=out),
            )
        say(
            "sweep, workers",
            workers=workers,
            shards=result.shards,
            ms_per_task=1e3 * each,
            **figures,
            same=filecmp.cmp(whole, out, shallow=False),
        )
    with cluster(2) as local, Client(local) as client:
        killer = Killer(client, 2)
        took, _ = clock(lambda: distributed.sweep(client, SCENE, ranges, out=out, progress=killer))
    say("sweep, killed", killed=len(killer.killed), seconds=took, same=filecmp.cmp(whole, out, shallow=False))
    with cluster(2) as local, Client(local) as client:
        try:
            distributed.sweep(client, SCENE, ranges, out=out, progress=stop)
        except Enough:
            pass
    with cluster(2) as local, Client(local) as client:
        took, result = clock(lambda: distributed.sweep(client, SCENE, ranges, out=out))
    say(
        "sweep, another scheduler",
        seconds=took,
        shards=result.shards,
        simulated_shards=result.simulated_shards,
        same=filecmp.cmp(whole, out, shallow=False),
    )


def audits(folder, rows, workers_tried, pairs):
    path = os.path.join(folder, "log.csv")
    log(path, rows)
    size = os.path.getsize(path)
    seconds, whole = clock(lambda: passivity.audit(path, LAW, threads=2))
    say("audit, two threads", rows=rows, bytes=size, seconds=seconds, ns_per_row=1e9 * seconds * 2 / rows)
    for workers in workers_tried:
        with cluster(workers) as local, Client(local) as client:
            figures, report = by_turns(
                pairs,
                lambda: passivity.audit(path, LAW, threads=2),
                lambda: distributed.audit(client, path, LAW),
            )
        say(
            "audit, workers",
            workers=workers,
            **figures,
            same=json.dumps(report) == json.dumps(whole),
        )
    with cluster(2) as local, Client(local) as client:
        killer = Killer(client, 2)
        took, report = clock(lambda: distributed.audit(client, path, LAW, shards=64, progress=killer))
    say("audit, killed", killed=len(killer.killed), seconds=took, same=json.dumps(report) == json.dumps(whole))
    logs = [f"{path}.{i}.csv" for i in range(8)]
    for name in logs:
        os.link(path, name)
    seconds, _ = clock(lambda: [passivity.audit(name, LAW, threads=2) for name in logs])
    for workers in workers_tried:
        with cluster(workers) as local, Client(local) as client:
            took, reports = clock(lambda: distributed.audit(client, logs, LAW))
        say(
            "audit, eight logs",
            workers=workers,
            two_threads=seconds,
            seconds=took,
            of_two_threads=seconds / took,
            same=all(json.dumps(report) == json.dumps(whole) for report in reports),
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=200_000)
    parser.add_argument("--rows", type=int, default=5_000_000)
    parser.add_argument("--workers", type=int, nargs="*", default=[1, 2, 4])
    parser.add_argument("--pairs", type=int, default=5, help="runs of each kind, by turns")
    parser.add_argument("--folder", default="scale")
    asked = parser.parse_args()
    os.makedirs(asked.folder)
    try:
        if asked.points:
            sweeps(asked.folder, asked.points, asked.workers, asked.pairs)
        if asked.rows:
            audits(asked.folder, asked.rows, asked.workers, asked.pairs)
    finally:
        shutil.rmtree(asked.folder)


if __name__ == "__main__":
    main()
