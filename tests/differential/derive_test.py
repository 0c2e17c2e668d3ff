# SPDX-License-Identifier: GPL-3.0-or-later
"""`derive` against PARI/GP and SymPy.

The independent construction: a_{+-m}, m = 1, 3, .., 2l-1, of the 2l-point scheme solve sum_m 2 a_m T_m(w) = 1 at the nodes w
= cosh(theta/2^{k+1}) of the space, with as many derivatives in w as the node is repeated. PARI solves that system over Q(v).
"""

import unittest

from support import ProgramTest, pari, to_pari, to_sympy

FAMILIES = {
    "mixed": lambda l: [("1", l - 1), ("v", 1)],
    "harmonic": lambda l: [("1", 1)] + [(f"polchebyshev({j},1,v)", 1) for j in range(1, l)],
    "resonant": lambda l: [("1", 1), ("v", l - 1)],
}


def zeta_by_pari(nodes, l):
    """PARI code for the vector of a_m, m = 1, 3, .., 2l-1."""
    rows = "; ".join(
        ", ".join(f"subst({derivative(2 * m + 1, j)},x,{w})" for m in range(l))
        for w, multiplicity in nodes for j in range(multiplicity))
    rhs = ", ".join("1" if j == 0 else "0" for _, multiplicity in nodes for j in range(multiplicity))
    return f"matsolve([{rows}], [{rhs}]~)/2"


def derivative(m, j):
    code = f"polchebyshev({m},1,x)"
    for _ in range(j):
        code = f"deriv({code},x)"
    return code


def vector(coefficients):
    return "[" + ", ".join(to_pari(c) for c in coefficients) + "]"


def matrix(rows):
    return "[" + "; ".join(", ".join(to_pari(c) for c in row) for row in rows) + "]"


class Derive(ProgramTest):
    def compare(self, nodes, l, document):
        zeta = document["zeta"]["coefficients"]
        middle = -document["zeta"]["lowest"]
        self.assertEqual(middle, 2 * l - 1)
        self.assertEqual(len(zeta), 4 * l - 1)
        self.assertEqual(zeta[middle], "1")
        odd = [zeta[middle + m] for m in range(1, 2 * l, 2)]
        self.assertEqual(odd, [zeta[middle - m] for m in range(1, 2 * l, 2)])
        self.assertTrue(all(zeta[middle + m] == "0" for m in range(2, 2 * l, 2)))
        self.assertEqual(pari(f"print({zeta_by_pari(nodes, l)} == {vector(odd)}~)"), "1")
        # zeta = sigma * omega as polynomials in z; sigma(1) = 2.
        sigma, omega = (f"Pol({vector(document[name]['coefficients'])},z)" for name in ("sigma", "omega"))
        # PARI wants the main variable declared first: z before v.
        self.assertEqual(pari(f"z; v; print({sigma}*{omega} == Pol({vector(zeta)},z)); print(subst({sigma},z,1) == 2)"), "1\n1")
        # The Hessenberg system: H w = rhs, and its determinant.
        system = document["system"]
        h = matrix(system["matrix"])
        self.assertEqual(
            pari(f"H={h}; print(H*{vector(system['solution'])}~ == {vector(system['rhs'])}~); "
                 f"print(matdet(subst(H,v,7/5)) == subst({to_pari(system['determinant'])},v,7/5))"), "1\n1")
        # The folded system has the same omega (papers' indices 0..l-1) for its solution.
        folded = document["folded"]
        rhs = vector(folded["rhs"])
        half = vector(document["omega"]["coefficients"][:l])
        self.assertEqual(
            pari(f"F={matrix(folded['matrix'])}; print(F*{half}~ == {rhs}~); "
                 f"print(matdet(subst(F,v,7/5)) == subst({to_pari(folded['determinant'])},v,7/5))"), "1\n1")
        self.assertEqual(folded["hessenberg"], l < 4)

    def test_families_against_pari(self):
        for family, nodes in FAMILIES.items():
            for l in range(2, 9):
                with self.subTest(family=family, l=l):
                    document = self.twoscale_json("derive", f"interpolating:family={family},l={l}")
                    self.compare(nodes(l), l, document)

    def test_other_spaces_against_pari(self):
        cases = {
            "1,x,exp(t*x),exp(-t*x),exp(3*t*x),exp(-3*t*x)": [("1", 1), ("v", 1), ("polchebyshev(3,1,v)", 1)],
            "1,x,x^2,x^3,cos(t*x),sin(t*x),x*cos(t*x),x*sin(t*x)": [("1", 2), ("v", 2)],
            "exp(t*x/2),exp(-t*x/2),exp(t*x/3),exp(-t*x/3)": [("polchebyshev(2,1,v)", 1), ("polchebyshev(3,1,v)", 1)],
            "1,x,exp(2*t*x),exp(-2*t*x),x*exp(2*t*x),x*exp(-2*t*x),exp(5*t*x),exp(-5*t*x)":
                [("1", 1), ("polchebyshev(2,1,v)", 2), ("polchebyshev(5,1,v)", 1)],
        }
        for space, nodes in cases.items():
            with self.subTest(space=space):
                document = self.twoscale_json("derive", "--space", space)
                self.compare(nodes, sum(m for _, m in nodes), document)

    def test_two_frequencies_against_sympy(self):
        import sympy
        document = self.twoscale_json("derive", "--space", "1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)")
        vs, vt = sympy.symbols("v_s v_t")
        a = [to_sympy(document["zeta"]["coefficients"][5 + m]) for m in (1, 3, 5)]
        for w in (sympy.Integer(1), vs, vt):
            total = sum(2 * c * sympy.chebyshevt(m, w) for c, m in zip(a, (1, 3, 5)))
            self.assertEqual(sympy.cancel(total - 1), 0)
        self.assertEqual(document["singular"], [])

    def test_linsolve_of_the_folded_system(self):
        import sympy
        for family in FAMILIES:
            for l in (2, 3, 4):
                document = self.twoscale_json("derive", f"interpolating:family={family},l={l}")
                folded = sympy.Matrix([[to_sympy(c) for c in row] for row in document["folded"]["matrix"]])
                rhs = sympy.Matrix([to_sympy(c) for c in document["folded"]["rhs"]])
                (solution,) = sympy.linsolve((folded, rhs), *sympy.symbols(f"o0:{l}"))
                for mine, theirs in zip(document["omega"]["coefficients"], solution):
                    self.assertEqual(sympy.cancel(to_sympy(mine) - theirs), 0)
                self.assertEqual(sympy.cancel(folded.det() - to_sympy(document["folded"]["determinant"])), 0)


if __name__ == "__main__":
    unittest.main()
