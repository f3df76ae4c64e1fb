"""What a digital controller, latency and lag cost of friction: THEORY's sections 7 and 8, decided exactly.

A controller is a pair of lists (n, d) of fractions, H = (n0 + n1 w + ...)/(d0 + d1 w + ...) with
w = 1/z. A polynomial is a list of fractions, the constant first. An enclosure is a pair (lo, hi).
"""

from fractions import Fraction as F
from math import cos, isqrt, lcm, pi

HALF = F(1, 2)
WIDTH = F(1, 2**64)  # of an enclosure that is printed


class Refused(Exception):
    """A request that has no answer."""


# --- polynomials -----------------------------------------------------------------------------------


def trimmed(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def times(a, b):
    out = [F(0)] * max(len(a) + len(b) - 1, 0)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def plus(a, b, factor=1):
    """a + factor b."""
    size = max(len(a), len(b))
    a, b = (p + [F(0)] * (size - len(p)) for p in (a, b))
    return trimmed([x + factor * y for x, y in zip(a, b)])


def divided(a, b):
    """Quotient and remainder."""
    a, b, quotient = trimmed(list(a)), trimmed(b), [F(0)] * max(len(a) - len(b) + 1, 0)
    while len(a) >= len(b):
        factor, shift = a[-1] / b[-1], len(a) - len(b)
        quotient[shift] = factor
        a = trimmed([x - factor * b[i - shift] if i >= shift else x for i, x in enumerate(a[:-1])])
    return quotient, a


def exactly(a, b):
    quotient, rest = divided(a, b)
    if rest:
        raise ArithmeticError("a division that must come out does not")
    return quotient


def over_one(xs):
    """The numerators of fractions over their least common denominator, and that."""
    whole = lcm(*(x.denominator for x in xs))
    return [x.numerator * (whole // x.denominator) for x in xs], whole


def at(p, x):
    if isinstance(x, F):
        (numerators, whole), value, power = over_one(p), 0, 1
        for c in reversed(numerators):
            value, power = value * x.numerator + c * power, power * x.denominator
        return F(value * x.denominator, power * whole)
    value = 0 * x
    for c in reversed(p):
        value = value * x + c
    return value


def derivative(p):
    return [i * c for i, c in enumerate(p)][1:]


def sturm(p):
    """Sturm's sequence of p; its last member is the common divisor of p and its derivative."""
    chain = [trimmed(p), trimmed(derivative(p))]
    while chain[-1]:
        rest = divided(chain[-2], chain[-1])[1]
        size = max((abs(c) for c in rest), default=1)
        chain.append([-c / size for c in rest])
    return chain[:-1]


def changes(chain, x):
    signs = [v > 0 for v in (at(p, x) for p in chain) if v != 0]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def never_negative(p, lo=F(-1), hi=F(1)):
    """Whether p >= 0 on [lo, hi], lo < hi."""
    p = trimmed(p)
    for end, factor in ((lo, [-lo, F(1)]), (hi, [hi, F(-1)])):
        while p and at(p, end) == 0:
            p = exactly(p, factor)  # x - lo and hi - x are positive between the ends
    if not p:
        return True
    if at(p, lo) < 0 or at(p, hi) < 0:
        return False
    chain = sturm(p)
    pieces = [(lo, hi)]
    while pieces:
        a, b = pieces.pop()
        # Sturm's theorem counts distinct roots, between points that are no roots. Around a single
        # one p has the signs that it has at a and b, both positive.
        if changes(chain, a) - changes(chain, b) <= 1:
            continue
        middle, share = (a + b) / 2, F(1, 3)
        while at(p, middle) == 0:
            middle, share = a + share * (b - a), share / 2
        if at(p, middle) < 0:
            return False
        pieces += [(a, middle), (middle, b)]
    return True


def has_root(p):
    p = trimmed(p)
    if at(p, F(-1)) == 0 or at(p, F(1)) == 0:
        return True
    chain = sturm(p)
    return changes(chain, F(-1)) > changes(chain, F(1))


def simplest(lo, hi):
    """The fraction of least denominator in [lo, hi]."""
    whole = -(-lo.numerator // lo.denominator)
    if whole <= hi:
        return F(whole)
    below = whole - 1
    return below + 1 / simplest(1 / (hi - below), 1 / (lo - below))


# --- controllers -----------------------------------------------------------------------------------


def stable(d):
    """Jury: whether all poles, z with d0 z^n + d1 z^(n-1) + ... = 0, are inside the unit circle."""
    d = trimmed(list(d))
    while len(d) > 1:
        k = d[-1] / d[0]
        if abs(k) >= 1:
            return False
        d = [x - k * y for x, y in zip(d, reversed(d))][:-1]
    return True


def controller(n, d):
    if not d or d[0] == 0:
        raise Refused("the controller is not proper")
    if not n or not stable(d):
        raise Refused("the controller is not stable")
    if sum(n) / sum(d) < 0:
        raise Refused("the controller pushes away from the wall")
    return n, d


def damped(damping, pole):
    """1 + B(1 - w)(1 - a)/(1 - a w)."""
    filtered = [damping * (1 - pole), -damping * (1 - pole)]
    return plus([F(1), -pole], filtered), trimmed([F(1), -pole])


def gain_at_rest(law):
    return sum(law[0], F(0)) / sum(law[1], F(0))


def response(law, count):
    """c0, c1, ...: how the commands answer to a single 1."""
    n, d = law
    c = []
    for j in range(count):
        past = sum((d[i] * c[j - i] for i in range(1, len(d)) if i <= j), F(0))
        c.append(((n[j] if j < len(n) else F(0)) - past) / d[0])
    return c


def tails(law):
    """g1, g2, ... as a controller: from H(1) - H = (1 - w)(g1 + g2 w + ...)."""
    n, d = law
    return exactly(plus([gain_at_rest(law) * x for x in d], n, -1), [F(1), F(-1)]), d


def settled(law, width=WIDTH):
    """The response until what follows adds up to `after` <= width, and `after`."""
    n, d = law
    order = len(d) - 1
    if order == 0:
        return response(law, len(n)), F(0)
    # Past the numerator the last `order` terms s obey s' = A s. With |A^m| <= 1/2 in the norm of
    # sums all that follows is at most 2(|A| + ... + |A^m|) |s|.
    a = [[-d[i + 1] / d[0] for i in range(order)]]
    a += [[F(i == j) for i in range(order)] for j in range(order - 1)]
    norm = lambda m: max(sum(abs(row[i]) for row in m) for i in range(order))
    power, together, m = a, norm(a), 1
    while norm(power) > HALF:
        power = [[sum(a[i][k] * power[k][j] for k in range(order)) for j in range(order)]
                 for i in range(order)]
        together, m = together + norm(power), m + 1
        if m > 400:
            raise Refused("the controller forgets too slowly for this implementation")
    count = len(n) + order
    while True:
        c = response(law, count)
        after = 2 * together * sum(map(abs, c[-order:]), F(0))
        if after <= width:
            return c, after
        if count > 4000:
            raise Refused("the controller forgets too slowly for this implementation")
        count += count // 2


def absolute_sum(law):
    """An enclosure of |c0| + |c1| + ...; a point for a denominator of order 0 or 1."""
    n, d = law
    if len(d) == 2:
        c = response(law, max(len(n), 1))
        ratio = abs(d[1] / d[0])
        whole = sum(map(abs, c)) + abs(c[-1]) * ratio / (1 - ratio)
        return whole, whole
    c, after = settled(law)
    return sum(map(abs, c), F(0)), sum(map(abs, c), F(0)) + after


# --- lambda ----------------------------------------------------------------------------------------


def real_part(a, b):
    """Re a(w) b(1/w) at w = e^(-i theta), as a polynomial in x = cos theta."""
    total, t = [], [[F(1)], [F(0), F(1)]]  # T_j(x) = cos j theta
    while len(t) < max(len(a), len(b)):
        t.append(plus(times([F(0), F(2)], t[-1]), t[-2], -1))
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            total = plus(total, t[abs(i - j)], x * y)
    return total


class Frequencies:
    """lambda(theta) = Re[(1 - w)H]/(2(1 - x)) = R(x)/Q(x) for a controller with its delay."""

    def __init__(self, law, delay):
        n, d = law
        n = [F(0)] * delay + n
        # (1 - w) N / D has the real part Re[(1 - w) N conj(D)]/|D|^2, and 1 - x divides it.
        above = real_part(times([F(1), F(-1)], n), d)
        self.r, self.q = exactly(above, [F(2), F(-2)]), real_part(d, d)

    def at(self, x):
        return at(self.r, x) / at(self.q, x)

    def spare(self, beta):
        """P = beta Q - R."""
        return plus([beta * c for c in self.q], self.r, -1)

    def enough(self, beta):
        return never_negative(self.spare(beta))

    def enclosure(self):
        lo = max(self.at(F(-1)), self.at(F(1)))
        if self.enough(lo):
            return lo, lo
        # A guess from a grid, proved before it is used.
        r, q = ([float(c) for c in p] for p in (self.r, self.q))
        value = lambda x: at(r, x) / at(q, x)
        guess = F(max(value(cos(pi * i / 2000)) for i in range(2001)))
        step = F(1, 1000)
        while not self.enough(guess + step):
            step *= 2
        hi = guess + step
        while hi - lo > WIDTH:
            middle = (lo + hi) / 2
            if self.enough(middle):
                hi = middle
            else:
                lo = middle
        simple = simplest(lo, hi)
        if self.enough(simple) and has_root(self.spare(simple)):
            return simple, simple
        return lo, hi


# --- actuators -------------------------------------------------------------------------------------


def rounded(lo, hi, bits):
    """The same enclosure with ends of so many bits after the point."""
    unit = 2**bits
    return F(lo * unit // 1, unit), F(-(-hi * unit // 1), unit)


def decay(x, bits=128):
    """An enclosure of e^(-x), x >= 0."""
    halvings = 0
    while x > 1:
        x, halvings = x / 2, halvings + 1
    bits += 2 * halvings + 8
    total, term, k = F(0), F(1), 0
    while term > F(1, 2**bits):
        total, k = total + (-term if k % 2 else term), k + 1
        term = term * x / k
    # The terms fall in size and change their signs.
    lo, hi = rounded(max(total - term, F(0)), total + term, bits)
    for _ in range(halvings):
        lo, hi = rounded(lo * lo, hi * hi, bits)
    return lo, hi


def root(x, bits):
    """An enclosure of the square root; a point for the square of a fraction."""
    n, d = isqrt(x.numerator), isqrt(x.denominator)
    if n * n == x.numerator and d * d == x.denominator:
        return F(n, d), F(n, d)
    scaled = isqrt(x.numerator * 4**bits // x.denominator)
    return F(scaled, 2**bits), F(scaled + 1, 2**bits)


class Actuator:
    """A latency of s periods, whole samples of delay included, and a lag of theta behind it."""

    def __init__(self, s, theta):
        self.s, self.theta, self.mean = s, theta, s + theta

    def variance(self, bits):
        """Var = integral of G^2 over the phase of the sample, less m^2. With f the fraction of s
        G(t) = k + [t < f] + g(t - f mod 1), g(t) = e^(-t/theta)/(1 - e), e = e^(-1/theta)."""
        f, theta = self.s % 1, self.theta
        own = f * (1 - f)
        if theta == 0:
            return own, own
        e, part = decay(1 / theta, bits), decay((1 - f) / theta, bits)
        of_lag = lambda e: theta / 2 * (1 + e) / (1 - e) - theta**2  # coth(1/(2 theta))
        # The covariance: the integral of g over [1 - f, 1), less f theta.
        shared = lambda part, e: theta * (part - e) / (1 - e) - f * theta
        if f == 0:
            return own + of_lag(e[0]), own + of_lag(e[1])
        return (own + of_lag(e[0]) + 2 * shared(part[0], e[1]),
                own + of_lag(e[1]) + 2 * shared(part[1], e[0]))

    def enough(self, beta):
        """beta >= kappa, by squares: kappa = ((1/2 + m) + root((1/2 + m)^2 + Var))/2."""
        first = HALF + self.mean
        rest = 2 * beta - first
        for bits in (64, 256, 1024, 4096):
            lo, hi = self.variance(bits)
            if rest >= 0 and rest**2 >= first**2 + hi:
                return True
            if rest < 0 or rest**2 < first**2 + lo:
                return False
        raise Refused("too close to the border for this implementation")

    def cost(self, bits=128):
        lo, hi = self.variance(bits)
        first = HALF + self.mean
        return ((first + root(first**2 + lo, bits)[0]) / 2, (first + root(first**2 + hi, bits)[1]) / 2)


# --- a loop ----------------------------------------------------------------------------------------


class Costs:
    """What a loop asks of beta and of sigma, each decided exactly and enclosed.

    `linear` says whether the force is linear in the measured positions; `actuator` is a pair
    (latency, theta) or None.
    """

    def __init__(self, law, delay, linear, actuator, encoder, force_step):
        self.frequencies = None
        if actuator is None and linear:
            self.frequencies = Frequencies(law, delay)
            self.viscous = self.frequencies.enclosure()
        else:
            # The absolute tails of the law without its delay, and H(1)(1/2 + k) or H(1) kappa.
            self.h1, self.g = gain_at_rest(law), absolute_sum(tails(law))
            self.actuator = Actuator(delay + (actuator[0] if actuator else 0), actuator[1] if actuator else F(0))
            if actuator is None:
                kappa = (HALF + delay,) * 2
            else:
                kappa = self.actuator.cost()
            self.viscous = tuple(self.h1 * k + g for k, g in zip(kappa, self.g))
        norm = absolute_sum(law) if encoder else (F(0), F(0))
        self.coulomb = tuple((c + force_step) / 2 for c in norm)

    def enough(self, beta):
        """Whether beta is at least the viscous cost."""
        if self.frequencies is not None:
            return self.frequencies.enough(beta)
        if beta >= self.viscous[1]:
            return True
        if beta < self.viscous[0]:
            return False
        if self.g[0] != self.g[1] or self.h1 == 0:
            raise Refused("too close to the border for this implementation")
        return self.actuator.enough((beta - self.g[0]) / self.h1)

    def holds_up_to(self, speed, beta, sigma):
        """Whether (beta - cost) v + (sigma - cost) >= 0 for all 0 < v <= speed."""
        rest = sigma - self.coulomb[1]
        if rest < 0:
            if sigma >= self.coulomb[0]:
                raise Refused("too close to the border for this implementation")
            return False
        return self.enough(beta + rest / speed)
