# SPDX-License-Identifier: GPL-3.0-or-later
"""The oracles are there and read the project's expressions: SymPy after ^ -> **, PARI/GP after pi -> Pi."""

import unittest

import sympy

from support import pari, to_pari, to_sympy


class Oracles(unittest.TestCase):
    def test_sympy(self):
        self.assertEqual(to_sympy("(0.4 + 1/2)^2"), sympy.Rational(81, 100))
        self.assertEqual(sympy.simplify(to_sympy("2*cos(pi/5) - 1/2 - sqrt(5)/2")), 0)

    def test_pari(self):
        self.assertEqual(pari("print(polresultant(x^2 - 2, x^2 - 3))"), "1")
        self.assertEqual(pari(f"print({to_pari('abs(2*cos(pi/5) - 1/2 - sqrt(5)/2)')} < 1e-30)"), "1")


if __name__ == "__main__":
    unittest.main()
