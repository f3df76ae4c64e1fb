"""The border between outcomes in a plane of two parameters, found without simulating the whole grid.

Cells of a coarse grid are halved where the outcomes at their corners differ, and in the cells around those,
until the cells are those of the grid.
"""

from __future__ import annotations

from .results import Record

__all__ = ["Border", "refine"]


class Border(Record):
    """The border of a grid: ``points`` that the grid has, ``simulated`` that were needed, ``cells`` with
    different outcomes at their corners. ``outcomes`` maps the index of a point to its outcome."""

    outcomes: dict = {}
    axes: list = []


def refine(shape, evaluate, *, coarse=16):
    """The cells of a grid of ``shape`` points whose corners differ, each as ``(first, second, third)`` indices
    of its lowest corner, and the outcomes that were needed.

    ``evaluate`` gives the outcomes of points by their indices in the grid. A border that lies within one
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

    cells = [
        (first, second, third)
        for third in range(deep)
        for first in range(0, across - 1, stride)
        for second in range(0, up - 1, stride)
    ]
    while True:
        missing = sorted({index(corner) for cell in cells for corner in corners(cell, stride)} - known.keys())
        known.update(zip(missing, evaluate(missing), strict=True))
        differ = {
            cell for cell in cells if len({known[index(corner)] for corner in corners(cell, stride)}) > 1
        }
        if stride == 1:
            return sorted(differ), known
        near = {
            (first + i * stride, second + j * stride, third)
            for first, second, third in differ
            for i in (-1, 0, 1)
            for j in (-1, 0, 1)
        }
        half = stride // 2
        cells = [
            (first, second, third)
            for first0, second0, third in cells
            if (first0, second0, third) in near
            for first in (first0, first0 + half)
            for second in (second0, second0 + half)
            if first < across - 1 and second < up - 1
        ]
        stride = half
