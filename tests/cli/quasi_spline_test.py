# SPDX-License-Identifier: GPL-3.0-or-later
"""Quasi-splines from outside: derivation in every format, proofs and certificates, tables, curves, smoothness."""

import math
import os
import re
import tempfile
import unittest

from support import ProgramTest

FOUR = "1,x,exp(t*x),exp(-t*x)"
DUAL = f'quasi-spline:space="1,x,x^2,exp(t*x),exp(-t*x)",reproduce="{FOUR}"'


def fnv1a64(text):
    h = 0xcbf29ce484222325
    for byte in text.encode():
        h = (h ^ byte) * 0x100000001b3 % 2 ** 64
    return f"{h:016x}"


class Derive(ProgramTest):
    def test_document_of_a_dual_member(self):
        d = self.twoscale_json("derive", DUAL)
        self.assertEqual((d["format"], d["p"]), ("twoscale/derivation", "1/2"))
        self.assertEqual(d["space"], ["1", "x", "x^2", "exp(t*x)", "exp(-t*x)"])
        self.assertEqual(d["reproduced"], ["1", "x", "exp(t*x)", "exp(-t*x)"])
        self.assertEqual(d["level_variables"], {"v": "cosh(t/2/2^(k+1))"})  # of half the frequency
        self.assertEqual(d["system"]["nodes"], ["2", "4*v^2 - 2"])
        self.assertEqual([len(row) for row in d["system"]["matrix"]], [2, 2])
        self.assertEqual(d["system"]["matrix"][0][1], "0")
        self.assertEqual((d["beta"]["lowest"], d["q"]["lowest"], d["mask"]["lowest"]), (-2, -1, -3))
        self.assertEqual(d["singular_v0"], [{"exact": "0", "decimal": "0", "level": 0}])
        self.assertNotIn("factor", d)

    def test_a_free_parameter_has_a_factor_of_its_own(self):
        d = self.twoscale_json("derive", 'quasi-spline:space="1,x,x^2,x^3",omega=omega')
        self.assertEqual(d["q"], {"lowest": 0, "coefficients": ["1"]})
        self.assertEqual(d["factor"], {"lowest": -1, "coefficients": ["omega", "-(2*omega - 1)", "omega"]})

    def test_several_frequencies_have_conditions(self):
        space = "exp(s*x),exp(-s*x),exp(2*s*x),exp(-2*s*x),exp(t*x),exp(-t*x)"
        d = self.twoscale_json("derive", f'quasi-spline:space="{space}",reproduce="exp(t*x),exp(-t*x)"')
        self.assertEqual([c["condition"] for c in d["singular"]], ["2*v_s^2 + v_t - 1"])

    def test_other_formats(self):
        text = self.twoscale("derive", DUAL)
        for piece in ("M = 2", "jeong2013 (3)", "H row 1", "w_1 = ", "p = 1/2", "singular   v0 = 0 (level 0)"):
            self.assertIn(piece, text)
        latex = self.twoscale("derive", DUAL, "--format", "latex")
        self.assertEqual(latex.count("\\begin"), latex.count("\\end"))
        self.assertIn("2z^{1/2}/\\beta(z)", latex)
        markdown = self.twoscale("derive", DUAL, "--format", "md")
        for piece in ("## q", "## Mask", "Singular: 0 (level 0)"):
            self.assertIn(piece, markdown)

    def test_the_interpolating_member_is_recognised(self):
        self.assertIn("4-point interpolating", self.twoscale("derive", f'quasi-spline:space="{FOUR}"'))
        self.assertIn("interpolating scheme", self.twoscale("show", f'quasi-spline:space="{FOUR}"'))
        mask = self.twoscale_json("show", f'quasi-spline:space="{FOUR}"')["symbol"]
        self.assertEqual(mask, self.twoscale_json("show", "tension4")["symbol"])

    def test_what_the_primal_transform_shows(self):
        self.assertIn("factor of this scheme", self.twoscale("derive", 'de-rham:space="1,x,x^2,x^3"'))

    def test_refusals(self):
        self.refused("derive", 'quasi-spline:space="1,x",reproduce="1,x,x^2"', naming="x^2")
        self.refused("table", 'quasi-spline:space="1,x,x^2,x^3",omega=w', "--levels", "1", naming="w")
        self.refused("table", 'quasi-spline:space="1,exp(t*x),exp(-t*x)"', "--v0", "0", "--levels", "1", naming="0")


class Prove(ProgramTest):
    def test_more_than_its_part_is_refuted(self):
        self.twoscale("prove", f'quasi-spline:space="1,x,x^2,exp(t*x),exp(-t*x)",reproduce="1,x"', "--claim",
                      'reproduces="exp(t*x),exp(-t*x)"', status=1)
        # omega = -N/8 reproduces cubics from order 4 on only.
        cubic = 'reproduces="1,x,x^2,x^3"'
        self.twoscale("prove", 'quasi-spline:space="1,x,x^2,x^3",omega=-1/2', "--claim", cubic)
        self.twoscale("prove", 'quasi-spline:space="1,x,x^2",omega=-3/8', "--claim", cubic, status=1)

    def test_a_changed_mask_is_refused(self):
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "c.json")
            self.twoscale("prove", DUAL, "--certificate", file)
            self.check(file)
            with open(file, encoding="utf-8") as f:
                text = f.read()
            changed = text.replace("2*v^2+2*v+1", "2*v^2+2*v+3").replace("2*v^2-2*v-1", "2*v^2-2*v-3")
            self.assertNotEqual(changed, text)
            changed = re.sub('"fnv1a64:[0-9a-f]*"', '""', changed)
            changed = changed.replace('"digest": ""', f'"digest": "fnv1a64:{fnv1a64(changed)}"')
            with open(file, "w", encoding="utf-8") as f:
                f.write(changed)
            self.check(file, status=1)


class Curves(ProgramTest):
    def refined(self, scheme, *arguments):
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "in.csv")
            with open(file, "w", encoding="utf-8") as f:
                f.write("1,0\n0,1\n-1,0\n0,-1\n")
            text = self.twoscale("refine", scheme, "--levels", "6", *arguments, file)
        return [tuple(map(float, line.split(","))) for line in text.splitlines() if not line.startswith("x")]

    def test_circles_from_four_points(self):
        """Primal and dual, with the frequency named: a quarter turn a step."""
        four = "1,x,cos(t*x),sin(t*x)"
        for scheme in (f'quasi-spline:space="{four}"', f'dual:space="{four}"', f'de-rham:space="{four}"',
                       f'quasi-spline:space="{four},x*cos(t*x),x*sin(t*x)",reproduce="cos(t*x),sin(t*x)"'):
            points = self.refined(scheme, "--at", "t=pi/2")
            self.assertEqual(len(points), 256)
            self.assertLess(max(abs(math.hypot(*p) - 1) for p in points), 1e-13, scheme)

    def test_without_reproduction_the_circle_shrinks(self):
        points = self.refined('quasi-spline:space="1,x,cos(t*x),sin(t*x)",reproduce="1,x"', "--at", "t=pi/2")
        self.assertLess(max(math.hypot(*p) for p in points), 0.9)

    def test_fit_names_the_lowest_frequency(self):
        """Samples belong to cos(t) for a dual scheme too, whose v^0 is cos(t/2)."""
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "in.csv")
            with open(file, "w", encoding="utf-8") as f:
                f.writelines(f"{math.cos((j + .5) / 2)!r},{math.sin((j + .5) / 2)!r}\n" for j in range(12))
            d = self.twoscale_json("fit", 'dual:space="1,x,cos(t*x),sin(t*x)"', file)
        self.assertAlmostEqual(float(d["v0"]), math.cos(.25), 12)
        self.assertAlmostEqual(float(d["t"]), .25, 12)

    def test_tables(self):
        d = self.twoscale_json("table", f'quasi-spline:space="{FOUR}",tension=w', "--at", "w=1/2,v0=1", "--levels", "1",
                               "--digits", "20")
        # (26) with gamma_2 = 2, t = 1/2
        self.assertEqual([float(c) for c in d["levels"][0]["coefficients"]],
                         [-1 / 32, 1 / 16, 17 / 32, 7 / 8, 17 / 32, 1 / 16, -1 / 32])

    def test_a_table_names_the_frequency_that_t_sets(self):
        half = self.twoscale_json("table", DUAL, "--t", "1/2", "--levels", "1")
        self.assertEqual(half["parameters"], {"t/2": "1/2"})
        whole = self.twoscale_json("table", DUAL, "--at", "t=1", "--levels", "1")
        self.assertEqual(whole["parameters"], {"t": "1"})
        self.assertEqual(half["levels"], whole["levels"])

    def test_pictures(self):
        for scheme in (f'quasi-spline:space="{FOUR}",tension=1/2', DUAL):
            self.assertIn("<svg", self.twoscale("plot", "basic", scheme, "--v0", "2"))


class Smoothness(ProgramTest):
    def test_exponents(self):
        cases = [(f'quasi-spline:space="{FOUR}",tension=1/2', "4 - log(3)/log(2)", 2),
                 (DUAL, "5 - log(9/2)/log(2)", 2),
                 ('quasi-spline:space="1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)",reproduce="1,x"', None, 4)]
        for scheme, exact, continuity in cases:
            d = self.twoscale_json("regularity", scheme)
            self.assertEqual(d["continuity"], continuity, scheme)
            if exact:
                self.assertEqual(d["hoelder"]["exact"], exact)

    def test_along_omega(self):
        """jeong2013, Theorem 3.1 and Figure 3: 2 - 4 omega up to 1/4; the quintic B-spline there has exponent 5, not 4."""
        text = self.twoscale("regularity", 'quasi-spline:space="1,x,x^2,x^3",omega=omega', "--over", "omega=[-7/2,1/4]")
        self.assertIn("rho = -2*(2*omega - 1)", text)
        self.assertIn("omega = 1/4: sum rules of order 6, C^4, Hölder 5 exactly", text)

    def test_exponents_of_theorem_31_need_not_be_attained(self):
        """omega = -1/2, Deslauriers and Dubuc: C^2 in the paper's sense would be a Lipschitz derivative."""
        d = self.twoscale_json("regularity", 'quasi-spline:space="1,x,x^2,x^3",omega=-1/2')
        self.assertEqual((d["hoelder"]["exact"], d["continuity"]), ("2", 1))


if __name__ == "__main__":
    unittest.main()
