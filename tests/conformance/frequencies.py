"""Checks a certificate of `passivity check --certificate`: from its loop alone, with fractions.

    python3 tests/conformance/passivity_ref.py check-certificate FILE

Friction beta is enough at every frequency where P = beta Q - R is nowhere negative in x = cos theta.
P is computed here from H(z); that it is nowhere negative on [-1, 1] follows from a Sturm sequence of
which nothing is believed: P = S M^2, each member is minus the remainder of the two before, and by the
sign changes S has no root between the ends, and it is positive at 0.
"""

from fractions import Fraction as F

from costs import Frequencies, Refused, at, changes, controller, damped, derivative, divided, times, trimmed

FORMAT = "passivity-check-certificate-1"
PARTS = {
    "certificate": {"format", "scene", "loop", "cost", "decisions"},
    "loop": {"beta", "delay", "damping", "pole", "controller"},
    "controller": {"numerator", "denominator"},
    "beta": {"lo", "hi"},
    "cost": {"above", "at_most"},
}
DECISION = {"beta", "enough", "polynomial"}
SHOWN = {
    True: DECISION | {"simple", "repeated", "sequence", "sign_changes", "simple_at_zero"},
    False: DECISION | {"at", "value"},
}


def part(name, section, known=None):
    """A section of the certificate, with no field that is not known."""
    if not isinstance(section, dict):
        raise Refused(f"`{name}` is not an object")
    unknown = set(section) - (known or PARTS[name])
    if unknown:
        raise Refused(f"unknown field {sorted(unknown)[0]}")
    return section


def numbers(value, number):
    if not isinstance(value, list):
        raise Refused("expected a list of numbers")
    return [number(x) for x in value]


def polynomial(value, number):
    p = numbers(value, number)
    if p and p[-1] == 0:
        raise Refused("the last coefficient of a polynomial is zero")
    return p


def same_ray(a, b):
    """Whether a is b times a positive factor."""
    if not a or len(a) != len(b):
        return not a and not b
    factor = a[-1] / b[-1]
    return factor > 0 and all(x == factor * y for x, y in zip(a, b))


def check_sequence(chain, simple):
    """That this is Sturm's sequence of a polynomial of simple roots, up to positive factors."""
    follows = [simple, trimmed(derivative(simple))]
    for index, member in enumerate(chain):
        if index >= 2:
            follows.append([-c for c in divided(chain[index - 2], chain[index - 1])[1]])
        if not member or not same_ray(member, follows[index]):
            raise Refused(f"member {index} of the sequence is not what follows from those before")
    if not chain or len(chain[-1]) != 1:
        raise Refused("the sequence does not end with a number other than zero")


def check_enough(p, decision, number, whole):
    """That P is nowhere negative on [-1, 1]."""
    simple, repeated = (polynomial(decision[key], number) for key in ("simple", "repeated"))
    if trimmed(times(simple, times(repeated, repeated))) != p:
        raise Refused("the polynomial is not simple times repeated squared")
    if not isinstance(decision["sequence"], list):
        raise Refused("`sequence` is not a list")
    chain = [polynomial(member, number) for member in decision["sequence"]]
    if p:
        check_sequence(chain, simple)
    elif chain:
        raise Refused("the polynomial zero has no Sturm sequence")
    stated = [whole(x) for x in decision["sign_changes"]]
    own = [changes(chain, x) for x in (F(-1), F(1))]
    if stated != own:
        raise Refused(f"the sign changes at -1 and 1 are {own}, and the certificate says {stated}")
    # Sturm's count is of (-1, 1]: a root at 1 is none between the ends.
    if p and own[0] - own[1] != (at(simple, F(1)) == 0):
        raise Refused("the polynomial has a root between the ends")
    middle = at(simple, F(0))
    if number(decision["simple_at_zero"]) != middle:
        raise Refused(f"the value at 0 is {middle}, and the certificate says {decision['simple_at_zero']}")
    if p and middle <= 0:
        raise Refused("the polynomial is negative between the ends")


def check_short(p, decision, number):
    """That P is negative somewhere on [-1, 1]."""
    x = number(decision["at"])
    if abs(x) > 1:
        raise Refused(f"{x} is no cosine")
    if number(decision["value"]) != at(p, x):
        raise Refused(f"the polynomial at {x} is {at(p, x)}, and the certificate says {decision['value']}")
    if at(p, x) >= 0:
        raise Refused(f"the polynomial is not negative at {x}")


def law_of(terms, number):
    if "controller" in terms:
        if "damping" in terms or "pole" in terms:
            raise Refused("damping and a controller cannot both be given")
        given = part("controller", terms["controller"])
        return controller(*(numbers(given.get(key), number) for key in ("numerator", "denominator")))
    damping, pole = (number(terms.get(key, "0")) for key in ("damping", "pole"))
    if damping < 0 or not 0 <= pole < 1:
        raise Refused("no damping behind a filter")
    return damped(damping, pole)


def check(certificate, number, whole):
    """A sentence that says what was found; `Refused` when the certificate is not right."""
    terms = part("loop", part("certificate", certificate).get("loop"))
    beta, cost = part("beta", terms.get("beta")), part("cost", certificate.get("cost"))
    beta = [number(beta.get(key)) for key in ("lo", "hi")]
    above, at_most = (number(cost.get(key)) for key in ("above", "at_most"))
    if not 0 <= beta[0] <= beta[1] or above >= at_most:
        raise Refused("the ends of beta, or those of the cost, are the wrong way round")
    delay = whole(terms.get("delay"))
    if not 0 <= delay <= 1000:
        raise Refused("delay: a whole number of samples")
    frequencies = Frequencies(law_of(terms, number), delay)
    enough = {}
    if not isinstance(certificate.get("decisions"), list):
        raise Refused("`decisions` is not a list")
    for decision in certificate["decisions"]:
        if not isinstance(decision, dict) or not isinstance(decision.get("enough"), bool):
            raise Refused("a decision says whether friction is `enough`")
        known = SHOWN[decision["enough"]]
        if set(part("decision", decision, known)) != known:
            raise Refused(f"a decision has the fields {', '.join(sorted(known))}")
        least = number(decision["beta"])
        p = trimmed(frequencies.spare(least))
        if polynomial(decision["polynomial"], number) != p:
            raise Refused(f"the polynomial for beta = {least} is not that of the loop")
        if decision["enough"]:
            check_enough(p, decision, number, whole)
        else:
            check_short(p, decision, number)
        enough[least] = decision["enough"]
    if set(enough) != {*beta, above, at_most}:
        raise Refused("the decisions are those about both ends of beta and of the cost")
    if enough[above] or not enough[at_most]:
        raise Refused("the cost is not between the numbers given")
    says = {(True, True): "is enough", (False, False): "is not enough"}.get(
        (enough[beta[0]], enough[beta[1]]), "may be enough or not")
    shown = str(beta[0]) if beta[0] == beta[1] else f"{beta[0]} … {beta[1]}"
    return f"Right: beta = {shown} {says}; what is asked for is above {above} and at most {at_most}."
