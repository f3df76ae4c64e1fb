"""What callers give, as the native functions take it; an error names the argument, what is expected and what is there."""

from __future__ import annotations

import json as _json
import os as _os
import re as _re
from collections.abc import Iterable as _Iterable
from collections.abc import Mapping as _Mapping
from datetime import date as _date
from datetime import datetime as _datetime
from decimal import Decimal as _Decimal
from fractions import Fraction as _Fraction
from math import isfinite as _isfinite
from numbers import Integral as _Integral
from numbers import Rational as _Rational
from numbers import Real as _Real

from . import _passivity
from ._passivity import SimulationError


def _wrong(name, expected, value):
    return TypeError(f"{name}: expected {expected}, found {type(value).__name__}")


def text(name, value, expected="a text"):
    """A text, or None."""
    if value is None:
        return None
    if not isinstance(value, str):
        raise _wrong(name, expected, value)
    if any("\ud800" <= character <= "\udfff" for character in value):
        raise ValueError(f"{name}: expected {expected}, found {value!a}, which has half of a character")
    return value


def flag(name, value):
    """True or False, NumPy's too."""
    if isinstance(value, bool) or type(value).__name__ in ("bool", "bool_"):
        return bool(value)
    raise _wrong(name, "True or False", value)


def number(name, value):
    """A number as a double."""
    if isinstance(value, (_Real, _Decimal)) and not isinstance(value, bool):
        return float(value)
    raise _wrong(name, "a number", value)


def whole(name, value, least, most):
    """A whole number in a range, or None."""
    if value is None:
        return None
    if isinstance(value, _Integral) and not isinstance(value, bool) and least <= value <= most:
        return int(value)
    raise ValueError(f"{name}: expected a whole number from {least} to {most}, found {value!r}")


def how_long(value):
    """How many intervals a run has, or None."""
    return whole("intervals", value, 1, _passivity.MAX_INTERVALS)


def path(name, value):
    """The path of a file as text, or None."""
    if value is None:
        return None
    if isinstance(value, (str, _os.PathLike)) and isinstance(found := _os.fspath(value), str):
        return found
    raise _wrong(name, "the path of a file", value)


def paths(name, value):
    """The paths of files, or None where something else is given."""
    if isinstance(value, (str, _os.PathLike)):
        return [path(name, value)]
    if isinstance(value, (list, tuple)) and value and all(isinstance(x, (str, _os.PathLike)) for x in value):
        return [path(name, x) for x in value]
    return None


def day(name, value):
    """A date as text, or None; of a time its day."""
    if isinstance(value, _datetime):
        value = value.date()
    return value.isoformat() if isinstance(value, _date) else text(name, value, "a text or a date")


def told(progress, total):
    """What is called with how much is done, of how much in all."""
    if progress is None:
        return None
    if not callable(progress):
        raise _wrong("progress", "a function", progress)
    return lambda done: progress(done, total)


def _exact(value):
    """Fractions, decimals and NumPy's numbers as what spells them."""
    if isinstance(value, (_Fraction, _Decimal)):
        return str(value)
    if isinstance(value, _Integral):
        return int(value)
    if isinstance(value, _Real):
        return float(value)
    raise TypeError(f"a scene cannot hold {type(value).__name__}")


def spelled(name, value):
    """A text, or what spells a number, which a truth value is not."""
    if isinstance(value, str):
        return text(name, value)
    if isinstance(value, bool):
        raise ValueError(f"{name}: expected a number or a text, found {value}")
    if not isinstance(value, (_Real, _Decimal)):
        raise _wrong(name, "a number or a text", value)
    return str(_exact(value))


def scene(given):
    if isinstance(given, _Mapping):
        return "object", _json.dumps(_finite(given), default=_exact)
    # No file has an empty name: that is the text of a scene without anything.
    if isinstance(given, str) and ("\n" in given or not given):
        return "text", text("scene", given)
    if isinstance(given, (str, _os.PathLike)) and isinstance(found := _os.fspath(given), str):
        return "path", found
    raise _wrong("scene", "the path of a scene file, its text, or a mapping", given)


def _finite(value):
    """A scene with what JSON has no number for as text, of which its reader says where it stands."""
    if isinstance(value, _Mapping):
        return {key: _finite(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(inner) for inner in value]
    if isinstance(value, _Real) and not isinstance(value, _Rational):
        return float(value) if _isfinite(value) else str(float(value))
    return value


def reading(columns, delimiter, decimal_comma):
    """How the columns of a file are called, and how its numbers are written."""
    return {
        "columns": _columns(columns),
        "delimiter": text("delimiter", delimiter),
        "decimal_comma": flag("decimal_comma", decimal_comma),
    }


def _columns(given):
    """`role=column, …` as text: as it is, a list of its parts, or a mapping of roles to names."""
    expected = "a text such as 't=time [us], count=pos', a list of its parts, or a mapping of roles to columns"
    if isinstance(given, _Mapping):
        given = [f"{_role(role)}={_named(role, name)}" for role, name in given.items()]
    if isinstance(given, (list, tuple)):
        given = ", ".join(text("columns", part, "texts such as 'count=pos'") or "" for part in given)
    return text("columns", given, expected)


def _role(role):
    if isinstance(role, str) and role.strip().isalpha():
        return role
    raise ValueError(f"columns: expected what a column says, such as 't' or 'count', found {role!r}")


def _named(role, name):
    """The name of a column, with its sign before it and its unit behind it, so that it is read as one name."""
    if not isinstance(name, str):
        raise _wrong(f"columns: {role}", "the name of a column", name)
    # A time may be in two columns.
    parts = name.split(" + ") if role.strip() == "t" else [name]
    return " + ".join(_quoted(part.strip()) for part in parts)


def _quoted(name):
    closed = all(name.count(a) == name.count(b) for a, b in ("[]", "()"))
    if name and closed and not any(special in name for special in ',"='):
        return name
    sign, stem, unit = _re.fullmatch(r"(-?)(.*?)(\s\[[^\[\]]*\])?", name, _re.DOTALL).groups()
    return '{}"{}"{}'.format(sign, stem.replace('"', '""'), unit or "")


def _range(name, values):
    """A range as text: `0:1:41` as it is, or a list of numbers."""
    if values is None or isinstance(values, str):
        return text(name, values)
    if isinstance(values, (_Real, _Decimal)):
        return spelled(name, values)
    if not isinstance(values, _Iterable) or isinstance(values, (bytes, bytearray)):
        raise _wrong(name, "a range such as '0:1:41', a number, or a list of numbers", values)
    return ",".join(spelled(name, x) for x in values)


def ranges(beta=None, sigma=None, speed=None, vary=None, intervals=None):
    """A grid as the native functions take it."""
    if not isinstance(vary, (_Mapping, type(None))):
        raise _wrong("vary", "a mapping of parameters to ranges", vary)
    if beta is sigma is speed is None and len(vary or {}) not in (2, 3):
        found = f"found {len(vary)} in `vary`" if vary else "found none of them"
        raise SimulationError(f"expected `beta` and `sigma`, or two or three parameters in `vary`, {found}")
    return {
        "beta": _range("beta", beta),
        "sigma": _range("sigma", sigma),
        "speed": _range("speed", speed),
        "vary": [f"{text('vary', key)}={_range(f'vary: {key}', values)}" for key, values in (vary or {}).items()],
        "intervals": how_long(intervals),
    }
