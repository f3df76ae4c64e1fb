"""The border between outcomes in a plane of two parameters, found without simulating the whole grid.

Cells of a coarse grid are halved where the outcomes at their corners differ, and in the cells around those,
until the cells are those of the grid; at each size the border is followed from cell to cell.
"""

from __future__ import annotations

from .results import Record

__all__ = ["Border", "refine"]

# How large a cell is for those around it to be halved too: always, and where islands do not matter.
_THOROUGH, _QUICK = 2, 8


class Border(Record):
    """The border of a grid: ``points`` that the grid has, ``simulated`` that were needed, ``cells`` with
    different outcomes at their corners. ``outcomes`` maps the index of a point to its outcome."""

    outcomes: dict = {}
    axes: list = []


def refine(shape, evaluate, *, coarse=16, thorough=True):
    """The cells of a grid of ``shape`` points whose corners differ, each as ``(first, second, third)`` indices
    of its lowest corner, and the outcomes that were needed.

    Unless ``thorough``, only cells around large ones are halved: the border takes fewer points, and islands of
    a few cells beside it may be missed. ``evaluate`` gives the outcomes of points by their indices in the grid. A border that lies within one
    coarse cell, touching none of its corners, is not seen: ``coarse`` is how many cells an axis starts with.

    >>> shape = (101, 101, 1)
    >>> def outside(indices):
    ...     return [(i // 101 - 50) ** 2 + (i % 101 - 50) ** 2 > 900 for i in indices]
    >>> cells, outcomes = refine(shape, outside)
    >>> len(cells) > 100, len(outcomes) < 3000
    (True, True)
    """
    across, up, deep = shape
    if across < 2 or up < 2:
        raise ValueError(f"a border needs two values at least on both axes, found {across} and {up}")
    stride = 1
    while 2 * stride * coarse <= max(across, up) - 1:
        stride *= 2
    known = {}

    def index(point):
        first, second, third = point
        return (first * up + second) * deep + third

    def corners(cell, size):
        first, second, third = cell
        right, top = min(first + size, across - 1), min(second + size, up - 1)
        return [(first, second, third), (right, second, third), (first, top, third), (right, top, third)]

    def every(size):
        return {
            (first, second, third)
            for third in range(deep)
            for first in range(0, across - 1, size)
            for second in range(0, up - 1, size)
        }

    cells = every(stride)

    def evaluated(cells):
        """The cells whose corners differ."""
        wanted = {index(corner) for cell in cells for corner in corners(cell, stride)}
        missing = sorted(wanted - known.keys())
        known.update(zip(missing, evaluate(missing), strict=True))
        return {cell for cell in cells if len({known[index(c)] for c in corners(cell, stride)}) > 1}

    def across_edges(cell):
        """The cells on the other side of the edges whose ends differ: the border goes on there."""
        first, second, third = cell
        left_low, right_low, left_high, right_high = (known[index(c)] for c in corners(cell, stride))
        if left_low != right_low and second >= stride:
            yield first, second - stride, third
        if left_high != right_high and second + stride < up - 1:
            yield first, second + stride, third
        if left_low != left_high and first >= stride:
            yield first - stride, second, third
        if right_low != right_high and first + stride < across - 1:
            yield first + stride, second, third

    while True:
        differ, seen, new = set(), set(cells), set(cells)
        while new:
            found = evaluated(new)
            differ |= found
            new = {cell for known_cell in found for cell in across_edges(known_cell)} - seen
            seen |= new
        if stride == 1:
            return sorted(differ), known
        near = set(differ)
        if stride >= (_THOROUGH if thorough else _QUICK):
            # What the corners of a large cell do not show may show beside it.
            near = {
                (first + i * stride, second + j * stride, third)
                for first, second, third in differ
                for i in (-1, 0, 1)
                for j in (-1, 0, 1)
            } & every(stride)
        half = stride // 2
        cells = [
            (first, second, third)
            for first0, second0, third in near
            for first in (first0, first0 + half)
            for second in (second0, second0 + half)
            if first < across - 1 and second < up - 1
        ]
        stride = half
