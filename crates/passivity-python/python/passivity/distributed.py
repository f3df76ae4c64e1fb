"""Sweeps and audits on the workers of a ``dask.distributed.Client``.

The work is cut into shards of the native code, each of a few seconds by measurement; a finished shard is a
file with a manifest, put in its place at once. Whatever is killed, on whichever machine, is done again; a
call that was interrupted, or whose scheduler went away, goes on with the shards that are there. The result
is the same, to the last byte, as that of one run on one machine.

Workers must see the same files: a scene that is a path, and ``parts`` where that is a local folder.
"""

from __future__ import annotations

import hashlib as _hashlib
import json as _json
import os as _os
import statistics as _statistics
import tempfile as _tempfile
import time as _time

from . import _passivity, _ranges, _report, _scene, _swept, _reading, __version__
from ._parts import Parts as _Parts
from .adaptive import Border as _Border
from .adaptive import refine as _refine

__all__ = ["audit", "border", "sweep"]

# How long a task should take at the least, by how long a task takes that does nothing.
_OVERHEADS = 25

# How many seconds a measurement takes at the least.
_PROBE = 0.1


def _nothing(_):
    return None


def _overhead(client):
    """Seconds that a task costs which does nothing, when many are sent at once."""
    client.gather(client.map(_nothing, range(8), pure=False))
    count = 64
    begin = _time.perf_counter()
    client.gather(client.map(_nothing, range(count), pure=False))
    return (_time.perf_counter() - begin) / count


def _workers(client):
    """How many threads the workers have."""
    return max(1, sum(client.nthreads().values()))


def _cut(total_seconds, seconds, overhead, threads, most):
    """Into how many shards work of so many seconds is cut."""
    each = max(seconds, _OVERHEADS * overhead)
    even = max(1, round(total_seconds / each))
    if even > threads:
        # Every thread has as many to do.
        even = -(-even // threads) * threads
    elif total_seconds > 2 * _OVERHEADS * overhead * threads:
        even = threads
    return max(1, min(even, most))


def _plan(parts, wanted, count):
    """How many shards there are: as was decided when the work began, if it did."""
    if "plan.json" in parts.names():
        found = _json.loads(parts.read("plan.json"))
        shards = found.pop("shards")
        if found != wanted:
            raise ValueError(
                f"{parts.place} has shards of other work: give another folder, or remove it"
            )
        return shards
    shards = count()
    parts.write("plan.json", _json.dumps({**wanted, "shards": shards}).encode())
    return shards


def _identity(source):
    """What tells one scene from another."""
    kind, text = source
    data = text.encode()
    if kind == "path":
        with open(text, "rb") as file:
            data = file.read()
    return _hashlib.sha256(data).hexdigest()


def _absolute(source):
    kind, text = source
    return (kind, _os.path.abspath(text) if kind == "path" else text)


def _run(client, jobs, call, done, retries, sizes, progress):
    """Runs ``call`` on each job, again where a worker was lost, and gives ``done`` the results as they come."""
    from distributed import as_completed
    from distributed.scheduler import KilledWorker

    left = {}
    finished, total = sum(sizes.values()) - sum(sizes[job] for job in jobs), sum(sizes.values())
    if progress is not None:
        progress(finished, total)
    futures = {client.submit(call, job, pure=False, retries=retries): job for job in jobs}
    coming = as_completed(futures)
    try:
        for future in coming:
            job = futures.pop(future)
            if future.status == "error" and isinstance(future.exception(), KilledWorker):
                left[job] = left.get(job, 0) + 1
                if left[job] <= retries:
                    again = client.submit(call, job, pure=False, retries=retries)
                    futures[again] = job
                    coming.add(again)
                    continue
            done(job, future.result())
            finished += sizes[job]
            if progress is not None:
                progress(finished, total)
    except BaseException:
        client.cancel(list(futures))
        raise


class _SweepShard:
    """One shard of a sweep, simulated where it is called."""

    def __init__(self, scene, ranges, count, parts, threads):
        self.scene, self.ranges, self.count = scene, ranges, count
        self.parts, self.threads = parts, threads

    def name(self, shard):
        return f"part-{shard:06}-of-{self.count:06}.parquet"

    def __call__(self, shard):
        begin = _time.perf_counter()
        with _tempfile.TemporaryDirectory() as folder:
            path = _os.path.join(folder, "part.parquet")
            _passivity.sweep(self.scene, self.ranges, path, (shard, self.count), False, self.threads)
            self.parts.put(path, self.name(shard))
        return _time.perf_counter() - begin


def _probe_points(scene, ranges, indices, threads):
    begin = _time.perf_counter()
    _passivity.sweep_points(scene, ranges, indices, threads)
    return _time.perf_counter() - begin


def _cost_of_points(client, scene, ranges, points, threads):
    """Seconds that a point takes, from points spread over the grid."""
    for most in (64, 512, 4096, 32768):
        count = min(points, most)
        indices = [points * i // count for i in range(count)]
        seconds = client.submit(_probe_points, scene, ranges, indices, threads, pure=False).result()
        if seconds > _PROBE or count == points:
            break
    return seconds / count


def sweep(
    client,
    scene,
    grid,
    *,
    out,
    parts=None,
    storage_options=None,
    seconds=5.0,
    shards=None,
    threads=1,
    retries=20,
    merge=True,
    keep=False,
    progress=None,
):
    """The outcome of every point of a grid, by the workers of ``client``: as :func:`passivity.sweep`.

    ``grid`` has the ranges: ``{"beta": "0:1:401", "sigma": "0:1.5:601", "speed": "1,5"}``, or ``{"vary":
    {…}}``, and perhaps ``intervals``. The shards go to ``parts``, a folder or an address of fsspec with its
    ``storage_options`` (by default ``out`` with ``.parts`` appended), which is a Parquet dataset; a call with
    the same arguments goes on with those that are there. With ``merge`` they become the file ``out``, the same
    as that of one run, and the folder is removed unless ``keep`` is set. A shard takes about ``seconds``,
    unless ``shards`` says how many there are; ``threads`` is how many threads a task has on its worker.
    ``progress`` is called with how many points are done, of how many.

    Returns a :class:`passivity.SweepResult`; ``result.shards`` says how many there were.
    """
    source, ranges = _absolute(_scene(scene)), _ranges(**grid)
    points, axes, _ = _passivity.grid(source, ranges)
    path = _os.fspath(out)
    folder = _Parts(parts if parts is not None else path + ".parts", storage_options)
    wanted = {
        "format": "passivity-sweep-plan-1",
        "version": __version__,
        "scene": _identity(source),
        "ranges": ranges,
    }

    def count():
        if shards is not None:
            return min(shards, points)
        cost = _cost_of_points(client, source, ranges, points, threads)
        workers = max(1, _workers(client) // threads)
        return _cut(cost * points, seconds, _overhead(client), workers, points)

    task = _SweepShard(source, ranges, _plan(folder, wanted, count), folder, threads)
    there = folder.names()
    jobs = [shard for shard in range(1, task.count + 1) if task.name(shard) not in there]
    even, more = divmod(points, task.count)
    sizes = {shard: even + (shard <= more) for shard in range(1, task.count + 1)}
    _run(client, jobs, task, lambda job, took: None, retries, sizes, progress)
    names = [task.name(shard) for shard in range(1, task.count + 1)]
    if not merge:
        result = _swept("{}", axes, folder.place)
        result.update(points=points, shards=task.count, simulated_shards=len(jobs))
        return result
    with _tempfile.TemporaryDirectory() as local:
        report = _passivity.sweep_merge(source, ranges, folder.fetch(names, local), path)
    if not keep:
        folder.remove()
    result = _swept(report, axes, path)
    result.update(shards=task.count, simulated_shards=len(jobs))
    return result


class _AuditPiece:
    """The account of one piece of a log, made where it is called."""

    def __init__(self, scene, reading, parts):
        self.scene, self.reading, self.parts = scene, reading, parts

    def __call__(self, job):
        log, piece, count = job
        part, _, _ = _passivity.audit_piece(log, self.scene, self.reading, f"{piece}/{count}")
        if self.parts is not None:
            self.parts.write(_piece_name(job), part.encode())
        return part


def _piece_name(job):
    log, piece, count = job
    of = _hashlib.sha256(log.encode()).hexdigest()[:16]
    return f"{of}-{piece:06}-of-{count:06}.json"


def _probe_log(scene, reading, log, pieces):
    """Seconds that the pieces of a log take, and a piece that has nothing in it."""
    times = []
    for piece in pieces:
        begin = _time.perf_counter()
        _passivity.audit_piece(log, scene, reading, piece)
        times.append(_time.perf_counter() - begin)
    return times


def _cost_of_bytes(client, scene, reading, log):
    """Seconds that a byte of a log takes, from pieces in three places of it."""
    size = max(1, _os.path.getsize(log))
    for bytes_ in (1 << 18, 1 << 21, 1 << 24):
        count = max(1, size // bytes_)
        pieces = [f"{max(1, count * i // 4)}/{count}" for i in (1, 2, 3)]
        times = client.submit(_probe_log, scene, reading, log, pieces, pure=False).result()
        if _statistics.median(times) > _PROBE or count == 1:
            break
    return _statistics.median(times) * count / size


def audit(
    client,
    files,
    scene,
    *,
    columns=None,
    delimiter=None,
    decimal_comma=False,
    law=False,
    parts=None,
    storage_options=None,
    seconds=5.0,
    shards=None,
    threads=1,
    retries=20,
    progress=None,
):
    """The exact account of one long log, or of many, by the workers of ``client``.

    ``files`` is the path of a CSV or Parquet file, or a list of paths, each a log of its own; the workers must
    see them. Each log is cut into pieces of about ``seconds``, whose exact accounts are merged: the report is
    the one that :func:`passivity.audit` gives. With ``parts``, a folder or an address of fsspec, a call with
    the same arguments goes on with the accounts that are there; ``shards`` says into how many pieces each log
    is cut. ``progress`` is called with how many bytes are done, of how many.

    Returns a :class:`passivity.AuditReport`, or a list of them where ``files`` is a list.
    """
    one = isinstance(files, (str, _os.PathLike))
    logs = [_os.path.abspath(_os.fspath(log)) for log in ([files] if one else files)]
    source = _absolute(_scene(scene))
    reading = _reading(columns, delimiter, decimal_comma, law, threads)
    folder = None if parts is None else _Parts(parts, storage_options)

    def count():
        if shards is not None:
            return [shards] * len(logs)
        overhead, workers = _overhead(client), max(1, _workers(client) // threads)
        sizes = [_os.path.getsize(log) for log in logs]
        # The logs of one call are of one kind.
        largest = max(zip(sizes, logs, strict=True), default=(0, None))[1]
        cost = largest and _cost_of_bytes(client, source, reading, largest)
        # Many logs are enough to do for all workers as they are.
        workers = max(1, workers // max(1, len(logs)))
        return [_cut(cost * size, seconds, overhead, workers, 1_000_000) for size in sizes]

    if folder is None:
        counts, there = count(), set()
    else:
        wanted = {
            "format": "passivity-audit-plan-1",
            "version": __version__,
            "scene": _identity(source),
            "reading": {**reading, "threads": 0},
            "logs": [[log, _os.path.getsize(log), _os.stat(log).st_mtime_ns] for log in logs],
        }
        counts, there = _plan(folder, wanted, count), folder.names()
    jobs = [(log, piece, n) for log, n in zip(logs, counts, strict=True) for piece in range(1, n + 1)]
    found = {job: folder.read(_piece_name(job)).decode() for job in jobs if _piece_name(job) in there}
    sizes = {job: _os.path.getsize(job[0]) // job[2] for job in jobs}
    missing = [job for job in jobs if job not in found]
    _run(client, missing, _AuditPiece(source, reading, folder), found.__setitem__, retries, sizes, progress)
    reports = []
    for log, n in zip(logs, counts, strict=True):
        pieces = [(f"piece {piece} of {log}", found[log, piece, n]) for piece in range(1, n + 1)]
        reports.append(_report(_passivity.audit_merge(pieces, source)))
    return reports[0] if one else reports


def _outcomes(scene, ranges, indices, threads):
    return [exact for _, exact, _, _, _ in _passivity.sweep_points(scene, ranges, indices, threads)]


def border(
    client,
    scene,
    grid,
    *,
    coarse=16,
    thorough=True,
    chunk=2000,
    threads=1,
    retries=20,
    progress=None,
):
    """The cells of a grid between points of different outcomes, without simulating all of it.

    ``grid`` is as for :func:`sweep`. Starting from ``coarse`` cells an axis, the cells whose corners differ
    are halved, and unless not ``thorough`` those around them, until they are those of the grid. ``client`` may be ``None``: then it is
    done here. ``progress`` is called with how many points were simulated, and ``None``.

    Returns a :class:`passivity.adaptive.Border`.
    """
    source, ranges = _absolute(_scene(scene)), _ranges(**grid)
    points, axes, values = _passivity.grid(source, ranges)
    simulated = 0

    def evaluate(indices):
        nonlocal simulated
        if client is None:
            found = _outcomes(source, ranges, indices, 0)
        else:
            pieces = [indices[i : i + chunk] for i in range(0, len(indices), chunk)]
            jobs = [
                client.submit(_outcomes, source, ranges, piece, threads, pure=False, retries=retries)
                for piece in pieces
            ]
            found = [outcome for piece in client.gather(jobs) for outcome in piece]
        simulated += len(indices)
        if progress is not None:
            progress(simulated, None)
        return found

    cells, outcomes = _refine([len(axis) for axis in values], evaluate, coarse=coarse, thorough=thorough)
    result = _Border(points=points, simulated=len(outcomes), cells=cells)
    result.outcomes, result.axes = outcomes, axes
    return result
