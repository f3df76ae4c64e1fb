"""Exact energy accounting of haptic devices that render virtual walls.

>>> import passivity
>>> passivity.check({"dimensionless": {"beta": "3/5", "sigma": "3/5"}})["verdict"]
'passive'
>>> passivity.interval("1", "1/2", beta="3/5", sigma="3/5")["generated_quantized"]
'1/2'

Exact numbers are strings such as ``"3/8"``; ``fractions.Fraction`` reads them. A scene is the path
of a scene file, or a mapping with its sections and keys.
"""

from __future__ import annotations

import json as _json
import os as _os
import sys as _sys
from array import array as _array
from collections.abc import Mapping as _Mapping
from decimal import Decimal as _Decimal
from fractions import Fraction as _Fraction

from . import _passivity
from ._passivity import __version__

__all__ = ["Simulation", "__version__", "audit", "check", "interval", "simulate"]


def _exact(value):
    """Fractions and decimals as the text that spells them."""
    if isinstance(value, (_Fraction, _Decimal)):
        return str(value)
    raise TypeError(f"a scene cannot hold {type(value).__name__}")


def _scene(scene):
    if isinstance(scene, _Mapping):
        return {"object": _json.dumps(dict(scene), default=_exact, allow_nan=False)}
    return {"path": _os.fspath(scene)}


def check(scene):
    """The verdict on a scene: the fields of ``passivity check --format json``.

    Raises ``ValueError`` with the place and what was expected when the scene cannot be read.
    """
    return _json.loads(_passivity.check(**_scene(scene)))


def interval(xi0, xi1, *, beta, sigma, dtau=1):
    """The exact ledger row of one interval, from ``xi0`` to ``xi1`` encoder ticks.

    Numbers are ints, ``Fraction``, ``Decimal``, strings such as ``"3/8"``, or floats, each of which
    is the dyadic rational that it is. Raises ``ValueError`` for what is no number.
    """
    request = {"op": "interval", "xi0": xi0, "xi1": xi1, "beta": beta, "sigma": sigma, "dtau": dtau}
    for name, value in request.items():
        if isinstance(value, float):
            if value != value or value in (float("inf"), float("-inf")):
                raise ValueError(f"{name}: {value} is not a number that a quantity can have")
            value = _Fraction(value)
        request[name] = value if isinstance(value, str) else str(value)
    answer = _json.loads(_passivity.answer(_json.dumps(request).encode()))
    if "error" in answer:
        raise ValueError(f"{answer['error']['at']}: {answer['error']['message']}")
    return answer["result"]


def audit(trace, scene, *, unit=None, t=None, t_unit="s", out=None, threads=0):
    """The exact account of a trace: the fields of ``passivity audit --format json``.

    ``trace`` is the path of a CSV or Parquet file, or a one-dimensional array (NumPy or any other
    with the buffer protocol, or a sequence): integers are encoder counts, floats positions in ticks,
    or in ``unit`` when one is given. ``t`` are the times of the samples, in ``t_unit``; in sampling
    periods with ``t_unit=None``. ``out`` is a file for the rows, as CSV.

    Raises ``ValueError`` for a header, unit or array that cannot be read. A mistake further on is
    in the report: ``report["error"]`` says where, and the account is of what came before.
    """
    where = {**_scene(scene), "out": None if out is None else _os.fspath(out), "threads": threads}
    if isinstance(trace, (str, _os.PathLike)):
        if unit is not None or t is not None:
            raise ValueError("a file has its units and times in its own columns")
        return _json.loads(_passivity.audit_file(_os.fspath(trace), **where))
    data, whole = _words(trace, "trace")
    if whole and unit is not None:
        raise ValueError("counts have no unit")
    column = "count" if whole else ("xi" if unit is None else f"x [{unit}]")
    times = None
    if t is not None:
        text, whole_times = _words(t, "t")
        if whole_times:
            text = _array("d", _array("q", text)).tobytes()
        times = ("tau" if t_unit is None else f"t [{t_unit}]", text)
    return _json.loads(_passivity.audit_arrays(column, data, times, **where))


def _words(values, name):
    """The bytes of a one-dimensional array as 64-bit integers or doubles, and which it is."""
    try:
        view = memoryview(values)
    except TypeError:
        values = list(values)
        whole = all(isinstance(x, int) and not isinstance(x, bool) for x in values)
        try:
            return _array("q" if whole else "d", values).tobytes(), whole
        except (OverflowError, TypeError) as error:
            raise ValueError(f"{name}: {error}") from None
    if view.ndim != 1:
        raise ValueError(f"{name}: expected one dimension, found {view.ndim}")
    order = {"<": "little", ">": "big", "!": "big"}.get(view.format[0], _sys.byteorder)
    kind = view.format.lstrip("@=<>!")
    if order != _sys.byteorder:
        raise ValueError(f"{name}: expected the byte order of this machine")
    if kind in ("q", "l") and view.itemsize == 8:
        return view.tobytes(), True
    if kind in "bBhHiIlLqQ" and kind:
        try:
            return _array("q", view.tolist()).tobytes(), True
        except OverflowError as error:
            raise ValueError(f"{name}: {error}") from None
    if kind == "d":
        return view.tobytes(), False
    if kind in ("f", "e"):
        return _array("d", view.tolist()).tobytes(), False
    raise ValueError(f"{name}: expected numbers, found the format {view.format!r}")


class Simulation(dict):
    """A simulation's report, with its columns as ``columns``."""

    columns: dict


def simulate(scene, *, method="closed-form", intervals=None, trace=True):
    """The motion of a scene: the fields of ``passivity simulate --format json``.

    With ``trace``, ``result.columns`` maps ``xi0``, ``xi1``, ``v0``, ``v1``, ``generated_linear``,
    ``generated_quantized`` and ``dissipated`` to arrays of doubles, one value per interval: NumPy
    arrays when NumPy is there, else ``array.array``.
    """
    report, columns = _passivity.simulate(
        **_scene(scene), method=method, intervals=intervals, trace=trace
    )
    result = Simulation(_json.loads(report))
    result.columns = {name: _doubles(data) for name, data in columns}
    return result


def _doubles(data):
    try:
        import numpy
    except ImportError:
        values = _array("d")
        values.frombytes(bytes(data))
        return values
    return numpy.frombuffer(bytes(data), dtype=numpy.float64)
