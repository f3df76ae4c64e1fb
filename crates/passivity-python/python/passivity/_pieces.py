"""Into which pieces a task is cut.

A whole is one or several parts, each of so many units: a grid is one part of points, every log one of bytes. A
piece ``(part, from, to)`` has the units from one to another of a part. The first pieces are spread over the
whole and small; what they cost says how large the others are. None of them is thrown away.
"""

from __future__ import annotations

# How many pieces a thread is given at first: one is measured while another waits.
FIRST = 3

# How long a piece takes at the least, by what it costs beside its work.
OVERHEADS = 25


def units(pieces):
    """How many units some pieces have."""
    return sum(to - start for _, start, to in pieces)


def gaps(sizes, pieces):
    """What no piece has yet of parts of these sizes."""
    left, at = [], [0] * len(sizes)
    for part, start, to in sorted(pieces):
        if start > at[part]:
            left.append((part, at[part], start))
        at[part] = max(at[part], to)
    left += [(part, at[part], size) for part, size in enumerate(sizes) if at[part] < size]
    return sorted(left)


def even(gaps, count):
    """Every gap in as many pieces, as even as they can be."""
    cuts = []
    for part, start, to in gaps:
        n = max(1, min(count, to - start))
        at = [start + (to - start) * i // n for i in range(n + 1)]
        cuts += [(part, a, b) for a, b in zip(at, at[1:])]
    return cuts


def first(gaps, threads, amount):
    """The first pieces, each of at most so many units: all of it where there is not much."""
    total, count = units(gaps), FIRST * threads
    if total <= 2 * count * amount:
        most = max(1, amount // 16, -(-total // count))
        return [piece for gap in gaps for piece in even([gap], -(-units([gap]) // most))]
    found, before = [], 0
    places = iter([total * i // count for i in range(count)])
    place = next(places)
    for part, start, to in gaps:
        while place is not None and place < before + to - start:
            at = start + place - before
            found.append((part, at, min(to, at + amount)))
            place = next(places, None)
        before += to - start
    return found


def rest(gaps, threads, cost, seconds, overhead):
    """All that is left, the largest pieces first.

    A unit costs so many seconds. A piece takes about ``seconds``, less towards the end, so that no thread
    waits long for another, and no less than makes its ``overhead`` small.
    """
    least = max(1, round(OVERHEADS * overhead / cost))
    most = max(least, round(seconds / cost))
    left, cuts = units(gaps), []
    for part, start, to in gaps:
        while start < to:
            size = min(to - start, max(least, min(most, left // (2 * threads))))
            if to - start - size < least:
                size = to - start
            cuts.append((part, start, start + size))
            start += size
            left -= size
    return sorted(cuts, key=lambda piece: piece[1] - piece[2])
