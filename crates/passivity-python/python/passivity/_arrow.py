"""Columns of numbers through Arrow's C data interface, read where they are."""

from __future__ import annotations

import ctypes as _c
import struct as _struct
from array import array as _array
from itertools import islice as _islice


class _Schema(_c.Structure):
    _fields_ = [
        ("format", _c.c_char_p),
        ("name", _c.c_char_p),
        ("metadata", _c.c_void_p),
        ("flags", _c.c_int64),
        ("n_children", _c.c_int64),
        ("children", _c.c_void_p),
        ("dictionary", _c.c_void_p),
        ("release", _c.c_void_p),
        ("private_data", _c.c_void_p),
    ]


class _Array(_c.Structure):
    _fields_ = [
        ("length", _c.c_int64),
        ("null_count", _c.c_int64),
        ("offset", _c.c_int64),
        ("n_buffers", _c.c_int64),
        ("n_children", _c.c_int64),
        ("buffers", _c.POINTER(_c.c_void_p)),
        ("children", _c.c_void_p),
        ("dictionary", _c.c_void_p),
        ("release", _c.c_void_p),
        ("private_data", _c.c_void_p),
    ]


class _Stream(_c.Structure):
    pass


_Stream._fields_ = [
    ("get_schema", _c.CFUNCTYPE(_c.c_int, _c.POINTER(_Stream), _c.POINTER(_Schema))),
    ("get_next", _c.CFUNCTYPE(_c.c_int, _c.POINTER(_Stream), _c.POINTER(_Array))),
    ("get_last_error", _c.CFUNCTYPE(_c.c_char_p, _c.POINTER(_Stream))),
    ("release", _c.c_void_p),
    ("private_data", _c.c_void_p),
]

_pointer = _c.pythonapi.PyCapsule_GetPointer
_pointer.restype = _c.c_void_p
_pointer.argtypes = [_c.py_object, _c.c_char_p]


class _Half(_c.Structure):
    """A float of 16 bits, which ctypes has no type for."""

    _fields_ = [("bits", _c.c_uint16)]


# How many numbers are copied at once, in a few milliseconds.
BLOCK = 1 << 16

# By Arrow's format: the type in memory, and whether it is of whole numbers.
_TYPES = {
    b"c": (_c.c_int8, True),
    b"C": (_c.c_uint8, True),
    b"s": (_c.c_int16, True),
    b"S": (_c.c_uint16, True),
    b"i": (_c.c_int32, True),
    b"I": (_c.c_uint32, True),
    b"l": (_c.c_int64, True),
    b"L": (_c.c_uint64, True),
    b"e": (_Half, False),
    b"f": (_c.c_float, False),
    b"g": (_c.c_double, False),
}


def is_arrow(values):
    """Whether an object hands out Arrow arrays."""
    return hasattr(values, "__arrow_c_array__") or hasattr(values, "__arrow_c_stream__")


def numbers(values, name):
    """The numbers of an Arrow array or a stream of them, and whether they are whole.

    One array of 64-bit numbers is read where it is; others are copied into one.
    """
    if hasattr(values, "__arrow_c_array__"):
        schema, column = values.__arrow_c_array__()
        kind = _kind(_at(schema, b"arrow_schema", _Schema), name)
        part = _part(_at(column, b"arrow_array", _Array), kind[0], name)
        return _whole([part], kind, (schema, column), name)
    capsule = values.__arrow_c_stream__()
    stream = _at(capsule, b"arrow_array_stream", _Stream)
    schema, kept = _Schema(), _Kept()
    _checked(stream, stream.get_schema(_c.byref(stream), _c.byref(schema)), name)
    kept.structures.append(schema)
    kind = _kind(schema, name)
    parts = []
    while True:
        column = _Array()
        _checked(stream, stream.get_next(_c.byref(stream), _c.byref(column)), name)
        if not column.release:
            break
        kept.structures.append(column)
        parts.append(_part(column, kind[0], name))
    return _whole(parts, kind, kept, name)


class _Kept:
    """What a stream gave, given back when nobody reads it any more."""

    def __init__(self):
        self.structures = []

    def __del__(self):
        for structure in self.structures:
            _release(structure)


def _release(structure):
    if structure.release:
        _c.CFUNCTYPE(None, _c.c_void_p)(structure.release)(_c.addressof(structure))


def _at(capsule, name, structure):
    return structure.from_address(_pointer(capsule, name))


def _checked(stream, code, name):
    if code != 0:
        said = stream.get_last_error(_c.byref(stream))
        raise ValueError(f"{name}: {said.decode(errors='replace') if said else f'error {code}'}")


def _kind(schema, name):
    kind = _TYPES.get(schema.format)
    if kind is None or schema.dictionary:
        raise ValueError(f"{name}: expected numbers, found Arrow's {schema.format.decode()!r}")
    return kind


def _part(column, kind, name):
    """The memory of one array."""
    if column.null_count != 0 and column.n_buffers > 0 and column.buffers[0]:
        valid = (_c.c_uint8 * ((column.offset + column.length + 7) // 8)).from_address(column.buffers[0])
        for i in range(column.offset, column.offset + column.length):
            if not valid[i // 8] >> (i % 8) & 1:
                raise ValueError(f"{name}: row {i - column.offset + 1} has no value")
    if column.length == 0:
        return b""
    start = column.buffers[1] + column.offset * _c.sizeof(kind)
    return (kind * column.length).from_address(start)


def _whole(parts, kind, owner, name):
    """One buffer of 64-bit numbers."""
    type_, whole = kind
    code = "q" if whole else "d"
    if len(parts) == 1 and type_ in (_c.c_int64, _c.c_double) and len(parts[0]):
        parts[0]._owner = owner
        return memoryview(parts[0]).cast("B").cast(code), whole
    joined = _array(code)
    for part in parts:
        if type_ in (_c.c_int64, _c.c_double):
            joined.frombytes(memoryview(part).cast("B"))
        elif type_ is _Half:
            joined.extend(_struct.unpack(f"{len(part)}e", part))
        elif len(part):
            extend(joined, part, name)
    return joined, whole


def extend(column, values, name):
    """Adds numbers to an array; an error has the row of one that does not fit. Between blocks of them other threads
    run, and an interrupt ends it."""
    values, before = iter(values), -1
    try:
        while len(column) > before:
            before = len(column)
            column.extend(_islice(values, BLOCK))
    except (OverflowError, TypeError) as error:
        if column.typecode == "q" and isinstance(error, OverflowError):
            error = "expected an integer from -2**63 to 2**63 - 1"
        raise ValueError(f"{name}: row {len(column) + 1}: {error}") from None
