"""Measures what an exact audit costs beside sums in doubles: a log of radians with a jittered clock and forces, in
arrays, audited on one core, and the same sums by vectorised NumPy. Prints both times a row and their ratio.

    python bench/rows.py --rows 10000000

The package must be installed with NumPy. NumPy's sums are rounded and say nothing of their error; it is asked for
every figure that the audit reports, for the forces of the log and for those of the wall's law.
"""

import argparse
import json
import time

import numpy
import passivity

COUNTS = 8192
PERIOD = 1e-3
SCENE = {
    "device": {"viscous": "9e-6 N m s/rad", "coulomb": "2e-3 N m"},
    "sampling": {"period": "1 ms"},
    "encoder": {"counts_per_revolution": COUNTS},
    "wall": {"stiffness": "1 N m/rad"},
}
# Of the scene: b/(KT) and c/(KΔ).
TICK = 2 * numpy.pi / COUNTS
BETA, SIGMA = 9e-6 / PERIOD, 2e-3 / TICK
# The audit looks for a delay of the forces of so many samples, or their opposite.
LAGS = 9


def log(rows):
    """Times, positions and forces of a swinging device, the times a few microseconds off the clock."""
    i = numpy.arange(rows + 1)
    times = i * PERIOD + (i % 101 * 41 % 101) * 5e-7
    positions = 0.03 * numpy.sin(8.2 * times) + 0.002 * numpy.sin(141.3 * times)
    return times, positions, -0.2 * numpy.maximum(positions, 0)


def least(nets):
    return [nets.sum(), numpy.cumsum(nets).min(), nets.min(), numpy.count_nonzero(nets < 0)]


def in_doubles(times, positions, forces):
    """The sums of an audit, each by a few vectorised operations."""
    xi, tau, held = positions / TICK, times / PERIOD, forces / TICK
    d = numpy.diff(xi)
    way = numpy.abs(d)
    dissipated = way * (BETA * way / numpy.diff(tau) + SIGMA)
    whole = numpy.floor(xi)
    rho, ticks = xi - whole, numpy.diff(whole)
    own = -(whole[:-1] + 0.5)
    figures = []
    for force in (own, held[:-1]):
        more = (force - own) * d
        linear = dissipated - more - 0.5 * d * (d + 2 * rho[:-1] - 1)
        quantized = dissipated - more - 0.5 * ticks * (ticks + 2 * rho[1:] - 1)
        supplied = -(force * d)
        figures += least(linear) + least(quantized) + least(supplied)[:2]
        figures += [dissipated.sum(), (numpy.cumsum(linear) + 0.5 * xi[1:] ** 2).min()]
    for lag in range(LAGS):
        law, found = own[: len(own) - lag], held[lag:-1]
        near = 1e-6 * numpy.abs(law) + 1e-9
        figures += [(found * law).sum(), (law * law).sum()]
        figures += [numpy.count_nonzero(numpy.abs(found - sign * law) > near) for sign in (1, -1)]
    return figures


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--rows", type=int, default=10_000_000)
    parser.add_argument("--runs", type=int, default=3, help="runs by turns, of which the quickest count")
    asked = parser.parse_args()
    times, positions, forces = log(asked.rows)

    def audit():
        units = {"unit": "rad", "t": times, "t_unit": "s", "f": forces, "f_unit": "N m"}
        return passivity.audit(positions, SCENE, threads=1, **units)

    report = audit()
    assert report["intervals"] == asked.rows
    assert report["totals"]["depends_linear"] == 0, "every row is decided"
    both = [(seconds(audit), seconds(lambda: in_doubles(times, positions, forces))) for _ in range(asked.runs)]
    exact, doubles = map(min, zip(*both))
    figures = {"rows": asked.rows, "audit_ns": 1e9 * exact / asked.rows, "numpy_ns": 1e9 * doubles / asked.rows}
    print(json.dumps({**figures, "ratio": exact / doubles}))


if __name__ == "__main__":
    main()
