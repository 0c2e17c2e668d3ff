# SPDX-License-Identifier: GPL-3.0-or-later
"""`derive --arity m` against PARI/GP: the generalised Vandermonde system of the definition, solved over Q(E).

Phase s of the rule has the weights c_h with sum_h c_h f(m h) = f(s) for f = x^r E^{n x}, (n, r) over the space; v = (E +
1/E)/2. No symbol, no symmetry, no level variable.
"""

import math
import random
import unittest
from fractions import Fraction

from support import ProgramTest, pari, to_pari

SPACES = {  # powers of x, and {multiple of t: order}
    "mixed": (2, {1: 1}),
    "four polynomials": (4, {}),
    "six": (2, {1: 1, 2: 1}),
    "mixed six": (4, {1: 1}),
    "repeated": (2, {1: 2}),
    "lacunary": (2, {1: 1, 3: 1}),
    "no constants": (0, {1: 1, 2: 1}),
    "repeated alone": (0, {2: 2}),
    "three": (1, {1: 1}),
    "five": (3, {1: 1}),
    "seven": (1, {1: 2, 2: 1}),
}


def space_text(order, exponentials):
    items = [f"x^{r}" for r in range(order)]
    for n, mu in exponentials.items():
        items += [f"x^{r}*exp({sign}{n}*t*x)" for r in range(mu) for sign in ("", "-")]
    return ",".join(items)


def functions(order, exponentials):
    return [(0, r) for r in range(order)] + \
        [(sign * n, r) for n, mu in exponentials.items() for r in range(mu) for sign in (1, -1)]


def value(n, r, x):
    power = "1" if r == 0 else f"({x})^{r}"
    return f"{power}*E^({n * x})"


class MaryDerive(ProgramTest):
    def compare(self, order, exponentials, m):
        document = self.twoscale_json("derive", "--space", space_text(order, exponentials), "--arity", m)
        zeta, lowest = document["zeta"]["coefficients"], document["zeta"]["lowest"]
        # v belongs to the greatest common frequency.
        common = math.gcd(*exponentials) or 1
        basis = functions(order, {a // common: mu for a, mu in exponentials.items()})
        n = len(basis)
        first = -(n // 2) if n % 2 else 1 - n // 2
        phases = range(-(m // 2), m // 2 + 1) if n % 2 else range(m)
        code = []
        for s in phases:
            rows = "; ".join(", ".join(value(a, r, m * (first + j)) for j in range(n)) for a, r in basis)
            rhs = ", ".join(value(a, r, s) for a, r in basis)
            mine = []
            for j in range(n):
                at = s - m * (first + j) - lowest
                mine.append(to_pari(zeta[at]) if 0 <= at < len(zeta) else "0")
            code.append(f"print(matsolve([{rows}], [{rhs}]~) == subst([{', '.join(mine)}], v, (E+1/E)/2)~)")
        # zeta = sigma omega, the Hessenberg and the folded system, their determinants.
        system, folded = document["system"], document["folded"]
        vector = lambda c: "[" + ", ".join(map(to_pari, c)) + "]"
        matrix = lambda rows: "[" + "; ".join(", ".join(map(to_pari, row)) for row in rows) + "]"
        half = document["omega"]["coefficients"][:len(folded["rhs"])]
        code.append(f"print(Pol({vector(document['sigma']['coefficients'])},z)*Pol({vector(document['omega']['coefficients'])},z)"
                    f" == Pol({vector(zeta)},z))")
        code.append(f"H={matrix(system['matrix'])}; print(H*{vector(system['solution'])}~ == {vector(system['rhs'])}~)")
        code.append(f"print(matdet(subst(H,v,7/5)) == subst({to_pari(system['determinant'])},v,7/5))")
        code.append(f"F={matrix(folded['matrix'])}; print(F*{vector(half)}~ == {vector(folded['rhs'])}~)")
        code.append(f"print(matdet(subst(F,v,7/5)) == subst({to_pari(folded['determinant'])},v,7/5))")
        answers = pari("z; v; E;" + "\n".join(code)).splitlines()
        self.assertEqual(answers, ["1"] * len(code))

    def test_spaces(self):
        for name, (order, exponentials) in SPACES.items():
            odd = order % 2 == 1
            for m in ((3, 5) if odd else (3, 4)):
                with self.subTest(space=name, m=m):
                    self.compare(order, exponentials, m)

    def test_random_spaces(self):
        rng = random.Random(20261125)
        for _ in range(6):
            order = rng.randrange(0, 4)
            exponentials = {n: rng.randrange(1, 3) for n in rng.sample(range(1, 5), rng.randrange(1, 3))}
            m = rng.choice((3, 5)) if order % 2 else rng.choice((3, 4, 5))
            with self.subTest(order=order, exponentials=exponentials, m=m):
                self.compare(order, exponentials, m)

    def test_the_determinant_vanishes_exactly_at_the_singular_values(self):
        """v^0 = cos(alpha pi) at level k is v = cos(alpha pi/m^{k+1}), a primitive root E of unity of order n."""
        for space, m in ((SPACES["six"], 3), (SPACES["lacunary"], 3), ((2, {2: 1, 5: 1}), 3), (SPACES["six"], 4)):
            text = space_text(*space)
            document = self.twoscale_json("derive", "--space", text, "--arity", m)
            listed = {(entry["exact"], entry["level"]) for entry in document["singular_v0"]}
            basis = functions(*space)
            top = max(a for a, _ in basis)
            found = set()
            # Two of the E^{m a} agree only if E is a root of unity of order at most 2 top m.
            for n in range(3, 2 * top * m + 1):
                for j in range(1, n // 2 + 1):
                    if math.gcd(j, n) != 1:
                        continue
                    for level in range(4):
                        alpha = Fraction(2 * j, n) * m ** (level + 1)
                        exponents = sorted({a for a, _ in basis})
                        clash = any((a - b) * m * j % n == 0 and (a - b) * j % n for a in exponents for b in exponents)
                        if 0 < alpha < 1 and clash:
                            found.add((self.cosine(alpha), level))
            self.assertEqual(listed, found, text)

    @staticmethod
    def cosine(alpha):
        known = {Fraction(1, 2): "0", Fraction(1, 3): "1/2", Fraction(2, 3): "-1/2"}
        top = "" if alpha.numerator == 1 else f"{alpha.numerator}*"
        return known.get(alpha, f"cos({top}pi/{alpha.denominator})")

    def test_two_frequencies_at_rational_points(self):
        text = "1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)"
        for m in (3, 4):
            document = self.twoscale_json("derive", "--space", text, "--arity", m)
            zeta, lowest = document["zeta"]["coefficients"], document["zeta"]["lowest"]
            basis = [("1", 0), ("1", 1), ("2", 0), ("1/2", 0), ("5/3", 0), ("3/5", 0)]
            code = []
            for s in range(m):
                rows = "; ".join(", ".join(f"({m * h})^{r}*({e})^({m * h})" if r else f"({e})^({m * h})" for h in range(-2, 4))
                                 for e, r in basis)
                rhs = ", ".join(f"{s}^{r}*({e})^{s}" if r else f"({e})^{s}" for e, r in basis)
                at = [s - m * h - lowest for h in range(-2, 4)]
                mine = ", ".join(to_pari(zeta[i]) if 0 <= i < len(zeta) else "0" for i in at)
                code.append(f"print(matsolve([{rows}], [{rhs}]~) == subst(subst([{mine}], v_s, 5/4), v_t, 17/15)~)")
            self.assertEqual(pari("\n".join(code)).splitlines(), ["1"] * m)
            self.assertEqual(document["singular"], [])


if __name__ == "__main__":
    unittest.main()
