"""Exact energy accounting of haptic devices that render virtual walls.

>>> import passivity
>>> scene = {"dimensionless": {"mu": "50", "beta": "3/5", "sigma": "3/5"}}
>>> passivity.check(scene).verdict
'passive'
>>> passivity.interval("1", "1/2", beta="3/5", sigma="3/5")["generated_quantized"]
'1/2'
>>> passivity.audit([0, 1, 3, 2], scene).verdict
'holds'

Exact numbers are strings such as ``"3/8"``; ``fractions.Fraction`` reads them. A scene is the path
of a scene file, its text, or a mapping with its sections and keys. Every call can be interrupted, and lets
other threads run; columns in memory are copied first, in blocks between which that holds.
"""

from __future__ import annotations

import json as _json
import os as _os
import tempfile as _tempfile
import warnings as _warnings
from fractions import Fraction as _Fraction
from math import isfinite as _isfinite
from numbers import Rational as _Rational
from numbers import Real as _Real

from . import _arrays, _given, _passivity
from ._passivity import IdentificationError, SceneError, SimulationError, TraceError, __version__
from .results import AuditReport, Identification, Record, Simulation, SweepResult, Verdict
from .results import doubles as _doubles

__all__ = [
    "AuditReport",
    "Identification",
    "IdentificationError",
    "Record",
    "SceneError",
    "Simulation",
    "SimulationError",
    "SweepResult",
    "TraceError",
    "Verdict",
    "__version__",
    "audit",
    "check",
    "identify",
    "interval",
    "simulate",
    "sweep",
]


def check(scene):
    """The verdict on a scene: the fields of ``passivity check --format json``.

    >>> verdict = check({"dimensionless": {"beta": "2/5", "sigma": "2/5"}})
    >>> verdict.verdict, verdict["spare"].viscous.lo
    ('not_passive', '-1/10')

    Raises :class:`SceneError` with the place and what was expected when the scene cannot be read:

    >>> try:
    ...     check('[sampling]\\nperiod = "1 m"\\n[wall]\\nstiffness = "1 N/m"\\n')
    ... except SceneError as error:
    ...     print(error.line, error.key)
    2 sampling.period
    """
    return Verdict.from_json(_passivity.check(_given.scene(scene)))


def interval(xi0, xi1, *, beta, sigma, dtau=1):
    """The exact ledger row of one interval, from ``xi0`` to ``xi1`` encoder ticks.

    Numbers are ints, ``Fraction``, ``Decimal``, strings such as ``"3/8"``, or floats, NumPy's too, each of
    which is the dyadic rational that it is. Raises ``ValueError`` for what is no number.

    >>> interval(1, 0.5, beta=1, sigma=1).generated_linear
    '3/8'
    """
    request = {"op": "interval", "xi0": xi0, "xi1": xi1, "beta": beta, "sigma": sigma, "dtau": dtau}
    for name, value in request.items():
        # NumPy's floats are no `float` but for those of 64 bits.
        if hasattr(value, "as_integer_ratio") and isinstance(value, _Real) and not isinstance(value, _Rational):
            if not _isfinite(value):
                raise ValueError(f"{name}: {value} is not a number that a quantity can have")
            value = _Fraction(*value.as_integer_ratio())
        request[name] = value if isinstance(value, str) else str(value)
        if any("\ud800" <= character <= "\udfff" for character in request[name]):
            raise ValueError(f"{name}: {value!a} is not a number")
    answer = _json.loads(_passivity.answer(_json.dumps(request).encode()), object_hook=Record)
    if "error" in answer:
        raise ValueError(f"{answer['error']['at']}: {answer['error']['message']}")
    return answer["result"]


def audit(
    trace,
    scene,
    *,
    unit=None,
    t=None,
    t_unit="s",
    f=None,
    f_unit=None,
    columns=None,
    delimiter=None,
    decimal_comma=False,
    law=False,
    out=None,
    threads=0,
    progress=None,
):
    """The exact account of a trace: the fields of ``passivity audit --format json``.

    ``trace`` is the path of a CSV, Parquet or MCAP file, a list of paths whose files are one trace, or a column of
    positions: a list, or an array of NumPy, pandas, Polars, Arrow or anything with the buffer protocol.
    Integers are encoder counts, floats positions in ticks, or in ``unit`` when one is given. ``t`` are the
    times of the samples, in ``t_unit``; in sampling periods with ``t_unit=None``. ``f`` are the forces that
    were commanded at the samples, in ``f_unit``; in KΔ with ``f_unit=None``. ``columns`` says which columns
    of a file are read, as ``--columns`` does: ``"t=time [us], x=position [deg]"``, a list of its parts, or a mapping
    such as ``{"t": "time [us]", "x": "position [deg]"}``, in which names may have commas, quotes and equals signs. ``law``
    selects the force of the scene's law where there are others. ``out`` is a file for the rows, as CSV.
    ``progress`` is called with how many samples were read, and ``None`` for how many there are.

    >>> scene = {"dimensionless": {"beta": "3/5", "sigma": "3/5"}}
    >>> report = audit([0.0, 0.5, -0.25], scene, t=[0, 1, 2.5], t_unit=None)
    >>> report.intervals, report.timing.late
    (2, 1)

    Raises :class:`TraceError` for a header, unit or array that cannot be read. A mistake further on is
    in the report: ``report["error"]`` says where, and the account is of what came before.
    """
    reading = _logged(columns, delimiter, decimal_comma, law, threads)
    where = _given.scene(scene), reading, _given.path("out", out), _given.told(progress, None)
    unit, t_unit, f_unit = map(_given.text, ("unit", "t_unit", "f_unit"), (unit, t_unit, f_unit))
    paths = _given.paths("trace", trace)
    if paths is not None:
        if not (unit is None and t is None and f is None and f_unit is None):
            raise ValueError("a file has its units, times and forces in its own columns")
        return _report(_passivity.audit_file(paths, *where))
    data, whole = _arrays.numbers(trace, "trace")
    if whole and unit is not None:
        raise ValueError("counts have no unit")
    table = [("count" if whole else ("xi" if unit is None else f"x [{unit}]"), data)]
    if t is not None:
        table.append(("tau" if t_unit is None else f"t [{t_unit}]", _arrays.numbers(t, "t")[0]))
    if f is not None:
        table.append(("f" if f_unit is None else f"f [{f_unit}]", _arrays.numbers(f, "f")[0]))
    elif f_unit is not None:
        raise ValueError("f_unit is the unit of f, and there is none")
    return _report(_passivity.audit_arrays(table, *where))


def _logged(columns, delimiter, decimal_comma, law, threads):
    """How a log is read and judged, as the native functions take it."""
    return {
        **_given.reading(columns, delimiter, decimal_comma),
        "law": _given.flag("law", law),
        "threads": _given.whole("threads", threads, 0, 1024),
    }


def _report(answer):
    text, certificate = answer
    report = AuditReport.from_json(text)
    report.certificate = None if certificate is None else Record.from_json(certificate)
    return report


def identify(
    logs,
    sketch,
    *,
    count_error=1.0,
    force_error=0.0,
    scale_error=None,
    inertia="sketch",
    effort=None,
    columns=None,
    delimiter=None,
    decimal_comma=False,
    out=None,
    device=None,
    date=None,
    progress=None,
):
    """The friction of a device, and its inertia, from logs of its motion: the fields of ``passivity identify
    --format json``. The bounds surely hold the true parameters, if the device is one of the model.

    ``logs`` is the path of a log with the commanded force, or a list of them, one experiment each: the device
    starts at rest, and nobody touches it. ``sketch`` is a scene that says what is known: sampling period,
    encoder and, with ``inertia="sketch"``, the inertia; with ``inertia="free"`` it is looked for. A wall may be
    missing. ``count_error`` is by how many ticks a count may be off, ``force_error`` by how much the force may,
    in N or N m, and ``scale_error`` by what share of itself, as by a torque constant: 0.05 for 5 %. ``effort`` is how much work the search may be, in millions of intervals of motion. ``columns``,
    ``delimiter`` and ``decimal_comma`` are those of :func:`audit`. ``out`` is a file for the scene that was
    found, with ``device`` and ``date``, a day such as ``"2026-11-20"`` or a ``datetime.date``, noted in it. Where no
    scene can be written, as nothing fits or a parameter has no bounds, ``toml`` of the answer is ``None``, no file is
    written, and a warning (``UserWarning``) says why.
    ``progress`` is called with how much of the work is done, in intervals, and the most that it is where
    ``effort`` says so.

    >>> sketch = "[sampling]\\nperiod = '1 ms'\\n[device]\\ninertia = '6e-6 kg m^2'\\n[encoder]\\ncounts_per_revolution = 8192\\n"
    >>> with _tempfile.TemporaryDirectory() as folder:
    ...     log = _os.path.join(folder, "rest.csv")
    ...     with open(log, "w") as file:
    ...         _ = file.write("count,f [N m]\\n" + "0,0.001\\n" * 50)
    ...     found = identify(log, sketch)
    >>> found.refuted_by, found.informative, found.parameters.coulomb.best
    (None, False, None)

    Raises :class:`TraceError` for a log that cannot be read, :class:`SceneError` for a sketch that cannot, and
    :class:`IdentificationError` for a log or a sketch by which nothing can be looked for.
    """
    if inertia not in ("sketch", "free"):
        raise ValueError(f"inertia: expected 'sketch' or 'free', found {inertia!r}")
    paths = _given.paths("logs", logs)
    if paths is None:
        raise TypeError("logs: expected the path of a log, or a list of paths")
    effort, out = _given.whole("effort", effort, *_passivity.EFFORT), _given.path("out", out)
    asked = {
        **_given.reading(columns, delimiter, decimal_comma),
        "count_error": _given.number("count_error", count_error),
        "force_error": _given.number("force_error", force_error),
        "scale_error": None if scale_error is None else _given.number("scale_error", scale_error),
        "free_inertia": inertia == "free",
        "effort": effort,
        "device": _given.text("device", device),
        "date": _given.day("date", date),
    }
    told = _given.told(progress, None if effort is None else effort * 1_000_000)
    report, scene, picture, why = _passivity.identify(paths, _given.scene(sketch), asked, out, told)
    if out is not None and why is not None:
        _warnings.warn(f"{out} is not written: {why.replace('--effort', '`effort`')}", stacklevel=2)
    result = Identification.from_json(report)
    result.toml, result.picture = scene, picture
    return result


def simulate(
    scene, *, method="closed-form", intervals=None, speed=None, trace=True, progress=None
):
    """The motion of a scene: the fields of ``passivity simulate --format json``.

    With ``trace``, ``result.columns`` maps ``xi0``, ``xi1``, ``v0``, ``v1``, ``generated_linear``,
    ``generated_quantized`` and ``dissipated`` to arrays of doubles, one value per interval: NumPy
    arrays when NumPy is there, else ``array.array``. ``speed`` is the speed at the start in place of the
    scene's: a text with a unit, or a number in ticks per sample where the scene has an encoder. ``progress`` is
    called with how many intervals were simulated and how many are asked for, or ``None`` where the scene says.

    >>> scene = {"dimensionless": {"mu": 50, "beta": "3/5", "sigma": "3/5"}, "run": {"intervals": 2000}}
    >>> result = simulate(scene, speed=4)
    >>> result.outcome.exact, len(result.columns["xi0"]) == result.intervals
    ('at_rest', True)
    """
    report, columns = _passivity.simulate(
        _given.scene(scene),
        _given.text("method", method),
        _given.how_long(intervals),
        None if speed is None else _given.spelled("speed", speed),
        _given.flag("trace", trace),
        _given.told(progress, intervals),
    )
    result = Simulation.from_json(report)
    result.columns = {name: _doubles(data) for name, data in columns}
    return result


def sweep(
    scene,
    *,
    beta=None,
    sigma=None,
    speed=None,
    vary=None,
    intervals=None,
    out=None,
    resume=False,
    threads=0,
    progress=None,
):
    """The outcome of every point of a grid: the fields of ``passivity sweep --format json``.

    The grid is of ``beta``, ``sigma`` and perhaps ``speed``, each a range ``"0:1:41"`` (both ends included) or
    numbers, or of two or three parameters of the scene: ``vary={"stiffness": "0.1:2:41 N m/rad", …}``. The
    points go to ``out``, as CSV or, where the name ends in ``.parquet``, as Parquet; with ``resume`` an
    interrupted sweep goes on there. The result reads them from there when they are first asked for, and refuses a file
    that another sweep wrote since. ``progress`` is called with how many points are done, of how many.

    >>> scene = {"dimensionless": {"mu": 50, "beta": 1, "sigma": 1}, "run": {"intervals": 1000}}
    >>> result = sweep(scene, beta="0:1:3", sigma=["1/4", 1], speed=[5])
    >>> result.points, result.columns["exact"][-1]
    (6, 'at_rest')
    """
    ranges = _given.ranges(beta, sigma, speed, vary, intervals)
    where, threads = _given.scene(scene), _given.whole("threads", threads, 0, 1024)
    path, resume = _given.path("out", out), _given.flag("resume", resume)
    points, axes, _ = _passivity.grid(where, ranges)
    told = _given.told(progress, points)
    if path is not None:
        report = _passivity.sweep(where, ranges, path, None, resume, threads, told)
        return SweepResult.of_file(report, axes, path)
    if resume:
        raise ValueError("resume goes on with the file of `out`, and there is none")
    with _tempfile.TemporaryDirectory() as folder:
        path = _os.path.join(folder, "grid.csv")
        report = _passivity.sweep(where, ranges, path, None, False, threads, told)
        result = SweepResult.of_file(report, axes, path)
        _ = result.columns
    return result
