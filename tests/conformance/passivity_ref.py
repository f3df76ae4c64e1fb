#!/usr/bin/env python3
"""A second implementation of the passivity ledger, from its equations alone.

It answers the line protocol of `passivity oracle` on standard input and output, with exact
fractions from the standard library, and shares no code with the Rust one. Run against the vectors:

    passivity vectors --against 'python3 tests/conformance/passivity_ref.py'

With `check-certificate FILE` it checks what `passivity audit --certificate FILE` or `passivity check
--certificate FILE` wrote: exit code 0 when all of it is right, 1 when it is not. With `check-witnesses FILE` it
computes again what every motion gains that a file of vectors calls a witness.

Numbers in round brackets are equations of the paper (Diolaiti, Niemeyer, Barbagli, Salisbury, "A
Criterion for the Passivity of Haptic Devices"); ids such as TH-LIN are claims of this project.
"""

import json
import re
import sys
from fractions import Fraction as F
from functools import cached_property
from math import floor

sys.dont_write_bytecode = True
import drawn
from costs import HALF, Costs, Refused, controller, damped

NUMBER = re.compile(r"[+-]?(?:[0-9]+/[0-9]+|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)", re.ASCII)
MOST = 4096  # characters of a number, and its largest decimal exponent


class Literal(str):
    """A JSON number, kept as the decimal it spells."""


# --- numbers ---------------------------------------------------------------------------------


def number(value):
    """An exact number from a string or a JSON number."""
    if not isinstance(value, str):
        raise Refused(f"expected a number, found {value!r}")
    if len(value) > MOST or not NUMBER.fullmatch(value):
        raise Refused(f"no number: {value[:40]!r}")
    if "/" in value:
        n, d = value.split("/")
        if int(d) == 0:
            raise Refused("denominator zero")
        return F(int(n), int(d))
    mantissa, _, exponent = value.lower().partition("e")
    exponent = int(exponent or "0")
    if abs(exponent) > MOST:
        raise Refused("exponent too large")
    whole, _, decimals = mantissa.partition(".")
    digits = int((whole + decimals).lstrip("+-") or "0")
    x = F(digits) * F(10) ** (exponent - len(decimals))
    return -x if mantissa.startswith("-") else x


def at_least_zero(value):
    x = number(value)
    if x < 0:
        raise Refused("below zero")
    return x


def above_zero(value):
    x = number(value)
    if x <= 0:
        raise Refused("not above zero")
    return x


def whole(value):
    x = number(value)
    if x.denominator != 1:
        raise Refused("not a whole number")
    return int(x)


def span(lo, hi):
    """A figure of which an enclosure is known: both its ends."""
    return {"lo": str(lo), "hi": str(hi)}


def truth(worst_holds, best_holds):
    return True if worst_holds else (None if best_holds else False)


def less(x, cost):
    """x less a cost of which an enclosure is known."""
    return x - cost[1], x - cost[0]


# --- one interval between exact positions ------------------------------------------------------


def tick(xi):
    return floor(xi)


def rho(xi):
    return xi - floor(xi)


def dissipated(beta, sigma, d, dtau):
    """The least that friction takes, (26)."""
    return beta * d * d / dtau + sigma * abs(d)


def bound_22(d):
    return HALF * d * d + HALF * abs(d)


def bound_quantized(d):
    """TH-QUANT."""
    f = rho(abs(d))
    return bound_22(d) + HALF * f * (1 - f)


class Loop:
    """Friction and effects; the force law of the wall and its two potentials."""

    def __init__(self, request):
        self.beta = at_least_zero(request.get("beta"))
        self.sigma = at_least_zero(request.get("sigma"))
        self.encoder = flag(request, "encoder", True)
        self.unilateral = flag(request, "unilateral", False)
        self.delay = whole(request.get("delay", Literal("0")))
        if not 0 <= self.delay <= 1000:
            raise Refused("delay: a whole number of samples")
        optional = lambda key, read: read(request[key]) if key in request else None
        self.damping = optional("damping", at_least_zero)
        self.step = optional("force_step", above_zero)
        self.limit = optional("max_force", above_zero)

    def plain(self):
        return (self.encoder and not self.delay and self.damping is None and self.step is None
                and not self.clamped())

    def clamped(self):
        return self.unilateral or self.limit is not None

    def law(self, x):
        """f: the wall's restoring force at x, without its sign."""
        if self.unilateral:
            x = max(x, F(0))
        if self.limit is not None:
            x = max(min(x, self.limit), -self.limit)
        return x

    def potential(self, xi):
        """The integral of f from 0 to xi: quadratic up to the limit, linear beyond."""
        if self.unilateral and xi < 0:
            return F(0)
        x = abs(xi)
        if self.limit is not None and x > self.limit:
            return HALF * self.limit**2 + (x - self.limit) * self.limit
        return HALF * x * x

    def steps_potential(self, xi):
        """The integral of f(floor(x) + 1/2): tick by tick, as it is defined."""
        if not self.encoder:
            return self.potential(xi)
        n, total = tick(xi), F(0)
        if not self.clamped():
            return HALF * n * n + rho(xi) * (n + HALF)  # (16) at whole ticks, then a straight line
        for k in range(0, n):
            total += self.law(k + HALF)
        for k in range(n, 0):
            total -= self.law(k + HALF)
        return total + rho(xi) * self.law(n + HALF)

    def sample(self, xi):
        return tick(xi) + HALF if self.encoder else xi

    def held(self, history):
        """The force from the samples so far, the latest last."""
        late = [history[0]] * (self.delay + 2) + history
        q, before = self.sample(late[-1 - self.delay]), self.sample(late[-2 - self.delay])
        u = q + (self.damping * (q - before) if self.damping is not None else 0)
        if self.unilateral and q < 0:
            u = F(0)
        u = -u
        if self.step is not None:
            u = self.step * floor(u / self.step + HALF)
        if self.limit is not None:
            u = max(min(u, self.limit), -self.limit)
        return u

    @cached_property
    def criterion(self):
        """The two coefficients of the criterion, with what the effects take: enclosures."""
        law = damped(self.damping or F(0), F(0))
        costs = Costs(law, self.delay, not self.clamped(), None, self.encoder, self.step or F(0))
        return less(self.beta, costs.viscous), less(self.sigma, costs.coulomb)

    def stored(self, history):
        """Extra storage of delay and damping after the latest of these positions."""
        steps = [b - a for a, b in zip(history, history[1:])][::-1]
        k = self.delay
        total = sum((F(k - j + 1) * d * d / 2 for j, d in enumerate(steps[:k], 1)), F(0))
        if self.damping is not None:
            total += self.damping / 2 * sum((d * d for d in steps[: k + 1]), F(0))
        return total

    def row(self, h, history, xi1, dtau):
        xi0 = history[-1]
        d = xi1 - xi0
        held = self.held(history)
        # (18): what the held force does beyond the potential of its counterpart.
        linear = held * d + self.potential(xi1) - self.potential(xi0)
        quantized = held * d + self.steps_potential(xi1) - self.steps_potential(xi0)
        spent = dissipated(self.beta, self.sigma, d, dtau)
        extra = self.stored(history + [xi1]) - self.stored(history)
        net_linear, net_quantized = spent - linear - extra, spent - quantized - extra
        # (8); an enclosure where what a delay with damping costs is no fraction.
        margin = [v + c * dtau / abs(d) for v, c in zip(*self.criterion)] if d else None
        row = {
            "h": h, "xi0": str(xi0), "xi1": str(xi1), "dtau": str(dtau),
            "generated_linear": str(linear), "generated_quantized": str(quantized),
            "bound_22": str(bound_22(d) if self.encoder else d * d / 2),
            "bound_quantized": str(bound_quantized(d) if self.encoder else d * d / 2),
            "dissipated_lower": str(spent), "net_linear": str(net_linear),
            "net_quantized": str(net_quantized),
            "margin": margin and (str(margin[0]) if margin[0] == margin[1] else span(*margin)),
            "criterion_holds": margin is None or truth(margin[0] >= 0, margin[1] >= 0),
            "violates_linear": net_linear < 0, "violates_quantized": net_quantized < 0,
        }
        if self.delay or self.damping is not None:
            row["extra_storage"] = str(extra)
        return row, [(x, x) for x in (linear, quantized, spent, net_linear, net_quantized)]

    # --- one interval of counts ------------------------------------------------------------------

    def counted_row(self, h, n0, n1, dtau):
        """All that is known is u = rho1 and w = rho0 in [0, 1); figures over the closed square."""
        if not self.plain():
            raise Refused("counts with effects are not in this implementation")
        ticks, a, sigma = F(n1 - n0), self.beta / dtau, self.sigma
        least = max(F(0), abs(ticks) - 1)
        most = abs(ticks) + 1 if ticks else F(1)
        # E_g^L = ((D + u - 1/2)^2 - (w - 1/2)^2)/2: two squares, each to its extremes.
        ends = ((ticks - HALF) ** 2, (ticks + HALF) ** 2)
        nearest = F(0) if ticks == 0 else min(ends)
        linear = (nearest / 2 - F(1, 8), max(ends) / 2)
        quantized = (HALF * ticks**2 - HALF * abs(ticks), HALF * ticks**2 + HALF * abs(ticks))
        spent = tuple(dissipated(self.beta, sigma, d, dtau) for d in (least, most))

        def extremes(generated):
            """Of a d^2 + sigma |d| - generated(u, w): on the edge of the square, and on each side
            a parabola in the residue that moves, since |d| has one sign there."""
            values = []
            for side in range(4):
                def at(s, side=side):
                    u, w = ((s, F(0)), (s, F(1)), (F(0), s), (F(1), s))[side]
                    d = ticks + u - w
                    return a * d * d + sigma * abs(d) - generated(u, w)
                y0, y1, y2 = at(F(0)), at(HALF), at(F(1))
                values += [y0, y2]
                # Through three points: y = c2 s^2 + c1 s + y0.
                c2, c1 = 2 * (y0 - 2 * y1 + y2), 4 * y1 - 3 * y0 - y2
                if c2 and 0 < -c1 / (2 * c2) < 1:
                    values.append(at(-c1 / (2 * c2)))
            return min(values), max(values)

        net_linear = extremes(
            lambda u, w: HALF * (ticks + u - HALF) ** 2 - HALF * (w - HALF) ** 2)
        net_quantized = extremes(lambda u, w: HALF * ticks**2 + ticks * (u - HALF))
        viscous, coulomb = (coefficient[0] for coefficient in self.criterion)
        speeds = [least / dtau, most / dtau]
        times_speed = [viscous * v + coulomb for v in speeds]
        holds = truth(min(times_speed) >= 0, max(times_speed) >= 0)
        if holds is False and least == 0:
            holds = None  # perhaps nothing moved
        at = [None if v == 0 and coulomb else viscous + (coulomb / v if v else 0) for v in speeds]
        lo, hi = (at[0], at[1]) if coulomb <= 0 else (at[1], at[0])
        text = lambda x: None if x is None else str(x)
        row = {
            "h": h, "xi0": span(F(n0), F(n0 + 1)), "xi1": span(F(n1), F(n1 + 1)),
            "dtau": str(dtau),
            "generated_linear": span(*linear), "generated_quantized": span(*quantized),
            "bound_22": span(bound_22(least), bound_22(most)),
            "bound_quantized": span(bound_quantized(least), bound_quantized(most)),
            "dissipated_lower": span(*spent),
            "net_linear": span(*net_linear), "net_quantized": span(*net_quantized),
            "margin": {"lo": text(lo), "hi": text(hi)},
            "criterion_holds": holds,
            "violates_linear": violated(net_linear), "violates_quantized": violated(net_quantized),
        }
        return row, [linear, quantized, spent, net_linear, net_quantized]


def violated(net):
    return True if net[1] < 0 else (None if net[0] < 0 else False)


def flag(request, key, otherwise):
    value = request.get(key, otherwise)
    if not isinstance(value, bool):
        raise Refused(f"{key}: expected true or false")
    return value


# --- operations --------------------------------------------------------------------------------

LOOP = {"beta", "sigma", "encoder", "delay", "damping", "force_step", "unilateral", "max_force"}


def only(request, known):
    unknown = set(request) - known - {"id", "op"}
    if unknown:
        raise Refused(f"unknown field {sorted(unknown)[0]}")


def interval(request):
    counted = "count0" in request or "count1" in request
    names = ("count0", "count1") if counted else ("xi0", "xi1")
    only(request, LOOP | {"h", "dtau", *names})
    loop, dtau = Loop(request), above_zero(request.get("dtau", "1"))
    h = whole(request.get("h", "0"))
    read = whole if counted else number
    start, end = read(request.get(names[0])), read(request.get(names[1]))
    if counted:
        return loop.counted_row(h, start, end, dtau)[0]
    return loop.row(h, [start], end, dtau)[0]


def run(request):
    only(request, LOOP | {"dtau", "xi", "positions", "count", "counts"})
    lists = [key for key in ("xi", "positions", "count", "counts") if key in request]
    if len(lists) != 1 or not isinstance(request[lists[0]], list):
        raise Refused("expected one list of positions or counts")
    counted = lists[0].startswith("count")
    points = [(whole if counted else number)(x) for x in request[lists[0]]]
    if len(points) < 2:
        raise Refused("expected at least two positions")
    dtau = request.get("dtau", "1")
    if isinstance(dtau, list):
        if len(dtau) != len(points) - 1:
            raise Refused("expected one dtau for each interval")
        dtau = [above_zero(x) for x in dtau]
    else:
        dtau = [above_zero(dtau)] * (len(points) - 1)
    loop, rows, figures = Loop(request), [], []
    for h, step in enumerate(dtau):
        if counted:
            row, sums = loop.counted_row(h, points[h], points[h + 1], step)
        else:
            row, sums = loop.row(h, points[: h + 1], points[h + 1], step)
        rows.append(row)
        figures.append(sums)
    total = [(sum(f[i][0] for f in figures), sum(f[i][1] for f in figures)) for i in range(5)]
    if counted:
        # Over the run each inner residue enters the linear total as D rho, the first as
        # -(rho - 1/2)^2/2 and the last as (D + rho - 1/2)^2/2: the total's own extremes.
        last = figures[-1][0]
        inner = [f[1] for f in figures[:-1]]
        total[0] = (sum(x[0] for x in inner) + last[0], sum(x[1] for x in inner) + last[1])
        for net, generated in ((3, 0), (4, 1)):
            lo = max(total[net][0], total[2][0] - total[generated][1])
            hi = min(total[net][1], total[2][1] - total[generated][0])
            total[net] = (lo, hi)
    names = ("generated_linear", "generated_quantized", "dissipated_lower", "net_linear",
             "net_quantized")
    shown = span if counted else lambda lo, hi: str(lo)
    totals = {"intervals": len(rows), **{n: shown(*t) for n, t in zip(names, total)}}
    count = lambda key, value: sum(row[key] is value for row in rows)
    first = lambda key: next((row["h"] for row in rows if row[key] is True), None)
    totals.update(
        criterion_fails=count("criterion_holds", False),
        criterion_depends=count("criterion_holds", None),
        violates_linear=count("violates_linear", True),
        depends_linear=count("violates_linear", None),
        violates_quantized=count("violates_quantized", True),
        depends_quantized=count("violates_quantized", None),
        first_linear=first("violates_linear"), first_quantized=first("violates_quantized"),
    )
    return {"rows": rows, "totals": totals}


def motion(request):
    """Constant force, one direction: v' = a - lambda v, solved with e^(-lambda t) itself."""
    only(request, {"mu", "beta", "sigma", "xi", "velocity", "force", "tau"})
    mu, beta, sigma = above_zero(request.get("mu")), *(at_least_zero(request.get(k)) for k in ("beta", "sigma"))
    xi, v, u = (number(request.get(k)) for k in ("xi", "velocity", "force"))
    t = at_least_zero(request.get("tau"))
    if v == 0 or beta * t / mu > 1:
        raise Refused("not one piece of motion")
    a, rate = (u - (sigma if v > 0 else -sigma)) / mu, beta / mu
    if rate == 0:
        end, at = v + a * t, xi + v * t + a * t * t / 2
    else:
        z, decay, term = rate * t, F(0), F(1)
        for k in range(1, 60):  # 1/60! is far below every digit that is compared
            decay += term
            term = -term * z / k
        limit = a / rate
        end = limit + (v - limit) * decay
        at = xi + limit * t + (v - limit) * (1 - decay) / rate
        end, at = (F(round(x * 10**45), 10**45) for x in (end, at))
    if end * v < 0:
        raise Refused("the motion turns round")
    return {"xi": str(at), "velocity": str(end)}


# --- verdicts ------------------------------------------------------------------------------------

SECTIONS = {
    "dimensionless": {"mu", "beta", "sigma"}, "sampling": {"delay", "latency"},
    "wall": {"unilateral", "damping", "damping_time_constant", "max_force", "force_step"},
    "controller": {"numerator", "denominator"},
    "amplifier": {"time_constant"}, "operator": {"max_speed"}, "start": {"position", "velocity"},
}


def read_scene(scene):
    """The costs of a scene's effects, and what a motion meets in it."""
    if not isinstance(scene, dict) or set(scene) - set(SECTIONS) or "dimensionless" not in scene:
        raise Refused("not a scene that this implementation knows")
    for name, section in scene.items():
        if not isinstance(section, dict) or set(section) - SECTIONS[name]:
            raise Refused(f"[{name}] has a key that is not known")
    point, wall, sampling = (scene.get(k, {}) for k in ("dimensionless", "wall", "sampling"))
    plain = {k: v for k, v in {**point, **wall, **sampling}.items()
             if k not in ("mu", "damping_time_constant", "latency")}
    loop = Loop(plain)
    if "controller" in scene:
        if loop.damping is not None:
            raise Refused("damping and a controller cannot both be given")
        lists = [scene["controller"].get("numerator"), scene["controller"].get("denominator", ["1"])]
        if not all(isinstance(x, list) for x in lists):
            raise Refused("a controller is two lists of numbers")
        law = controller(*([number(x) for x in numbers] for numbers in lists))
    else:
        tau = at_least_zero(wall.get("damping_time_constant", "0"))
        law = damped(loop.damping or F(0), tau / (1 + tau))
    late = at_least_zero(sampling.get("latency", "0"))
    lag = at_least_zero(scene["amplifier"].get("time_constant")) if "amplifier" in scene else F(0)
    actuator = (late, lag) if late or lag else None
    costs = Costs(law, loop.delay, not loop.clamped(), actuator, loop.encoder, loop.step or F(0))
    return costs, drawn.Loop(law, loop.delay, (loop.beta, loop.sigma), loop.encoder, loop.unilateral,
                             loop.step, loop.limit, actuator)


def speed_bound(scene):
    operator = scene.get("operator", {})
    return above_zero(operator["max_speed"]) if "max_speed" in operator else None


def sign_of(span, holds):
    """The sign of a figure of which an enclosure is known, and whether it is not below zero."""
    if span[0] == span[1] == 0:
        return 0
    return 1 if holds else -1


def check(request):
    only(request, {"scene"})
    scene = request.get("scene")
    costs, loop = read_scene(scene)
    beta, sigma = loop.beta, loop.sigma
    viscous, coulomb = less(beta, costs.viscous), less(sigma, costs.coulomb)
    if coulomb[0] < 0 <= coulomb[1] and coulomb[0] != coulomb[1]:
        raise Refused("too close to the border for this implementation")
    v, c = sign_of(viscous, costs.enough(beta)), sign_of(coulomb, coulomb[0] >= 0)
    # TH-REGION: the speeds v > 0 with viscous v + coulomb >= 0.
    if v >= 0 and c >= 0:
        region = "globally_stable"
    elif v < 0 < c:
        region = "locally_stable"
    elif c < 0 < v:
        region = "limit_cycles"
    else:
        region = "unstable"
    critical = None
    if region in ("locally_stable", "limit_cycles"):
        ends = [-a / b for a in coulomb for b in viscous if b]
        critical = min(ends), max(ends)
    bound = speed_bound(scene)
    if bound is None:
        holds = region == "globally_stable"
    else:
        holds = costs.holds_up_to(bound, beta, sigma)
    witness = None if holds else draw(loop, bound)
    both = lambda x: {"lo": str(x[0]), "hi": str(x[1])}
    margin = bound and [v + c / bound for v, c in zip(viscous, coulomb)]
    colgate, abbott_okamura = compared(scene, loop)
    return {
        "region": region, "not_covered": [],
        "verdict": "passive" if holds else "not_passive" if witness else "not_guaranteed",
        "beta": both((beta, beta)), "sigma": both((sigma, sigma)),
        "critical_speed": None if critical is None else both(critical),
        "spare": {"viscous": both(viscous), "coulomb": both(coulomb)},
        "speed_bound": bound and both((bound, bound)), "margin_at_speed_bound": margin and both(margin),
        "colgate": colgate, "abbott_okamura": abbott_okamura,
        "unforced": unforced(scene, region, viscous, coulomb), "witness": witness,
    }


def compared(scene, loop):
    """b >= KT/2 + B, and K <= min(2b/T, 2c/Delta), where nothing is late or filtered."""
    wall, beta = scene.get("wall", {}), loop.beta - HALF
    if (loop.delay or {"controller", "amplifier"} & set(scene) or "damping_time_constant" in wall
            or "latency" in scene.get("sampling", {})):
        return None, None
    says = lambda spare: "holds" if spare >= 0 else "fails"
    both = min(beta, loop.sigma - HALF) if loop.encoder else beta
    return says(beta - number(wall.get("damping", "0"))), says(both)


def unforced(scene, region, viscous, coulomb):
    """Left alone from the start, the device never passes V, whatever the verdict (TH-START)."""
    if "start" not in scene:
        return None
    if "amplifier" in scene or "latency" in scene.get("sampling", {}):
        raise Refused("a start behind an actuator is not in this implementation")
    x, v = (number(scene["start"].get(k, "0")) for k in ("position", "velocity"))
    square = v * v + x * x / above_zero(scene["dimensionless"].get("mu"))
    within = [c**2 >= f**2 * square for c, f in zip(coulomb, viscous)]
    if region == "locally_stable" and within[0] != within[1]:
        raise Refused("too close to the border for this implementation")
    return {"holds": region == "globally_stable" or (region == "locally_stable" and within[0])}


def draw(loop, bound):
    """A motion that draws energy, with what the operator gains each time round."""
    positions = drawn.find(loop, bound)
    if positions:
        return {"positions": [str(x) for x in positions], "wave": None,
                "gain_per_cycle": str(loop.gain(positions)[0])}
    wave = drawn.find_wave(loop) if bound is None else None
    if wave is None:
        return None
    return {"positions": [], "gain_per_cycle": str(drawn.wave_gain(loop, *wave)),
            "wave": dict(zip(("turns", "period", "amplitude"), map(str, wave)))}


OPERATIONS = {
    "interval": interval, "run": run, "motion": motion, "check": check,
    "version": lambda request: {"name": "passivity_ref", "version": "1", "protocol": 1},
}


def answer(line):
    identity = None
    try:
        request = json.loads(line, parse_int=Literal, parse_float=Literal, parse_constant=bad_constant)
        if not isinstance(request, dict):
            raise Refused("a request is an object")
        identity = request.get("id")
        operation = request.get("op")
        if not isinstance(operation, str) or operation not in OPERATIONS:
            raise Refused(f"no operation {operation!r}")
        result = OPERATIONS[operation](request)
        return {"id": plain(identity), "result": result}
    except Refused as refusal:
        error = {"kind": "refused", "message": str(refusal), "at": None}
    except (ValueError, RecursionError) as mistake:
        error = {"kind": "bad_json", "message": str(mistake), "at": None}
    return {"id": plain(identity), "error": error}


def bad_constant(name):
    raise Refused(f"{name} is not a number")


def plain(identity):
    """The id as it came: whole numbers were kept as text."""
    if isinstance(identity, Literal):
        return int(identity) if identity.lstrip("-").isdigit() else float(identity)
    return identity


def checked(path):
    """The exit code for a certificate."""
    from certificate import check_certificate

    try:
        with open(path, encoding="utf-8") as file:
            print(check_certificate(file.read()))
    except OSError as error:
        print(f"error: {path}: {error.strerror}", file=sys.stderr)
        return 2
    except (Refused, ValueError, RecursionError) as refusal:
        print(f"refused: {refusal}", file=sys.stderr)
        return 1
    return 0


def checked_witnesses(path):
    """The exit code for the witnesses that a file of vectors gives, each computed again."""
    with open(path, encoding="utf-8") as file:
        tests = json.load(file, parse_int=Literal, parse_float=Literal)["tests"]
    count = wrong = 0
    for test in tests:
        witness = test.get("result", {}).get("witness")
        if witness is None:
            continue
        scene, count = test["request"]["scene"], count + 1
        says = drawn.check_witness(read_scene(scene)[1], witness, speed_bound(scene))
        if says is not None:
            wrong += 1
            print(f"{test['id']}: {says}")
    print(f"{count} witnesses, {wrong} wrong")
    return 1 if wrong or not count else 0


def main():
    sys.set_int_max_str_digits(0)
    if len(sys.argv) == 3 and sys.argv[1] == "check-witnesses":
        sys.exit(checked_witnesses(sys.argv[2]))
    if len(sys.argv) > 2 and sys.argv[1] == "check-certificate":
        sys.exit(max([checked(path) for path in sys.argv[2:]]))
    if len(sys.argv) > 1:
        sys.exit("expected no arguments, or `check-certificate FILE...`, or `check-witnesses FILE`")
    for line in sys.stdin:
        sys.stdout.write(json.dumps(answer(line)) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
