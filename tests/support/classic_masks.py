# SPDX-License-Identifier: GPL-3.0-or-later
"""Classical masks in exact fractions: splines, pseudo-splines, interpolation of any arity, dual and ternary schemes."""

from fractions import Fraction
from math import comb


def convolved(a, b):
    result = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def power(a, n):
    result = [Fraction(1)]
    for _ in range(n):
        result = convolved(result, a)
    return result


def mean(m):
    """S_m(z)/m."""
    return [Fraction(1, m)] * m


def scaled(c, a):
    return [c * x for x in a]


def bspline(m, n):
    return scaled(m, power(mean(m), n + 1))


def pseudo_spline(m, l):
    """Of type II and order (m, l), Dong and Shen 2006; l = m - 1: interpolating, l = 0: B-spline of degree 2m - 1."""
    cos2 = [Fraction(1, 4), Fraction(1, 2), Fraction(1, 4)]
    sin2 = [Fraction(-1, 4), Fraction(1, 2), Fraction(-1, 4)]
    total = [Fraction(0)] * (2 * l + 1)
    for j in range(l + 1):
        term = scaled(comb(m + l, j), convolved(power(sin2, j), power(cos2, l - j)))
        total = [a + b for a, b in zip(total, term)]
    return scaled(2, convolved(power(cos2, m), total))


def hormann_sabin(k):
    """Cubic precision, Hormann and Sabin 2008."""
    return scaled(2, convolved(power(mean(2), k), [Fraction(-k, 8), 1 + Fraction(k, 4), Fraction(-k, 8)]))


def lagrange(nodes, x):
    weights = []
    for i, a in enumerate(nodes):
        w = Fraction(1)
        for j, b in enumerate(nodes):
            if i != j:
                w *= Fraction(x - b) / (a - b)
        weights.append(w)
    return weights


def from_stencils(m, stencils):
    """stencils[s]: offset -> weight; a_{s - m h} = stencils[s][h]."""
    a = {s - m * h: c for s, stencil in stencils.items() for h, c in stencil.items()}
    return [a.get(i, Fraction(0)) for i in range(min(a), max(a) + 1)]


def interpolating(m, n):
    """n points, n even, by polynomials of degree n - 1."""
    offsets = range(-(n // 2) + 1, n // 2 + 1)
    stencils = {s: dict(zip(offsets, lagrange(list(offsets), Fraction(s, m)))) for s in range(1, m)}
    return from_stencils(m, {0: {0: Fraction(1)}, **stencils})


def dual(n):
    """The polynomial through n points, a quarter of the step off; n = 4: Dyn, Floater, Hormann 2005."""
    offsets = range(-(n // 2) + 1, n // 2 + 1) if n % 2 == 0 else range(-(n // 2), n // 2 + 1)
    at = (Fraction(1, 4), Fraction(3, 4)) if n % 2 == 0 else (Fraction(-1, 4), Fraction(1, 4))
    return from_stencils(2, {s: dict(zip(offsets, lagrange(list(offsets), x))) for s, x in enumerate(at)})


def ternary_three_points():
    return from_stencils(3, {s: dict(zip((-1, 0, 1), lagrange([-1, 0, 1], Fraction(s, 3)))) for s in (-1, 0, 1)})


def ternary_three_points_interpolating(b):
    """Hassan and Dodgson 2003."""
    a = b - Fraction(1, 3)
    side = [b, 1 - a - b, a]
    return from_stencils(3, {-1: dict(zip((-1, 0, 1), side)), 0: {0: Fraction(1)},
                             1: dict(zip((-1, 0, 1), side[::-1]))})


def ternary_four_points(mu):
    """Hassan, Ivrissimtzis, Dodgson, Sabin 2002."""
    a = [Fraction(-1, 18) - mu / 6, Fraction(13, 18) + mu / 2, Fraction(7, 18) - mu / 2, Fraction(-1, 18) + mu / 6]
    return from_stencils(3, {0: {0: Fraction(1)}, 1: dict(zip(range(-1, 3), a)), 2: dict(zip(range(-1, 3), a[::-1]))})


def four_points(w):
    """Dyn, Levin, Gregory 1987."""
    h = Fraction(1, 2) + w
    return [-w, Fraction(0), h, Fraction(1), h, Fraction(0), -w]


def six_points(t):
    """Weissman 1990."""
    a, b = -(Fraction(1, 16) + 3 * t), Fraction(9, 16) + 2 * t
    return [t, Fraction(0), a, Fraction(0), b, Fraction(1), b, Fraction(0), a, Fraction(0), t]


def quasi_spline(w):
    """Cubic, Jeong, Lee, Yoon 2013."""
    return [w / 8, (1 + 2 * w) / 8, (4 - w) / 8, (3 - 2 * w) / 4, (4 - w) / 8, (1 + 2 * w) / 8, w / 8]


def scheme(m, a):
    """The name of the mask on the command line."""
    return f'mask:coefficients="{",".join(map(str, a))}",lowest=0,arity={m}'


def q(text):
    return Fraction(text)


# name, arity, mask, order of the sum rules, Hölder exponent: exact as the program spells it, or twelve decimals, or
# None; is the exponent attained (None: not decided).
def table():
    rows = []
    for m in (2, 3, 4, 5):
        for n in range(6):
            rows.append((f"bspline {m} {n}", m, bspline(m, n), n + 1, str(n), True if n else None))
    interpolation = {1: ("1", True), 2: ("2", False), 3: ("6 - log(9)/log(2)", True), 4: (3.551130531563, True),
                     5: (4.193573434501, True), 6: (4.776748176859, True), 7: (5.317320607257, True),
                     8: (5.829443352557, True)}
    for l, (exponent, attained) in interpolation.items():
        rows.append((f"{2 * l} points", 2, pseudo_spline(l, l - 1), 2 * l, exponent, attained))
    pseudo = {(2, 0): "3", (3, 0): "5", (3, 1): "6 - log(5)/log(2)", (4, 0): "7", (4, 1): "8 - log(6)/log(2)",
              (4, 2): 4.343791552363, (5, 0): "9", (5, 1): "10 - log(7)/log(2)", (5, 2): 5.925020606011,
              (5, 3): 4.962067051425, (6, 0): "11", (6, 2): 7.557805044029, (6, 3): 6.439966457203,
              (6, 4): 5.532503868901}
    for (m, l), exponent in pseudo.items():
        rows.append((f"pseudo-spline {m} {l}", 2, pseudo_spline(m, l), 2 * m, exponent, True))
    for k in range(2, 9):  # rho = 2 + k/2
        exponent = "2" if k == 4 else f"{k} - log({2 + Fraction(k, 2)})/log(2)"
        rows.append((f"hormann-sabin {k}", 2, hormann_sabin(k), k, exponent, k != 4))
    for n, order, exponent in ((2, 3, "2"), (3, 3, "3 - log(7/2)/log(2)"), (4, 5, "5 - log(9/2)/log(2)"),
                               (5, 5, 2.105578089833), (6, 7, 3.577233226027), (8, 9, 4.247259082082)):
        rows.append((f"dual {n}", 2, dual(n), order, exponent, True))
    points = {(3, 2): "1", (3, 4): "4 - log(11)/log(3)", (3, 6): 2.319856140753, (4, 2): "1", (4, 4): 1.707518749639,
              (4, 6): 2.099550050039, (5, 2): "1", (5, 4): 1.634787611028, (5, 6): 1.967086717445}
    for (m, n), exponent in points.items():
        rows.append((f"{m}-ary {n} points", m, interpolating(m, n), n, exponent, True))
    rows.append(("ternary 3 points", 3, ternary_three_points(), 3, "1", False))
    for b, order, exponent, attained in (("2/9", 3, "1", False), ("1/4", 2, 1.261859507142, True),
                                         ("3/11", 2, 1.411414589482, True), ("1/3", 2, "1", True)):
        rows.append((f"ternary 3 points, b={b}", 3, ternary_three_points_interpolating(q(b)), order, exponent,
                     attained))
    for mu, exponent, attained in (("1/15", "2", False), ("2/27", 2.052027830408, True), ("1/12", 2.121545511552, True),
                                   ("1/11", 2.182658338644, True), ("1/10", 2.095903274289, True), ("1/9", "2", None),
                                   ("0", 1.630929753571, True)):
        rows.append((f"ternary 4 points, mu={mu}", 3, ternary_four_points(q(mu)), 3, exponent, attained))
    for w, order, exponent, attained in (
            ("1/16", 4, "2", False), ("1/20", 2, "2 - log(1 + sqrt(5)/5)/log(2)", True),
            ("1/32", 2, "2 - log(1 + sqrt(2)/2)/log(2)", True), ("1/10", 2, 1.583705366958, True),
            ("1/8", 2, 1.385170963624, True), ("3/16", 2, 1.024423506418, True), ("19/100", 2, 1.012661900467, True),
            ("1/5", 2, 0.967138934041, True), ("-1/10", 2, "2 - log(1 + sqrt(65)/5)/log(2)", True)):
        rows.append((f"4 points, w={w}", 2, four_points(q(w)), order, exponent, attained))
    for t, order, exponent, attained in (
            ("3/256", 6, "6 - log(9)/log(2)", True), ("1/100", 4, 2.583422222481, True), ("1/64", 4, None, None),
            ("1/50", 4, None, None), ("1/200", 4, 2.218949330078, True), ("0", 4, "2", False),
            ("-1/100", 4, 1.704728397193, True)):
        rows.append((f"6 points, t={t}", 2, six_points(q(t)), order, exponent, attained))
    for w, order, exponent, attained in (
            ("-1/2", 4, "2", False), ("-1/4", 4, "4 - log(3)/log(2)", True), ("1/8", 4, "4 - log(3/2)/log(2)", True),
            ("1/4", 6, "5", True), ("3/10", 4, 3.922779641947, True), ("2/5", 4, 3.871943781410, True),
            ("3/4", 4, "4 - log(3/2)/log(2)", True), ("2", 4, "4 - log(6)/log(2)", True)):
        rows.append((f"quasi-spline, w={w}", 2, quasi_spline(q(w)), order, exponent, attained))
    return rows
