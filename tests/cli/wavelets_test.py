# SPDX-License-Identifier: GPL-3.0-or-later
"""`two-scale`, `lifting` and `table --normalisation` from outside."""

import math
import random
import unittest

from support import ProgramTest, to_sympy

CIRCLE = 'exponential-bspline:space="1,cos(s*x),sin(s*x)"'
CONVOLUTION = 'mask:coefficients="1/4,(2*v+1)/4,(2*v+1)/4,1/4"'


def module(text):
    """The namespace of a generated Python module."""
    space = {}
    exec(compile(text, "generated", "exec"), space)  # noqa: S102: our own output
    return space


def product(a, b):
    c = [0.0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


class TwoScale(ProgramTest):
    def test_the_table_for_m_samples_per_turn(self):
        for m in range(4, 17):
            document = self.twoscale_json("two-scale", CIRCLE, "--at", f"s=2*pi/{m}", "--levels", "2", "--samples", "24")
            self.assertEqual(document["verdict"], "proved")
            self.assertEqual(document["residual"]["coefficients"], [])
            for level in document["double"]:
                self.assertLess(float(level["residual"]), 1e-14)
            table = self.twoscale_json("table", CIRCLE, "--at", f"s=2*pi/{m}", "--levels", "1", "--double")
            c = math.cos(math.pi / m)
            expected = [1 / (2 + 2 * c), (1 + 2 * c) / (2 + 2 * c)]
            for text, value in zip(table["levels"][0]["coefficients"], expected + expected[::-1]):
                self.assertAlmostEqual(float(text), value, delta=1e-15)

    def test_a_mask_normalised_by_four_is_refuted(self):
        document = self.twoscale_json("two-scale", CONVOLUTION, "--space", "1,cos(s*x),sin(s*x)", "--at", "s=2*pi/5",
                                      "--levels", "1", status=1)
        self.assertEqual(document["verdict"], "refuted")
        self.assertEqual(to_sympy(document["factor"]), to_sympy("(1+v)/2"))
        self.assertGreater(float(document["double"][0]["residual"]), 1e-2)
        # What it is: the mask of the convolutions without normalisation.
        table = self.twoscale_json("table", CIRCLE, "--at", "s=2*pi/5", "--levels", "1", "--normalisation", "convolution")
        self.assertEqual(table["levels"][0]["coefficients"][0], "0.25")
        self.assertIn("(v + 1)/2", table["printed"])

    def test_translated_masks_and_other_arities(self):
        large = self.twoscale_json("two-scale", 'mask:coefficients="1,3,3,1",lowest=4', "--space", "1,x,x^2", status=1)
        self.assertEqual((large["verdict"], large["factor"]), ("refuted", "4"))
        good = self.twoscale_json("two-scale", 'mask:coefficients="1/4,3/4,3/4,1/4",lowest=4', "--space", "1,x,x^2")
        self.assertEqual(good["verdict"], "proved")
        for level in good["double"]:
            self.assertLess(float(level["residual"]), 1e-15)
        self.twoscale("two-scale", 'exponential-bspline:arity=3,space="1,x,exp(t*x),exp(-t*x)"', "--t", "2")

    def test_refusals(self):
        self.refused("two-scale", CONVOLUTION, naming="--space")
        self.refused("two-scale", CIRCLE, "--space", "1,x", naming="its own space")
        self.refused("table", CIRCLE, "--at", "s=1", "--levels", "1", "--normalisation", "four", naming="four")
        self.refused("table", CIRCLE, "--at", "s=1", "--levels", "1", "--normalisation", "sum1", "--format", "c", naming="c ")


class Lifting(ProgramTest):
    def test_exact_document(self):
        document = self.twoscale_json("lifting", "tension4", "--vanishing", "1,x,exp(t*x),exp(-t*x)")
        self.assertEqual([s["type"] for s in document["steps"]], ["predict", "update"])
        predict, update = document["steps"]
        self.assertEqual((predict["lowest"], update["lowest"]), (-1, -2))
        for p, u in zip(predict["coefficients"], update["coefficients"]):
            self.assertEqual((to_sympy(u) + to_sympy(p) / 2).simplify(), 0)
        self.assertEqual(document["norm"], "1")
        self.assertEqual(document["no_dual"], [])

    def test_generated_modules_reconstruct(self):
        random.seed(4)
        for scheme, options in (("dd:l=2", ("--vanishing", "4")),
                                ("tension4", ("--vanishing", "2", "--v0", "3")),
                                ("tension4", ("--vanishing", "1,x,exp(t*x),exp(-t*x)", "--v0", "-2/5")),
                                ("bspline:n=3", ("--vanishing", "4")),
                                ("bspline:n=2", ("--vanishing", "3")),
                                ("mixed:n=1", ("--vanishing", "2", "--t", "1")),
                                (CIRCLE, ("--vanishing", "1", "--at", "s=2*pi/7")),
                                ('mask:coefficients="1/2,1,1/2"', ("--dual", 'mask:coefficients="-1/4,1/2,3/2,1/2,-1/4"'))):
            space = module(self.twoscale("lifting", scheme, *options, "--levels", "3", "--format", "python"))
            for k in range(5):
                for n in (2, 6, 32):
                    x = [random.uniform(-1, 1) for _ in range(n)]
                    s, d = space["analysis"](x, k)
                    for a, b in zip(x, space["synthesis"](s, d, k)):
                        self.assertAlmostEqual(a, b, delta=1e-13)
                dec_lo, dec_hi, rec_lo, rec_hi = space["pywavelets"](k)
                length = len(dec_lo)
                total = [a + b for a, b in zip(product(rec_lo, dec_lo), product(rec_hi, dec_hi))]
                for i, value in enumerate(total):
                    self.assertAlmostEqual(value, 2.0 if i == length - 1 else 0.0, delta=1e-13)
                turn = [(-1) ** i for i in range(length)]
                alias = [a + b for a, b in zip(product(rec_lo, [t * c for t, c in zip(turn, dec_lo)]),
                                               product(rec_hi, [t * c for t, c in zip(turn, dec_hi)]))]
                for value in alias:
                    self.assertAlmostEqual(value, 0.0, delta=1e-13)

    def test_samples_of_the_space_have_no_details(self):
        space = module(self.twoscale("lifting", "tension4", "--vanishing", "2", "--t", "3/10", "--levels", "2", "--double",
                                     "--format", "python"))
        # Level 1 has the spacing 1/2.
        x = [2 + i / 2 + math.exp(0.15 * i) - 3 * math.exp(-0.15 * i) for i in range(40)]
        s, d = space["analysis"](x, 0)
        for value in d[2:-2]:
            self.assertAlmostEqual(value, 0, delta=1e-12)
        for j in range(4, 16):
            self.assertAlmostEqual(s[j], x[2 * j], delta=1e-12)

    def test_level_tables_say_what_they_are(self):
        document = self.twoscale_json("lifting", "bspline:n=3", "--vanishing", "2", "--levels", "1", "--digits", "30")
        self.assertEqual([step["coefficients"][0] for step in document["levels"][0]["steps"]], ["-0.25", "-1", "0.1875"])
        self.assertEqual(document["levels"][0]["norm"], "0.5")
        self.assertAlmostEqual(sum(map(float, document["levels"][0]["rec_lo"])), math.sqrt(2), delta=1e-15)
        self.assertEqual(document["levels"][0]["dec_lo"], document["limit"]["dec_lo"])

    def test_no_dual_where_the_sub_symbols_share_a_zero(self):
        document = self.twoscale_json("lifting", "harmonic:n=2", "--vanishing", "2")
        expected = [{"v": "1/2", "level": "0", "v0": "-1/2"}, {"v": "sqrt(2)/2", "level": "0", "v0": "0"}]
        self.assertEqual([x for c in document["no_dual"] for x in c["at"]], expected)
        derived = self.twoscale_json("derive", "--space", "1,x,cos(s*x),sin(s*x),cos(2*s*x),sin(2*s*x)")
        self.assertEqual([(x["exact"], x["level"]) for x in derived["singular_v0"]], [("-1/2", 0), ("0", 0)])
        # A value that comes back at a finer level.
        document = self.twoscale_json("lifting", "harmonic:n=3")
        found = [(x["level"], x["v0"]) for c in document["no_dual"] for x in c["at"] if x["v"] == "sqrt(3)/2"]
        self.assertEqual(found, [("0", "1/2"), ("1", "-1/2")])
        self.refused("lifting", "harmonic:n=2", "--v0", "0", "--levels", "1", naming="v^0 = 0")
        self.assertIn("y + (1)", self.refused("lifting", 'mask:coefficients="1/4,1/2,1/2,1/2,1/4"'))

    def test_refusals(self):
        self.refused("lifting", "bspline:n=2,arity=3", naming="arity")
        self.refused("lifting", "dd:l=2", "--vanishing", "99", naming="99")
        self.refused("lifting", "dd:l=2", "--vanishing", "x", naming="missing: 1")
        self.refused("lifting", "dd:l=2", "--dual", "dd:l=2", naming="biorthogonal")
        self.refused("lifting", "dd:l=2", "--dual", "dd:l=2", "--vanishing", "2", naming="2")
        self.refused("lifting", "tension4", "--v0", "2", naming="--levels")
        self.refused("lifting", "tension4", "--levels", "2", naming="v^0")
        self.refused("lifting", "dd:l=2", "--format", "python", naming="--levels")


if __name__ == "__main__":
    unittest.main()
