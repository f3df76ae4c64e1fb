"""Columns of numbers as Python has them: whole numbers stay whole, whatever they are kept in."""

from __future__ import annotations

import numbers as _numbers
import sys as _sys
from array import array as _array
from collections.abc import Mapping as _Mapping
from collections.abc import Set as _Set

from . import _arrow


def numbers(values, name):
    """A buffer of 64-bit integers or doubles, and whether it is of integers."""
    if isinstance(values, (_Mapping, _Set, str, bytes, bytearray)):
        raise ValueError(f"{name}: expected numbers in an order, found {type(values).__name__}")
    numpy = _sys.modules.get("numpy")
    if numpy is not None and isinstance(values, numpy.ma.MaskedArray):
        raise ValueError(f"{name}: masked values are missing: fill them or leave them out first")
    pandas = _sys.modules.get("pandas")
    if pandas is not None and isinstance(values, (pandas.Series, pandas.Index)):
        if isinstance(values.dtype, pandas.api.extensions.ExtensionDtype) and values.hasnans:
            raise ValueError(f"{name}: some values are missing: fill them or leave them out first")
        values = values.to_numpy()
    if numpy is not None and isinstance(values, numpy.ndarray):
        return _of_numpy(values, name, numpy)
    if _arrow.is_arrow(values):
        return _arrow.numbers(values, name)
    try:
        view = memoryview(values)
    except TypeError:
        return _of_sequence(values, name)
    return _of_view(view, name)


def _of_numpy(values, name, numpy):
    if values.ndim != 1:
        raise ValueError(f"{name}: expected one dimension, found {values.ndim}")
    kind = values.dtype.kind
    if kind == "O":
        return _of_sequence(values.tolist(), name)
    if kind == "u" and len(values) and values.max() > numpy.iinfo(numpy.int64).max:
        return _column("q", values.tolist(), name), True
    if kind in "iu":
        return numpy.ascontiguousarray(values, dtype=numpy.int64), True
    if kind == "f" and values.dtype.itemsize <= 8:
        return numpy.ascontiguousarray(values, dtype=numpy.float64), False
    raise ValueError(f"{name}: expected integers or doubles, found {values.dtype}")


def _of_view(view, name):
    if view.ndim != 1:
        raise ValueError(f"{name}: expected one dimension, found {view.ndim}")
    order = {"<": "little", ">": "big", "!": "big"}.get(view.format[0], _sys.byteorder)
    kind = view.format.lstrip("@=<>!")
    if order != _sys.byteorder:
        raise ValueError(f"{name}: expected the byte order of this machine")
    if kind in ("q", "l") and view.itemsize == 8:
        return _closed(view, "q"), True
    if kind == "d":
        return _closed(view, "d"), False
    if kind and kind in "bBhHiIlLqQ":
        return _column("q", view, name), True
    if kind in ("f", "e"):
        return _column("d", view, name), False
    raise ValueError(f"{name}: expected numbers, found the format {view.format!r}")


def _closed(view, code):
    """A view without gaps: itself, or a copy."""
    if view.c_contiguous:
        return view
    column, block = _array(code), _arrow.BLOCK
    for start in range(0, len(view), block):
        column.frombytes(view[start : start + block].tobytes())
    return column


def _is_bool(x):
    return isinstance(x, bool) or type(x).__name__ in ("bool_", "bool")


def _of_sequence(values, name):
    values = list(values)
    for x in values:
        if _is_bool(x) or not isinstance(x, (_numbers.Integral, float, _numbers.Real)):
            raise ValueError(f"{name}: expected numbers, found {type(x).__name__}")
        if isinstance(x, _numbers.Rational) and not isinstance(x, _numbers.Integral):
            raise ValueError(f"{name}: expected integers or floats, found {type(x).__name__}")
    whole = all(isinstance(x, _numbers.Integral) for x in values)
    column = _column("q" if whole else "d", map(int if whole else float, values), name)
    for x, double in zip(() if whole else values, column):
        if isinstance(x, _numbers.Integral) and double != x:
            raise ValueError(f"{name}: no double is {x}, an integer among floats")
    return column, whole


def _column(code, values, name):
    column = _array(code)
    _arrow.extend(column, values, name)
    return column
