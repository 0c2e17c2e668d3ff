# SPDX-License-Identifier: GPL-3.0-or-later
"""Filter banks, moments and the two-scale relation against PARI/GP, which multiplies them out."""

import random
import unittest

from support import ProgramTest, pari, to_pari


def laurent(document, variable="z"):
    """PARI text of {"lowest", "coefficients"}."""
    return "(" + "+".join(f"({to_pari(c)})*{variable}^({document['lowest'] + i})"
                          for i, c in enumerate(document["coefficients"])) + ")"


def space_polynomial(zeros, pairs):
    """prod (z - e^{theta/2^{k+1}}) in v: zeros times 1 and the pairs T_n(v)."""
    return f"(z-1)^{zeros}" + "".join(f"*(z^2-2*polchebyshev({n},1,v)*z+1)" for n in pairs)


class Banks(ProgramTest):
    def check_bank(self, scheme, *options, annihilates):
        f = self.twoscale_json("lifting", scheme, *options)["filters"]
        code = "z;v;" + "".join(f"{name}=((z)->{laurent(f[name])});" for name in "abLH")
        code += "print(a(z)*L(1/z)+b(z)*H(1/z)==2);print(a(z)*L(-1/z)+b(z)*H(-1/z)==0);"
        code += f"B=numerator(b(z));print(B%({annihilates})==0)"
        self.assertEqual(pari(code).split(), ["1", "1", "1"], scheme)

    def test_schemes_of_the_catalogue(self):
        self.check_bank("tension4", "--vanishing", "1,x,exp(t*x),exp(-t*x)", annihilates=space_polynomial(2, [1]))
        self.check_bank("interpolating:family=harmonic,l=3", "--vanishing", "1,x,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)",
                        annihilates=space_polynomial(2, [1, 2]))
        self.check_bank("resonant:n=2", "--vanishing", "1,x,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)",
                        annihilates=space_polynomial(2, [1, 1]))
        self.check_bank("mixed:n=2", "--vanishing", "3", annihilates=space_polynomial(3, []))
        self.check_bank("bspline:n=5", "--vanishing", "exp(t*x),exp(-t*x)", annihilates=space_polynomial(0, [1]))

    def test_random_masks(self):
        random.seed(9)
        done = 0
        while done < 12:
            n = random.randint(2, 8)
            mask = [random.randint(-4, 4) for _ in range(n)]
            if mask[0] == 0 or mask[-1] == 0 or sum(mask) == 0:
                continue
            even, odd = mask[0::2], mask[1::2]
            common = pari(f"g=gcd(Polrev({even}),Polrev({odd}));print(g/x^valuation(g,x))")
            moments = random.randint(0, 3)
            name = "mask:coefficients=\"" + ",".join(map(str, mask)) + f"\",lowest={random.randint(-3, 3)}"
            if "x" in common:
                self.assertIn("common zero", self.refused("lifting", name))
                continue
            options = ("--vanishing", str(moments)) if moments else ()
            self.check_bank(name, *options, annihilates=f"(z-1)^{moments}")
            done += 1


class TwoScale(ProgramTest):
    def test_sigma_of_spaces(self):
        # E = e^{theta/m^{k+1}}, v = (E + 1/E)/2: a(z) prod (1 - E z) S_m(E)/m = prod (1 - E^m z^m), a from index 0.
        for space, factors in (("1,cos(s*x),sin(s*x)", ["1", "E", "1/E"]),
                               ("1,x,exp(t*x),exp(-t*x)", ["1", "1", "E", "1/E"]),
                               ("exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)", ["E", "1/E", "E^2", "E^-2"])):
            for m in (2, 3):
                scheme = f'exponential-bspline:arity={m},space="{space}"'
                self.assertEqual(self.twoscale_json("two-scale", scheme)["verdict"], "proved")
                a = dict(self.twoscale_json("show", scheme)["symbol"], lowest=0)
                code = f"z;v=(E+1/E)/2;S=(x->sum(i=0,{m - 1},x^i));f=[{','.join(factors)}];a={laurent(a)};"
                code += f"print(a*prod(i=1,#f,(1-f[i]*z)*S(f[i]))/{m}==prod(i=1,#f,1-f[i]^{m}*z^{m}))"
                self.assertEqual(pari(code), "1", scheme)


if __name__ == "__main__":
    unittest.main()
