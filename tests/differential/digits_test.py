# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of 17 to 10 000 digits compared with mpmath: every digit is that of the correctly rounded number."""

import re
import sys
import unittest
from fractions import Fraction

import mpmath
from mpmath import mp, mpf
from support import ProgramTest

sys.set_int_max_str_digits(0)

CASES = (
    ("tension4", ("--v0=-2/5",), {"v": lambda: mpf(-2) / 5}),
    ("tension4", ("--v0", "1+1/10^40"), {"v": lambda: 1 + mpf(10) ** -40}),
    # 10^-12 from the singular value -1/2 of the step 0.
    ("interpolating:family=harmonic,l=3", ("--v0=-1/2+1/10^12",), {"v": lambda: -mpf(1) / 2 + mpf(10) ** -12}),
    ("interpolating:family=harmonic,l=4", ("--v0", "cosh(3/5)"), {"v": lambda: mpmath.cosh(mpf(3) / 5)}),
    ("interpolating:family=mixed,l=3", ("--t", "I*pi/7"), {"v": lambda: mpmath.cos(mp.pi / 7)}),
    ("interpolating:family=mixed,l=2,arity=3", ("--v0", "sqrt(2)"), {"v": lambda: mpmath.sqrt(2)}),
    ('interpolating:space="1,x,cos(s*x),sin(s*x),exp(t*x),exp(-t*x)"', ("--at", "s=1,t=sqrt(3)"),
     {"v_s": lambda: mpmath.cos(1), "v_t": lambda: mpmath.cosh(mpmath.sqrt(3))}),
    ('quasi-spline:space="1,x,x^2,exp(t*x),exp(-t*x)",omega=omega', ("--at", "omega=pi/40,v0=-1/3"),
     {"v": lambda: mpf(-1) / 3, "omega": lambda: mp.pi / 40}),
    ("dd:l=12", (), {}),
)


class Digits(ProgramTest):
    def wrong(self, scheme, arguments, values, digits, levels, spoil=False):
        """Numbers that are not the correctly rounded ones, and how many were looked at."""
        table = self.twoscale_json("table", scheme, *arguments, "--levels", str(levels), "--digits", str(digits))
        show = self.twoscale_json("show", scheme)
        if spoil:
            text = table["levels"][0]["coefficients"][0]
            table["levels"][0]["coefficients"][0] = text[:-1] + ("8" if text[-1] == "9" else str(int(text[-1]) + 1))
        code = [compile(re.sub(r"(?<!\*\*)\b(\d+)\b", r"mpf(\1)", c.replace("^", "**")), scheme, "eval")
                for c in show["symbol"]["coefficients"]]
        found = count = 0
        with mp.workdps(digits + 80):
            at = {name: value() for name, value in values.items()}
            m = table["arity"]
            for level in table["levels"]:
                for name in show["level_variables"]:
                    x = at[name]
                    angle = mpmath.acos(x) if x < 1 else mpmath.acosh(x)
                    at[name] = mpmath.cos(angle / m) if x < 1 else mpmath.cosh(angle / m)
                for c, text in zip(code, level["coefficients"]):
                    value = mpf(eval(c, {"mpf": mpf}, at))  # noqa: S307
                    count += 1
                    if value == 0:
                        found += text != "0"
                        continue
                    last = mpf(10) ** (mpmath.floor(mpmath.log10(abs(value))) - digits + 1)
                    found += abs(mpf(text) - value) > last * mpf("0.5000000001")
        return found, count

    def test_every_digit(self):
        for digits, levels in ((17, 8), (18, 8), (100, 8), (3000, 2)):
            for case in CASES:
                found, count = self.wrong(*case, digits, levels)
                self.assertEqual(found, 0, (case[0], digits))
                self.assertGreater(count, 0)
        self.assertEqual(self.wrong(*CASES[0], 100, 1, spoil=True)[0], 1)

    def test_ten_thousand_digits(self):
        for case in CASES[:8:2]:
            self.assertEqual(self.wrong(*case, 10000, 2)[0], 0, case[0])

    def test_ties_and_what_is_next_to_them(self):
        def coefficient(value, *arguments):
            table = self.twoscale_json("table", 'mask:coefficients="w, 1, w",lowest=-1', "--at", f"w={value}", "--levels", "1",
                                       *arguments)
            return table["limit"]["coefficients"][0]
        tie = "123456789012345675/10^18"
        for value, text in ((tie, "0.12345678901234568"), (f"-{tie}", "-0.12345678901234568"),
                            (f"{tie}-1/10^3000", "0.12345678901234567"), (f"{tie}+1/10^3000", "0.12345678901234568"),
                            (f"{tie}-exp(-3000)", "0.12345678901234567"), (f"{tie}+exp(-3000)", "0.12345678901234568")):
            self.assertEqual(coefficient(value, "--digits", "17"), text, value)
        even = "(1+1/2^53)"
        for value, double in ((even, 1.0), (f"{even}+1/2^3000", 1 + 2.0 ** -52), (f"{even}-exp(-2000)", 1.0),
                              (f"{even}+exp(-2000)", 1 + 2.0 ** -52), ("1/2^1075", 0.0), ("3/2^1076", 2.0 ** -1074),
                              ("(1+3/2^53)", 1 + 2.0 ** -51)):
            got = float(coefficient(value, "--double"))
            self.assertEqual(got, double, value)
        self.assertEqual(Fraction(float(coefficient("1/3", "--double"))), Fraction(1 / 3))


if __name__ == "__main__":
    unittest.main()
