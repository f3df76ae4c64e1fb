"""Checks a certificate of `passivity audit --certificate`: from its inputs alone, with fractions.

    python3 tests/conformance/passivity_ref.py check-certificate FILE

One of `passivity check --certificate` is handed on to `frequencies`. What a trace leaves open is a box: xi0, xi1 and the force each between two ends, and friction too.
"""

import json
from fractions import Fraction as F
from math import floor

import frequencies
from passivity_ref import Literal, Loop, Refused, above_zero, dissipated, number, whole

FORMAT = "passivity-audit-certificate-1"
PARTS = {
    "": {"format", "scene", "nominal", "loop", "log", "figures"},
    "loop": {"beta", "sigma", "encoder", "delay", "damping", "force_step", "unilateral", "max_force"},
    "log": {"h", "row", "before", "start", "end", "dtau", "force"},
    "figures": {"generated", "dissipated_lower", "extra_storage", "net"},
}


def part(of, name):
    """A section of the certificate, without fields that are not known."""
    section = of.get(name) if name else of
    if not isinstance(section, dict):
        raise Refused(f"`{name}` is not an object")
    unknown = set(section) - PARTS[name]
    if unknown:
        raise Refused(f"unknown field {sorted(unknown)[0]}")
    return section


def ends(value):
    """The two ends of a number that is exact or enclosed."""
    if not isinstance(value, dict):
        return number(value), number(value)
    if set(value) != {"lo", "hi"}:
        raise Refused("an enclosure has two ends, lo and hi")
    lo, hi = number(value["lo"]), number(value["hi"])
    if lo > hi:
        raise Refused("an enclosure has its ends the wrong way round")
    return lo, hi


def position(value, encoder):
    if not isinstance(value, dict) or len(value) != 1:
        raise Refused("a position is either a count or xi")
    if "count" in value:
        if not encoder:
            raise Refused("a count without an encoder")
        n = whole(value["count"])
        return F(n), F(n + 1)
    lo, hi = ends(value.get("xi"))
    if lo != hi and not encoder:
        raise Refused("an enclosed position without an encoder is not in this implementation")
    if hi > floor(lo) + 1:
        raise Refused("an enclosed position lies within one tick")
    return lo, hi


def storage_gained(loop, samples):
    """What the storages of delay and damping gain: each rises with every |d|, so the ends of the
    displacements, each on its own, give those of the storages."""
    least, most = [F(0)], [F(0)]
    for (a, b), (c, d) in zip(samples, samples[1:]):
        least.append(least[-1] + max(c - b, a - d, F(0)))
        most.append(most[-1] + max(abs(d - a), abs(c - b)))
    after = [loop.stored(path) for path in (least, most)]
    before = [loop.stored(path[:-1]) for path in (least, most)]
    if all(lo == hi for lo, hi in samples):
        return after[0] - before[0], after[1] - before[1]
    return after[0] - before[1], after[1] - before[0]


def generated_between(loop, start, end, force):
    """Of g(xi1) - g(xi0) with g = force xi + V(xi), convex: its largest value is at an end, its
    least there or where V' = -force."""
    ranges = []
    for held in force:
        g = lambda xi: held * xi + loop.potential(xi)
        extremes = []
        for lo, hi in (start, end):
            values = [g(xi) for xi in (lo, hi, min(max(-held, lo), hi))]
            extremes.append((min(values), max(values)))
        (least0, most0), (least1, most1) = extremes
        ranges.append((least1 - most0, most1 - least0))
    return min(lo for lo, _ in ranges), max(hi for _, hi in ranges)


def on_edge(at, turns):
    """The extremes for s in [0, 1] of a function made of parabolas that meet at `turns`."""
    values = []
    stops = sorted({F(0), F(1), *(turn for turn in turns if 0 < turn < 1)})
    for lo, hi in zip(stops, stops[1:]):
        y0, y1, y2 = at(lo), at((lo + hi) / 2), at(hi)
        values += [y0, y2]
        c2, c1 = 2 * (y0 - 2 * y1 + y2), 4 * y1 - 3 * y0 - y2
        if c2 and 0 < -c1 / (2 * c2) < 1:
            values.append(at(lo - c1 / (2 * c2) * (hi - lo)))
    return min(values), max(values)


def net_between(loop, frictions, start, end, force, dtau):
    """Of beta d^2/dtau + sigma |d| - generated, against the law of the wall. Along a line of equal d its slope is
    V'(xi0) - V'(xi1), of one sign as V is convex, so its extremes are on the edge of the square of positions; there it is
    made of parabolas that meet where d is zero and where the law is bent."""
    bends = [F(0)] if loop.unilateral else []
    if loop.limit is not None:
        bends += [-loop.limit, loop.limit]
    found = []
    corners = [(start[i], end[j]) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    for held in force:
        for (a, c), (b, d) in zip(corners, corners[1:] + corners[:1]):
            for beta, sigma in frictions:
                def at(s):
                    xi0, xi1 = a + s * (b - a), c + s * (d - c)
                    step = xi1 - xi0
                    gained = held * step + loop.potential(xi1) - loop.potential(xi0)
                    return dissipated(beta, sigma, step, dtau) - gained
                change = (d - b) - (c - a)
                turns = [(a - c) / change] if change else []
                turns += [(bend - from_) / (to - from_)
                          for from_, to in ((a, b), (c, d)) if to != from_ for bend in bends]
                found.append(on_edge(at, turns))
    return min(lo for lo, _ in found), max(hi for _, hi in found)


def recomputed(certificate):
    """The figures of the row from the loop and the log; nothing else of the certificate is read."""
    terms, log = dict(part(certificate, "loop")), part(certificate, "log")
    (beta, sigma) = (ends(terms.get(key)) for key in ("beta", "sigma"))
    # The loop itself is with the least friction; both ends of it are accounted for below.
    loop = Loop({**terms, "beta": str(beta[0]), "sigma": str(sigma[0])})
    if not isinstance(log.get("before"), list):
        raise Refused("`before` is not a list")
    given = [*log["before"], log.get("start"), log.get("end")]
    samples = [position(value, loop.encoder) for value in given]
    h, memory = whole(log.get("h")), loop.delay + (loop.damping is not None)
    if h < 0 or whole(log.get("row")) != h + 1:
        raise Refused("the interval h starts at row h + 1")
    if len(log["before"]) != min(h, memory + 1 if memory else 0):
        raise Refused("`before` does not have the samples that delay and damping depend on")
    dtau, (start, end) = above_zero(log.get("dtau")), samples[-2:]
    if "force" in log:
        force = ends(log["force"])
    else:
        # The encoder gives the same for all of a tick.
        force = (loop.held([lo for lo, _ in samples[:-1]]),) * 2
    nearest = max(end[0] - start[1], start[0] - end[1], F(0))
    farthest = max(end[1] - start[0], start[1] - end[0])
    spent = tuple(dissipated(beta[i], sigma[i], d, dtau) for i, d in enumerate((nearest, farthest)))
    generated = generated_between(loop, start, end, force)
    net = net_between(loop, tuple(zip(beta, sigma)), start, end, force, dtau)
    figures = {"generated": generated, "dissipated_lower": spent}
    # What delay and damping store pays for the force of the law, not for one that was applied.
    if memory and "force" not in log:
        extra = figures["extra_storage"] = storage_gained(loop, samples)
        net = net[0] - extra[1], net[1] - extra[0]
    return {**figures, "net": net}


def check_certificate(text):
    """A sentence that says what was found; `Refused` when the certificate is not right."""
    def constant(name):
        raise Refused(f"{name} is not a number")
    certificate = json.loads(text, parse_int=Literal, parse_float=Literal, parse_constant=constant)
    if isinstance(certificate, dict) and certificate.get("format") == frequencies.FORMAT:
        return frequencies.check(certificate, number, whole)
    if not isinstance(certificate, dict) or certificate.get("format") != FORMAT:
        raise Refused(f"not a certificate of the format {FORMAT} or {frequencies.FORMAT}")
    stated, own = part(part(certificate, ""), "figures"), recomputed(certificate)
    if set(stated) != set(own):
        raise Refused(f"the figures of this row are {', '.join(own)}")
    show = lambda x: str(x[0]) if x[0] == x[1] else f"{x[0]} … {x[1]}"
    for name, figure in own.items():
        if ends(stated[name]) != figure:
            raise Refused(f"{name} is {show(figure)}, and the certificate says {show(ends(stated[name]))}")
    if own["net"][1] >= 0:
        raise Refused(f"this row need not be violated: its net energy may be {own['net'][1]}")
    stored = ", less what delay and damping stored" if "extra_storage" in own else ""
    return f"The violation is real: the net energy of row {certificate['log']['row']} is {show(own['net'])} KΔ²{stored}."
