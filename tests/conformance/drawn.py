"""Motions that draw energy each time round: their gain from the encoder, the law and friction alone.

A motion is a list of positions in ticks, one for each sample of a period; the device moves at constant
speed from one to the next, and from the last to the first, for ever. Over a period no storage gains.
"""

from fractions import Fraction as F
from functools import cache
from itertools import product
from math import cos, floor, gcd, pi, sin

from costs import HALF, Frequencies, Refused, at, decay, derivative, over_one, rounded, settled, tails, times

SMALL = F(1, 2**96)  # what a response that does not end is cut at


class Loop:
    """What a motion meets: a law with its delay, the wall's effects, an actuator and friction."""

    def __init__(self, law, delay, friction, encoder=True, unilateral=False, step=None, limit=None,
                 actuator=None):
        self.law, self.delay, (self.beta, self.sigma) = law, delay, friction
        self.encoder, self.unilateral, self.step, self.limit = encoder, unilateral, step, limit
        self.actuator = actuator
        self.response, self.after = settled(law, SMALL)
        if self.after:
            # Short numbers, a little off.
            self.response = [F(round(c / SMALL)) * SMALL for c in self.response]
            self.after += len(self.response) * SMALL
        self.mean_response = cache(self.mean_response)
        self.folded = cache(lambda p: [sum(self.response[i::p], F(0)) for i in range(p)])

    def linear(self):
        return not self.unilateral and self.limit is None

    def mean_response(self):
        """Enclosures of the shares k_j that the command j samples ago has of the mean force over an
        interval, and what those that are left out amount to.

        It acts on average for A(j - 1) - 2 A(j) + A(j + 1), where A(y) is the integral from y on of
        the probability P(t) that the actuator is later than t: P = 1 up to s, then e^(-(t - s)/theta)."""
        s, theta = self.actuator if self.actuator else (F(0), F(0))
        last = floor(s) + 1 + (floor(70 * theta) + 1 if theta else 0)
        if last > 2000:
            return None

        def area(y):
            if y <= s:
                return (s - y + theta,) * 2
            return tuple(theta * e for e in decay((y - s) / theta)) if theta else (F(0), F(0))

        areas = [area(F(j)) for j in range(-1, last + 2)]
        shares = []
        for before, here, after in zip(areas, areas[1:], areas[2:]):
            shares.append((before[0] - 2 * here[1] + after[0], before[1] - 2 * here[0] + after[1]))
        return shares, areas[-2][1] - areas[-1][0]

    def commands(self, positions):
        """Enclosures of the commanded forces, after rounding and limiting."""
        measured = [floor(x) + HALF if self.encoder else x for x in positions]
        p = len(measured)
        folded = self.folded(p)
        error = self.after * max(map(abs, measured))
        if self.unilateral and min(measured) < 0 and len(self.response) > 1:
            return None  # a law with memory that is switched off and on is not in this implementation
        forces = []
        (folded, a), (shown, b) = over_one(folded), over_one(measured)
        for h in range(p):
            u = F(-sum(folded[i] * shown[h - i] for i in range(p)), a * b)
            if self.unilateral and measured[h] < 0:
                u = F(0)
            lo, hi = u - error, u + error
            if self.step is not None:
                lo, hi = (self.step * floor(x / self.step + HALF) for x in (lo, hi))
            if self.limit is not None:
                lo, hi = (max(min(x, self.limit), -self.limit) for x in (lo, hi))
            forces.append((lo, hi))
        return forces

    def forces(self, positions):
        """Enclosures of the mean force over each interval."""
        forces, p = self.commands(positions), len(positions)
        if forces is None:
            return None
        if self.actuator:
            found = self.mean_response()
            if found is None:
                return None
            shares, after = found
            # Around the middle: a command that does not change makes a force that is known.
            middle = sum(lo + hi for lo, hi in forces) / (2 * p)
            most = max(max(abs(lo - middle), abs(hi - middle)) for lo, hi in forces)
            folded = [(F(0), F(0))] * p
            for j, share in enumerate(shares):
                old = folded[j % p]
                folded[j % p] = old[0] + share[0], old[1] + share[1]
            known, a = over_one([k for share in folded for k in share])
            off, b = over_one([u - middle for force in forces for u in force])
            known, off = (list(zip(ends[::2], ends[1::2])) for ends in (known, off))
            mixed = []
            for h in range(p):
                lo = hi = 0
                for i, share in enumerate(known):
                    ends = [k * u for k in share for u in off[h - i]]
                    lo, hi = lo + min(ends), hi + max(ends)
                lo, hi = middle + F(lo, a * b), middle + F(hi, a * b)
                mixed.append((lo - after * most, hi + after * most))
            forces = mixed
        return [forces[(h - self.delay) % p] for h in range(p)]

    def gain(self, positions):
        """An enclosure of what the operator gains each time round; None where it is not known."""
        forces = self.forces(positions)
        if forces is None:
            return None
        lo = hi = F(0)
        for h, force in enumerate(forces):
            d = positions[(h + 1) % len(positions)] - positions[h]
            spent = self.beta * d * d + self.sigma * abs(d)
            ends = sorted(u * d for u in force)
            lo, hi = lo + ends[0] - spent, hi + ends[1] - spent
        return lo, hi


# --- looking for one -------------------------------------------------------------------------------


def steps(positions):
    return [b - a for a, b in zip(positions, positions[1:] + positions[:1])]


def across_an_edge(loop, bound):
    """Between n and n - a, a small: the encoder shows n + 1/2 and n - 1/2. Every pattern of sides up
    to a period of 8; the gain is a (S - sigma moves) - a^2 beta moves as long as a <= 1."""
    n = F(1)
    for p in range(2, 9):
        for sides in product((0, 1), repeat=p - 1):
            sides = (1, *sides)
            turned = [sides[i:] + sides[:i] for i in range(p)]
            if 0 not in sides or sides != max(turned):
                continue  # each pattern once
            moves = sum(a != b for a, b in zip(sides, sides[1:] + sides[:1]))
            forces = loop.forces([n - (1 - side) for side in sides])
            if forces is None:
                continue
            ways = steps(list(sides))
            drawn = sum(min(u * way for u in force) for force, way in zip(forces, ways))
            rest = drawn - loop.sigma * moves
            if rest <= 0:
                continue
            a = F(1) if loop.beta == 0 else min(F(1), rest / (2 * loop.beta * moves))
            if bound is not None and a >= bound:
                a = bound / 2
            positions = [n - (1 - side) * a for side in sides]
            if (found := loop.gain(positions)) and found[0] > 0:
                return positions
    return None


def there_and_back(loop, bound):
    """Between n - a and n + m (TH-ACTIVE), one interval each way."""
    for m in range(65):
        forces = loop.forces([F(0), F(1 + m)])
        if forces is None or (bound is not None and m >= bound):
            return None
        # The gain is d (S - 2 beta d - 2 sigma) with d = m + a.
        rest = forces[0][0] - forces[1][1] - 2 * loop.sigma - 2 * loop.beta * m
        if rest > 0:
            a = F(1) if loop.beta == 0 else min(F(1), rest / (4 * loop.beta))
            if bound is not None and m + a >= bound:
                a = (bound - m) / 2
            positions = [1 - a, F(1 + m)]
            if (found := loop.gain(positions)) and found[0] > 0:
                return positions
    return None


@cache
def in_doubles(loop):
    """Numerator, denominator and the actuator's shares, for `spare_at`."""
    shares = [lo for lo, _ in loop.mean_response()[0]] if loop.actuator else [1]
    return [[float(x) for x in c] for c in (*loop.law, shares)]


def spare_at(loop, q, p):
    """lambda(2 pi q/p) - beta of the whole loop, in doubles; to choose an angle with."""
    theta = 2 * pi * q / p
    wave = lambda c: sum(x * complex(cos(j * theta), -sin(j * theta)) for j, x in enumerate(c))
    n, d, shares = map(wave, in_doubles(loop))
    h = n / d * shares * complex(cos(loop.delay * theta), -sin(loop.delay * theta))
    return ((1 - complex(cos(theta), -sin(theta))) * h).real / (2 - 2 * cos(theta)) - float(loop.beta)


def of_one_frequency(loop, bound):
    """Whole ticks next to a sine of period p/q, larger and larger."""
    if loop.actuator and loop.mean_response() is None:
        return None
    angles = sorted(((spare_at(loop, q, p), q, p) for p in range(2, 41) for q in range(1, p // 2 + 1)
                     if gcd(q, p) == 1), reverse=True)
    for spare, q, p in angles[:4]:
        if spare < -1e-9:
            continue
        wave = [cosine(F(4 * q * h + 2 * q - p, 4 * p), 256) for h in range(p)]
        middle = [(lo + hi) / 2 for lo, hi in wave]
        for doubling in range(150):
            positions = [F(round(w * 2**doubling)) for w in middle]
            if loop.unilateral:
                positions = [x - min(positions) for x in positions]
            if bound is not None and max(map(abs, steps(positions))) >= bound:
                break
            found = loop.gain(positions)
            if found and found[0] > 0:
                return positions
    return None


def find(loop, bound):
    """A motion that draws energy, within the bound on the speed; None where none is found."""
    ways = [of_one_frequency]
    if loop.encoder:
        ways = [there_and_back, across_an_edge, of_one_frequency]
    for way in ways:
        if found := way(loop, bound):
            return found
    return None


# --- a wave as a formula ----------------------------------------------------------------------------


@cache
def pi_between(bits):
    """Machin: pi/4 = 4 arctan(1/5) - arctan(1/239); an enclosure."""
    def arctan(n):
        total, term, k = F(0), F(1, n), 0
        while term > F(1, 2 ** (bits + 8)):
            total += (-1) ** k * term / (2 * k + 1)
            term, k = term / n**2, k + 1
        return total - term, total + term
    (a, b), (c, d) = arctan(5), arctan(239)
    return rounded(16 * a - 4 * d, 16 * b - 4 * c, bits + 8)


def cosine(turns, bits):
    """An enclosure of cos(2 pi turns)."""
    turns = abs(turns - round(turns))  # at most half a turn
    if turns > F(1, 4):
        lo, hi = cosine(HALF - turns, bits)
        return -hi, -lo
    exact = {F(0): F(1), F(1, 6): HALF, F(1, 4): F(0)}.get(turns)
    if exact is not None:
        return exact, exact
    middle = sum(pi_between(bits)) * turns  # an angle below 1.6
    # In whole multiples of 1/unit; each of the terms, fewer than 2^8, is off by less than 4/unit.
    unit = 2 ** (bits + 16)
    x, total, term, k = round(middle * unit) ** 2 // unit, 0, unit, 0
    while term:
        total += term if k % 2 == 0 else -term
        term, k = term * x // ((2 * k + 1) * (2 * k + 2) * unit), k + 1
    # What is left out is below the last term, and the angle is off by less than 2^-bits.
    error = F(1, 2 ** (bits - 4))
    return F(total, unit) - error, F(total, unit) + error


@cache
def whole_law(loop):
    """The law with its delay and the actuator's shares, its cost at each frequency, and the most that
    |lambda - beta| is; None where no formula is known."""
    n, d = loop.law
    taps = [F(1)]
    if loop.actuator:
        if loop.actuator[1]:
            return None  # a lag's response does not end
        taps = [lo for lo, _ in loop.mean_response()[0]]
    whole = [F(0)] * loop.delay + times(n, taps), d
    g, after = settled(tails(whole))
    return Frequencies(whole, 0), sum(map(abs, g)) + after + sum(whole[0]) / sum(d) / 2 + loop.beta


def wave_gain(loop, q, p, amplitude):
    """A lower bound of what the wave gains each period; None where no formula is known.

    Whole ticks next to a sine of period p/q, with steps D = A cos(theta h) + r, |r| <= 1, sum D = 0. The
    encoder shows whole ticks exactly, up to a half that makes no difference. With the spectra D^ over
    a period, F >= |lambda - beta| and s <= lambda(theta) - beta the law gains (1/p) sum (lambda - beta)|D^|^2:
    at +-theta |D^| >= A p/2 - p, which makes at least s p (A - 2)^2/2 there, and at all the other
    frequencies it is r^ alone, whose squares sum to p^2 at most. Coulomb friction and force steps take
    (sigma + step/2)(A + 1) a sample at most."""
    if not loop.linear() or amplitude < 4 or not 0 < 2 * q <= p or not whole_law(loop):
        return None
    most = whole_law(loop)[1]
    least = least_spare(loop, q, p)
    if least <= 0:
        return None
    sigma = loop.sigma + (loop.step / 2 if loop.step is not None else 0)
    return p * (least * F(amplitude - 2) ** 2 / 2 - most - sigma * (amplitude + 1))


@cache
def least_spare(loop, q, p):
    """A lower bound of lambda - beta at theta = 2 pi q/p."""
    cost, x = whole_law(loop)[0], cosine(F(q, p), 64 + 6 * p.bit_length())
    over = [-c for c in cost.spare(loop.beta)]
    middle, radius = (x[0] + x[1]) / 2, (x[1] - x[0]) / 2
    # By the mean value, with |x| <= 1: the derivative is at most the sum of its coefficients.
    above = at(over, middle) - radius * sum(map(abs, derivative(over)), F(0))
    size = at(cost.q, middle) + radius * sum(map(abs, derivative(cost.q)), F(0))
    return above / size if above > 0 else F(0)


def find_wave(loop):
    """(q, p, A) of a wave that draws energy, for a linear law; p is a power of two."""
    if not loop.linear():
        return None
    q, p = max((spare_at(loop, q, 4096), q) for q in range(1, 2049))[1], 4096
    # Nearer and nearer to the best angle, by the exact figure.
    while p < 2**70:
        for turns in (q - 1, q, q + 1):
            if 0 < 2 * turns <= p:
                for doubling in (8, 40, 80, 120, 160):
                    gain = wave_gain(loop, turns, p, 2**doubling)
                    if gain is not None and gain > 0:
                        return turns, p, 2**doubling
        q, p = better(loop, q, p), 2 * p
    return None


def better(loop, q, p):
    """Of the neighbours of q/p on the grid of 1/(2p) the one with the largest lambda."""
    cost = Frequencies(loop.law, loop.delay)
    def height(turns):
        lo, hi = cosine(F(turns, 2 * p), 64 + 6 * p.bit_length())
        return cost.at((lo + hi) / 2)
    return max((t for t in (2 * q - 1, 2 * q, 2 * q + 1) if 0 < t <= p), key=height)


def check_witness(loop, witness, bound):
    """None where the motion draws what it says, else a sentence that says what is wrong."""
    claim = F(witness["gain_per_cycle"])
    if claim <= 0:
        return "the gain is not above zero"
    wave = witness.get("wave")
    if wave:
        own = wave_gain(loop, *(int(wave[key]) for key in ("turns", "period", "amplitude")))
        if own is None or claim > own:
            return f"the wave gains at least {own}, and {claim} is claimed"
        return None
    positions = [F(x) for x in witness["positions"]]
    if bound is not None and max(map(abs, steps(positions))) > bound:
        return "it is faster than the bound on the speed"
    own = loop.gain(positions)
    if own is None:
        raise Refused("this motion is not in this implementation")
    lo, hi = own
    exact = len(loop.law[1]) == 1 and not (loop.actuator and loop.actuator[1])
    if claim > hi or lo <= 0 or (exact and claim != lo):
        return f"it gains {float(lo)} to {float(hi)}, and {float(claim)} is claimed"
    return None
