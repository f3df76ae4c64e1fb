"""What the functions of :mod:`passivity` answer: mappings whose fields are attributes too."""

from __future__ import annotations

import hashlib as _hashlib
import html as _html
import json as _json
import os as _os
from array import array as _array

__all__ = ["AuditReport", "Identification", "Record", "Simulation", "SweepResult", "Verdict"]


class Record(dict):
    """A mapping whose fields are attributes too; a table in a notebook.

    >>> Record(verdict="passive").verdict
    'passive'
    """

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"{type(self).__name__} has no field {name!r}") from None

    def __dir__(self):
        return [*super().__dir__(), *(key for key in self if isinstance(key, str))]

    @classmethod
    def from_json(cls, text):
        """Of a JSON document, with records for the objects in it."""
        return cls(_json.loads(text, object_hook=Record))

    def _shown(self):
        """The fields that a table shows."""
        return list(self)

    def _repr_html_(self):
        rows = "".join(
            f"<tr><th style='text-align:left'>{_html.escape(str(key))}</th>"
            f"<td style='text-align:left'>{_cell(self[key])}</td></tr>"
            for key in self._shown()
        )
        return f"{self._picture()}<table>{rows}</table>"

    def _picture(self):
        return ""

    def to_arrow(self):
        """The fields as a table of one row (needs pyarrow): numbers and texts as they are, others as JSON."""
        plain = (str, int, float, bool, type(None))
        row = {
            key: value if isinstance(value, plain) else _json.dumps(value) for key, value in self.items()
        }
        return _pyarrow().Table.from_pylist([row])


def _pyarrow():
    try:
        import pyarrow
    except ImportError:
        raise ImportError("tables of Arrow need pyarrow: pip install pyarrow") from None
    return pyarrow


def _cell(value):
    """A value as a table shows it."""
    if isinstance(value, dict) and set(value) == {"lo", "hi", "approx"}:
        ends = value["lo"] if value["lo"] == value["hi"] else f"{value['lo']} … {value['hi']}"
        near = "" if value["approx"] is None else f" ≈ {value['approx']:.6g}"
        return _html.escape(f"{ends if len(ends) <= 40 else ''}{near}".strip())
    if isinstance(value, dict):
        return "<br>".join(f"{_html.escape(str(key))}: {_cell(inner)}" for key, inner in value.items())
    if isinstance(value, list):
        first = ", ".join(_cell(inner) for inner in value[:10])
        return first + (f", … ({len(value)} in all)" if len(value) > 10 else "")
    text = "–" if value is None else str(value)
    return _html.escape(text if len(text) <= 80 else text[:77] + "…")


class Verdict(Record):
    """What :func:`passivity.check` says of a scene."""

    def _shown(self):
        first = ["scene", "verdict", "region", "because", "beta", "sigma", "spare", "critical_speed"]
        return [key for key in first if key in self] + [key for key in self if key not in first]


class AuditReport(Record):
    """What :func:`passivity.audit` says of a log. ``certificate`` is the first violated interval with all
    that its figures follow from, or ``None``. Where the verdict is ``not_covered``, what is of the force is ``None``:
    ``observer`` and, in ``totals`` and rows, what was generated, net energies and violations."""

    certificate = None

    def _shown(self):
        first = ["verdict", "judged", "samples", "intervals", "totals", "first_violation", "observer", "error"]
        return [key for key in first if key in self] + [
            key for key in self if key not in first and key != "rows"
        ]

    def to_arrow(self):
        """The rows of the ledger of a short log, exact numbers as texts; else the fields as one row."""
        rows = self.get("rows")
        if rows is None:
            return super().to_arrow()
        plain = (str, int, float, bool, type(None))
        table = [
            {key: value if isinstance(value, plain) else _json.dumps(value) for key, value in row.items()}
            for row in rows
        ]
        return _pyarrow().Table.from_pylist(table)


class Identification(Record):
    """What :func:`passivity.identify` says of a device. ``toml`` is the scene that was found, as text, or ``None``
    where a parameter has no bounds, or such as no scene can have; ``picture`` is the SVG of the fit, or ``None``."""

    toml = None
    picture = None

    def _shown(self):
        first = ["parameters", "refuted_by", "informative", "lacks", "samples"]
        return [key for key in first if key in self] + [key for key in self if key not in first]

    def svg(self):
        """What was measured beside what is simulated, what is left, and the parameters that fit, as SVG."""
        return self.picture or ""

    def _picture(self):
        return self.svg()

    def to_arrow(self):
        """The parameters as a table (needs pyarrow): a row for each, with ``lo``, ``hi`` and ``best``."""
        rows = [{"parameter": key, **known} for key, known in self["parameters"].items() if known is not None]
        names = ("parameter", "lo", "hi", "best")
        return _pyarrow().table({name: [row[name] for row in rows] for name in names})


class Simulation(Record):
    """A simulation's report, with its columns as ``columns``."""

    columns: dict = {}

    def svg(self, width=640, height=240):
        """The position against the interval, as SVG."""
        positions = self.columns.get("xi0")
        if positions is None or len(positions) < 2:
            return ""
        step = max(1, len(positions) // 2000)
        points = [(i, float(positions[i])) for i in range(0, len(positions), step)]
        low, high = min(y for _, y in points), max(y for _, y in points)
        span, last = (high - low) or 1.0, points[-1][0] or 1
        line = " ".join(
            f"{40 + (width - 50) * x / last:.1f},{10 + (height - 30) * (high - y) / span:.1f}"
            for x, y in points
        )
        return (
            f"<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{height}' "
            f"viewBox='0 0 {width} {height}' font-family='sans-serif' font-size='11'>"
            f"<rect width='{width}' height='{height}' fill='white'/>"
            f"<polyline points='{line}' fill='none' stroke='#0072b2'/>"
            f"<text x='2' y='16'>{high:.4g}</text><text x='2' y='{height - 18}'>{low:.4g}</text>"
            f"<text x='{width // 2}' y='{height - 4}' text-anchor='middle'>"
            f"position in ticks, against the interval (0 to {last})</text></svg>"
        )

    def _picture(self):
        return self.svg()

    def to_arrow(self):
        """The columns as a table (needs pyarrow)."""
        pyarrow = _pyarrow()
        return pyarrow.table({name: pyarrow.array(values) for name, values in self.columns.items()})


# Colours that are told apart by everyone.
_COLOURS = {
    "at_rest": "#56b4e9",
    "never_at_rest": "#e69f00",
    "growing": "#d55e00",
    "undecided": "#999999",
}


class SweepResult(Record):
    """What a sweep counted, with the file of its points as ``path`` and the names of the axes as ``axes``.

    The points are read from the file when they are first asked for. Where something else is in it by then, as that of
    another sweep, this is a ``ValueError``."""

    path = None
    axes: list = []
    _columns = None
    _hash = None

    @classmethod
    def of_file(cls, report, axes, path):
        """Of a report as JSON, with the file that a sweep has just written."""
        result = cls.from_json(report)
        result.axes, result.path, result._hash = axes, path, _hashed(path)
        return result

    @property
    def columns(self):
        """The columns of the file: names to lists, in the order of the grid."""
        if self._columns is None:
            self._check()
            self._columns = _read(self.path)
        return self._columns

    def _check(self):
        if self._hash is not None and _hashed(self.path) not in (self._hash, None):
            raise ValueError(
                f"{self.path}: this is no longer the file that the sweep wrote: give each sweep a file of its own, "
                "or look at `columns` before another one writes there"
            )

    def svg(self, size=320):
        """The outcomes over the first two axes, at the first value of the third, as SVG."""
        columns = self.columns
        x, y = (columns[name] for name in self.axes[:2])
        third = columns[self.axes[2]] if len(self.axes) > 2 else None
        cells = [
            (x[i], y[i], columns["exact"][i])
            for i in range(len(x))
            if third is None or third[i] == third[0]
        ]
        across, up = sorted({cell[0] for cell in cells}), sorted({cell[1] for cell in cells})
        if len(cells) > 40_000:
            return ""
        places = {value: i for i, value in enumerate(across)}, {value: i for i, value in enumerate(up)}
        w, h = size / len(across), size / len(up)
        rects = "".join(
            f"<rect x='{50 + w * places[0][a]:.2f}' y='{10 + size - h * (places[1][b] + 1):.2f}' "
            f"width='{w + 0.05:.2f}' height='{h + 0.05:.2f}' fill='{_COLOURS[outcome]}'/>"
            for a, b, outcome in cells
        )
        key = "".join(
            f"<rect x='{size + 62}' y='{14 + 18 * i}' width='12' height='12' fill='{colour}'/>"
            f"<text x='{size + 80}' y='{24 + 18 * i}'>{name.replace('_', ' ')}</text>"
            for i, (name, colour) in enumerate(_COLOURS.items())
        )
        words = [_html.escape(name) for name in self.axes[:2]]
        return (
            f"<svg xmlns='http://www.w3.org/2000/svg' width='{size + 180}' height='{size + 40}' "
            f"font-family='sans-serif' font-size='11'>{rects}{key}"
            f"<text x='{50 + size // 2}' y='{size + 30}' text-anchor='middle'>{words[0]}: "
            f"{across[0]:.4g} to {across[-1]:.4g}</text>"
            f"<text transform='translate(30 {10 + size // 2}) rotate(-90)' text-anchor='middle'>"
            f"{words[1]}: {up[0]:.4g} to {up[-1]:.4g}</text></svg>"
        )

    def _picture(self):
        if self.get("points", 0) > 100_000 or self.path is None:
            return ""
        try:
            return self.svg()
        except (OSError, ValueError) as error:
            return f"<p>{_html.escape(str(error))}</p>"

    def to_arrow(self):
        """The points as a table (needs pyarrow)."""
        pyarrow = _pyarrow()
        if self._columns is None and str(self.path).lower().endswith(".parquet"):
            self._check()
            import pyarrow.parquet

            return pyarrow.parquet.read_table(self.path)
        return pyarrow.table(self.columns)


def _hashed(path):
    """What tells the contents of a file from others, or None where there is no file on this machine."""
    if not _os.path.isfile(path):
        return None
    with open(path, "rb") as file:
        return _hashlib.file_digest(file, "sha256").digest()


def _read(path):
    """The columns of a sweep's file."""
    if str(path).lower().endswith(".parquet"):
        pyarrow = _pyarrow()
        import pyarrow.parquet

        return pyarrow.parquet.read_table(path).to_pydict()
    with open(path, encoding="utf-8") as file:
        names = file.readline().rstrip("\n").split(",")
        rows = [line.rstrip("\n").split(",") for line in file]
    columns = {}
    for i, name in enumerate(names):
        cells = [row[i] for row in rows]
        if name in ("paper", "exact"):
            columns[name] = cells
        elif name == "at_interval":
            columns[name] = [int(cell) if cell else None for cell in cells]
        else:
            columns[name] = [float(cell) for cell in cells]
    return columns


def doubles(data):
    """Bytes of doubles as a NumPy array, or as an ``array`` where there is no NumPy."""
    try:
        import numpy
    except ImportError:
        values = _array("d")
        values.frombytes(data)
        return values
    return numpy.frombuffer(data, dtype=numpy.float64)
