# SPDX-License-Identifier: GPL-3.0-or-later
"""`spectrum` against PARI/GP: characteristic polynomial, its factors over Q(parameters), eigenvalues, eigenspaces."""

import unittest

from support import ProgramTest, pari, to_pari

SCHEMES = [
    ("dd:l=2",), ("dd:l=3",), ("dd:l=5",), ("dd:l=8",), ("bspline:n=5",), ("bspline:n=4,arity=3",),
    ('mask:coefficients="1/4,3/4,1,1/2,-1/3,1/7"',), ('mask:coefficients="1/4,1/3,1,1/2,1/3,1/7,-1/5,1/5",arity=3',),
    ("interpolating:family=harmonic,l=4", "--at", "v=3/2"),
    ('mask:coefficients="-w,0,1/2+w,1,1/2+w,0,-w"',), ('mask:coefficients="a,b,1,b,a"',), ("tension4", "--at", ""),
    ("interpolating:family=harmonic,l=3", "--at", ""), ("interpolating:family=mixed,l=3", "--at", ""),
]


def matrix(rows):
    return "[" + "; ".join(", ".join(to_pari(c) for c in row) for row in rows) + "]"


class Spectrum(ProgramTest):
    def test_factors(self):
        for arguments in SCHEMES:
            with self.subTest(arguments=arguments):
                d = self.twoscale_json("spectrum", *arguments)
                factors = d["characteristic_polynomial"]["factors"]
                product = "*".join(f"({to_pari(f)})^{m}" for f, m in factors)
                names = " ".join(f"{name};" for name in ("x", "a", "b", "v", "w"))  # x is the main variable
                one = "one(f) = vecsum([poldegree(g, 'x) > 0 | g <- factor(numerator(f))[,1]]) == 1"
                irreducible = " && ".join(f"one({to_pari(f)})" for f, _ in factors)
                code = f"{names} A={matrix(d['matrix'])};\n{one}\nprint([charpoly(A, 'x) == {product}, {irreducible}])"
                self.assertEqual(pari(code).splitlines()[-1], "[1, 1]")

    def test_eigenspaces(self):
        for arguments in SCHEMES:
            with self.subTest(arguments=arguments):
                d = self.twoscale_json("spectrum", *arguments)
                for e in d["eigenvalues"]:
                    p = to_pari(e["modulo"] if "modulo" in e else f"x - ({e['exact']})")
                    right = "[" + ", ".join(matrix([v]) + "~" for v in e["right"]) + "]"
                    left = "[" + ", ".join(matrix([v]) for v in e["left"]) + "]"
                    code = (f"x; a; b; v; w; A={matrix(d['matrix'])}; p={p}; R={right}; L={left}; good = 1; "
                            "for(i = 1, #R, y = A*R[i] - x*R[i]; for(j = 1, #y, good = good && y[j] % p == 0)); "
                            "for(i = 1, #L, y = L[i]*A - x*L[i]; for(j = 1, #y, good = good && y[j] % p == 0)); "
                            "print(good)")
                    self.assertEqual(pari(code), "1", e["exact"])
                    self.assertEqual(len(e["left"]), len(e["right"]))

    def test_numbers(self):
        for arguments in SCHEMES[:9]:
            with self.subTest(arguments=arguments):
                d = self.twoscale_json("spectrum", *arguments)
                mine = [e["decimal"] for e in d["eigenvalues"] for _ in range(e["multiplicity"])]
                values = "[" + ", ".join(mine) + "]"
                # Every root is met, and the moduli descend.
                code = (f"\\p 60\nA={matrix(d['matrix'])}; f=factor(charpoly(A, 'x)); M={values}; "
                        "r=concat(vector(#f~, i, concat(vector(f[i,2], k, polroots(f[i,1])~))));\n"
                        "near(z) = vecmin(vector(#M, k, abs(M[k] - z))) <= 1e-16*abs(z)\n"
                        "good = #r == #M; for(i = 1, #r, good = good && near(r[i])); "
                        "for(i = 2, #M, good = good && abs(M[i]) <= abs(M[i-1])*(1 + 1e-16)); print(good)")
                self.assertEqual(pari(code).splitlines()[-1], "1")


if __name__ == "__main__":
    unittest.main()
