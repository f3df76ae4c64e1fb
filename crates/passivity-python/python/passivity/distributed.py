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
import threading as _threading
import time as _time

from . import _given, _logged, _passivity, _pieces, _report, __version__
from ._parts import Parts as _Parts
from ._parts import written as _written
from .adaptive import Border as _Border
from .adaptive import refine as _refine
from .results import SweepResult as _SweepResult

__all__ = ["audit", "border", "sweep"]

# How many bytes of a log and how many points of a grid the first pieces have.
_BYTES, _POINTS = 1 << 20, 1024

# What a task costs beside its work, in seconds, where no two of one worker were measured.
_OVERHEAD = 0.005


def _threads(client, each):
    """How many tasks of so many threads the workers do at once."""
    return max(1, sum(client.nthreads().values()) // each)


def _plan(parts, wanted):
    """The pieces that were decided on when the work began, if it did."""
    if parts is None or "plan.json" not in parts.names():
        return []
    found = _json.loads(parts.read("plan.json"))
    pieces = [tuple(piece) for piece in found.pop("pieces")]
    if found != wanted:
        raise ValueError(f"{parts.place} has shards of other work: give another folder, or remove it")
    return pieces


def _identity(source):
    """What tells one scene from another."""
    kind, text = source
    if kind == "path":
        with open(text, "rb") as file:
            return _hashlib.file_digest(file, "sha256").hexdigest()
    return _hashlib.sha256(text.encode()).hexdigest()


def _absolute(source):
    kind, text = source
    return (kind, _os.path.abspath(text) if kind == "path" else text)


def _timed(call, job):
    """The result of ``call``, which worker thread it had, and from when to when."""
    from distributed import get_worker

    begin = _time.perf_counter()
    result = call(job)
    return result, (get_worker().address, _threading.get_ident()), begin, _time.perf_counter()


class _Costs:
    """What the units of finished pieces cost, and a task beside its work."""

    def __init__(self):
        self.spans, self.rates = {}, []

    def add(self, units, thread, begin, end):
        self.spans.setdefault(thread, []).append((begin, end))
        self.rates.append(max(end - begin, 1e-9) / units)

    def a_unit(self):
        """Seconds, of a piece in the middle of all."""
        return _statistics.median(self.rates)

    def a_task(self):
        """Seconds between two tasks of a thread, the second of which was there already."""
        between = [
            max(0.0, later[0] - earlier[1])
            for spans in self.spans.values()
            for earlier, later in zip(sorted(spans), sorted(spans)[1:])
        ]
        return _statistics.median(between) if between else _OVERHEAD


class _Work:
    """Work on the workers of a client, in pieces of measured size."""

    def __init__(self, client, call, sizes, *, first, seconds, shards, threads, retries, progress):
        self.client, self.call, self.sizes, self.first = client, call, sizes, first
        self.seconds, self.shards, self.threads = seconds, shards, threads
        self.retries, self.progress = retries, progress
        self.pieces, self.costs, self.lost = [], _Costs(), {}
        self.futures, self.coming = {}, None

    def submit(self, jobs):
        for job in jobs:
            future = self.client.submit(_timed, self.call, job, pure=False, retries=self.retries)
            self.futures[future] = job
            self.coming.add(future)

    def run(self, pieces, is_there, record, done):
        """Goes on with pieces that were decided on. ``record`` is given all of them before a new one is begun,
        ``done`` each piece with its result."""
        from distributed import as_completed

        self.pieces = list(pieces)
        finished = [piece for piece in pieces if is_there(piece)]
        amount, total = _pieces.units(finished), sum(self.sizes)
        self.coming = as_completed([], with_results=True, raise_errors=False)
        try:
            self.submit([piece for piece in pieces if piece not in set(finished)])
            left = _pieces.gaps(self.sizes, self.pieces)
            if left:
                left = self.begin(left, record)
            if self.progress is not None:
                self.progress(amount, total)
            enough = len(self.futures) * 2 // 3
            for future, result in self.coming:
                job = self.futures.pop(future)
                if self.is_again(future, job):
                    continue
                value, thread, begin, end = result if future.status == "finished" else future.result()
                self.costs.add(_pieces.units([job]), thread, begin, end)
                done(job, value)
                amount += _pieces.units([job])
                enough -= 1
                if left and (enough <= 0 or not self.futures):
                    left = self.finish(left, record)
                if self.progress is not None:
                    self.progress(amount, total)
        except BaseException:
            self.client.cancel(list(self.futures))
            raise

    def begin(self, left, record):
        """Submits the first pieces; what is left after them."""
        if self.shards is not None:
            new = _pieces.even(left, self.shards)
        else:
            new = _pieces.first(left, _threads(self.client, self.threads), self.first)
        self.pieces += new
        record(self.pieces)
        self.submit(new)
        return _pieces.gaps(self.sizes, self.pieces)

    def finish(self, left, record):
        """Submits all the others."""
        threads = _threads(self.client, self.threads)
        cost = self.costs.a_unit()
        new = _pieces.rest(left, threads, cost, self.seconds, self.costs.a_task())
        self.pieces += new
        record(self.pieces)
        self.submit(new)
        return []

    def is_again(self, future, job):
        """Whether a piece is done again: its worker was lost."""
        from distributed.scheduler import KilledWorker

        if future.status != "error" or not isinstance(future.exception(), KilledWorker):
            return False
        self.lost[job] = self.lost.get(job, 0) + 1
        if self.lost[job] > self.retries:
            return False
        self.submit([job])
        return True


class _SweepShard:
    """One shard of a sweep, simulated where it is called."""

    def __init__(self, scene, ranges, points, parts, threads):
        self.scene, self.ranges, self.points = scene, ranges, points
        self.parts, self.threads = parts, threads

    def name(self, piece):
        _, start, to = piece
        return f"part-{start:012}-{to:012}.parquet"

    def __call__(self, piece):
        _, start, to = piece
        shard = (start + 1, to, self.points)
        with self.parts.writing(self.name(piece)) as path:
            _passivity.sweep(self.scene, self.ranges, path, shard, False, self.threads)


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
    source, ranges = _absolute(_given.scene(scene)), _given.ranges(**grid)
    points, axes, _ = _passivity.grid(source, ranges)
    path = _os.fspath(out)
    folder = _Parts(parts if parts is not None else path + ".parts", storage_options)
    wanted = {
        "format": "passivity-sweep-plan-2",
        "version": __version__,
        "scene": _identity(source),
        "ranges": ranges,
    }

    task = _SweepShard(source, ranges, points, folder, threads)
    there, pieces = folder.names(), _plan(folder, wanted)
    work = _Work(
        client,
        task,
        [points],
        first=_POINTS,
        seconds=seconds,
        shards=shards,
        threads=threads,
        retries=retries,
        progress=progress,
    )
    simulated = []
    work.run(
        pieces,
        lambda piece: task.name(piece) in there,
        lambda pieces: folder.write("plan.json", _json.dumps({**wanted, "pieces": pieces}).encode()),
        lambda piece, _: simulated.append(piece),
    )
    counts = {"shards": len(work.pieces), "simulated_shards": len(simulated)}
    names = [task.name(piece) for piece in sorted(work.pieces)]
    if not merge:
        result = _SweepResult.of_file("{}", axes, folder.place)
        result.update(points=points, **counts)
        return result
    with _tempfile.TemporaryDirectory() as local, _written(path, storage_options) as merged:
        report = _passivity.sweep_merge(source, ranges, folder.fetch(names, local), merged)
    if not keep:
        folder.remove()
    result = _SweepResult.of_file(report, axes, path)
    result.update(counts)
    return result


class _AuditPiece:
    """The account of one piece of a log, made where it is called."""

    def __init__(self, scene, reading, logs, parts):
        self.scene, self.reading, self.logs, self.parts = scene, reading, logs, parts

    def name(self, piece):
        part, start, to = piece
        log, _ = self.logs[part]
        of = _hashlib.sha256(log.encode(errors="surrogateescape")).hexdigest()[:16]
        return f"{of}-{start:015}-{to:015}.json"

    def __call__(self, piece):
        part, start, to = piece
        log, size = self.logs[part]
        account, _, _ = _passivity.audit_piece(log, self.scene, self.reading, f"{start + 1}-{to}/{size}")
        if self.parts is not None:
            self.parts.write(self.name(piece), account.encode())
        return account


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
    source = _absolute(_given.scene(scene))
    reading = _logged(columns, delimiter, decimal_comma, law, threads)
    folder = None if parts is None else _Parts(parts, storage_options)

    # A log without a byte is one piece: its account says what is wrong with it.
    sizes = [max(1, _os.path.getsize(log)) for log in logs]
    wanted = {
        "format": "passivity-audit-plan-2",
        "version": __version__,
        "scene": _identity(source),
        "reading": {**reading, "threads": 0},
        "logs": [[log, size, _os.stat(log).st_mtime_ns] for log, size in zip(logs, sizes, strict=True)],
    }
    task = _AuditPiece(source, reading, list(zip(logs, sizes, strict=True)), folder)
    there, pieces = set() if folder is None else folder.names(), _plan(folder, wanted)
    work = _Work(
        client,
        task,
        sizes,
        first=_BYTES,
        seconds=seconds,
        shards=shards,
        threads=threads,
        retries=retries,
        progress=progress,
    )

    def record(pieces):
        if folder is not None:
            folder.write("plan.json", _json.dumps({**wanted, "pieces": pieces}).encode())

    found = {}
    work.run(pieces, lambda piece: task.name(piece) in there, record, found.__setitem__)
    accounts = [[] for _ in logs]
    for piece in sorted(work.pieces):
        part, start, to = piece
        account = found[piece] if piece in found else folder.read(task.name(piece)).decode()
        name = logs[part].encode(errors="surrogateescape").decode(errors="replace")
        accounts[part].append((f"bytes {start} to {to} of {name}", account))
    reports = [_report(_passivity.audit_merge(pieces, source)) for pieces in accounts]
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
    source, ranges = _absolute(_given.scene(scene)), _given.ranges(**grid)
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
