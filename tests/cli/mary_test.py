# SPDX-License-Identifier: GPL-3.0-or-later
"""Arity 3 and more from outside: derive, prove and check, tabulate, refine with every end rule, fit, circles."""

import math
import os
import re
import tempfile
import unittest

from support import ProgramTest, run

TERNARY = "tension4:arity=3"


class Mary(ProgramTest):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)

    def path(self, name):
        return os.path.join(self.directory.name, name)

    def points(self, rows):
        path = self.path(f"points{len(os.listdir(self.directory.name))}.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(",".join(map(repr, row)) + "\n" for row in rows)
        return path

    @staticmethod
    def rows(text):
        return [tuple(map(float, line.split(","))) for line in text.splitlines() if re.match(r"[-+.\d]", line)]

    def polygon(self, n, turns=1):
        return self.points([(math.cos(2 * math.pi * turns * j / n), math.sin(2 * math.pi * turns * j / n)) for j in range(n)])


class Derive(Mary):
    def test_the_ternary_four_point_scheme(self):
        d = self.twoscale_json("derive", "--space", "1,x,exp(t*x),exp(-t*x)", "--arity", "3")
        self.assertEqual(d["scheme"], 'interpolating:arity=3,space="1, x, exp(t*x), exp(-t*x)"')
        self.assertEqual((d["arity"], d["p"], d["singular_v0"]), (3, "0", []))
        self.assertEqual(d["level_variables"], {"v": "cosh(t/3^(k+1))"})
        self.assertEqual((d["zeta"]["lowest"], len(d["zeta"]["coefficients"])), (-5, 11))
        self.assertEqual((len(d["sigma"]["coefficients"]), len(d["omega"]["coefficients"])), (9, 3))
        for name in ("tension4:arity=3", "interpolating:family=mixed,l=2,arity=3", "mixed:n=1,arity=3"):
            self.assertEqual(self.twoscale_json("derive", name)["zeta"], d["zeta"])

    def test_singular_values_in_every_format(self):
        space = ("--space", "1,x,cos(t*x),sin(t*x),cos(2*t*x),sin(2*t*x)", "--arity", "3")
        d = self.twoscale_json("derive", *space)
        self.assertEqual([(s["exact"], s["level"]) for s in d["singular_v0"]], [("-1/2", 0), ("0", 0)])
        self.assertIn("cannot start from N = 3 4 points", self.twoscale("derive", *space))
        self.assertIn("T_{3}", self.twoscale("derive", *space, "--format", "latex"))
        self.assertIn("Singular: -1/2 (level 0), 0 (level 0)", self.twoscale("derive", *space, "--format", "md"))

    def test_conditions_of_two_frequencies(self):
        space = "1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)"
        for arity in (3, 4, 5):
            self.assertEqual(self.twoscale_json("derive", "--space", space, "--arity", arity)["singular"], [])
        d = self.twoscale_json("derive", "--space", space + ",exp(2*t*x),exp(-2*t*x)", "--arity", "3")
        self.assertIn("v_s", "".join(c["condition"] for c in d["singular"]))

    def test_odd_dimensions(self):
        self.assertIn("no interpolating scheme", self.twoscale("derive", "--space", "1,x,x^2", "--arity", "4"))
        d = self.twoscale_json("derive", "--space", "1,x,x^2", "--arity", "3")  # Hassan and Dodgson's ternary 3-point rule
        self.assertEqual(d["zeta"]["coefficients"], ["-1/9", "0", "2/9", "8/9", "1", "8/9", "2/9", "0", "-1/9"])
        self.refused("show", 'interpolating:space="1,x,x^2",arity=4', naming="1, x, x^2")
        self.refused("derive", "--space", "1,x", "--arity", "65", naming="65")


class Prove(Mary):
    SCHEMES = [TERNARY, "tension4:arity=4", "interpolating:family=harmonic,l=3,arity=3",
               "interpolating:family=resonant,l=3,arity=3", "dd:l=2,arity=3", "dd:l=3,arity=5",
               'interpolating:space="1,cos(t*x),sin(t*x)",arity=3', 'interpolating:space="1,x,x^2",arity=3',
               'interpolating:space="1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)",arity=3',
               'interpolating:space="1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)",arity=4']
    SPLINES = ["1,exp(t*x),exp(-t*x)", "1,x,exp(t*x),exp(-t*x)", "1,x,x^2,exp(t*x),exp(-t*x)"]

    def proved(self, scheme):
        file = self.path("certificate.json")
        d = self.twoscale_json("prove", scheme, "--certificate", file)
        self.assertEqual({c["verdict"] for c in d["claims"]}, {"proved"}, scheme)
        self.assertIn("valid", self.check(file))
        return d, file

    def test_all_claims_and_certificates(self):
        for scheme in self.SCHEMES:
            with self.subTest(scheme=scheme):
                d, _ = self.proved(scheme)
                self.assertLessEqual({"interpolatory", "symmetric", "generates", "reproduces", "maximal", "well-defined"},
                                     {c["claim"] for c in d["claims"]})

    def test_exponential_splines_of_any_arity(self):
        """sigma is primal unless the arity is even and the dimension odd; then p = 1/(2m-2)."""
        for space in self.SPLINES:
            for m in (3, 4, 5):
                name = f'exponential-bspline:space="{space}",arity={m}'
                with self.subTest(scheme=name):
                    self.proved(name)
                    dual = m % 2 == 0 and len(space.split(",")) % 2 == 1
                    self.assertEqual(self.twoscale_json("derive", name)["p"], f"1/{2 * m - 2}" if dual else "0")

    def test_exceptions_are_the_singular_values(self):
        d, file = self.proved("interpolating:family=harmonic,l=3,arity=3")
        claim = [c for c in d["claims"] if c["claim"] == "well-defined"][0]
        self.assertEqual(claim["exceptions"], ["v0 = -1/2 (level 0)", "v0 = 0 (level 0)"])
        d, _ = self.proved(TERNARY)
        self.assertEqual([c for c in d["claims"] if c["claim"] == "well-defined"][0]["exceptions"], [])

    def test_a_changed_mask_is_refused(self):
        _, file = self.proved(TERNARY)
        with open(file, encoding="utf-8") as f:
            text = f.read()
        for old, new in (('"arity": 3', '"arity": 2'), ('"arity":3', '"arity":4')):
            if old not in text:
                continue
            with open(file, "w", encoding="utf-8") as f:
                f.write(text.replace(old, new))
            self.assertNotEqual(0, self.status_of_check(file))
            return
        self.fail("the certificate does not say its arity")

    @staticmethod
    def status_of_check(file):
        return run("twoscale-check", file).returncode

    def test_what_is_not_reproduced(self):
        self.twoscale("prove", TERNARY, "--claim", "reproduces=1,x,x^2,exp(t*x),exp(-t*x)", status=1)
        self.twoscale("prove", "dd:l=2,arity=3", "--claim", "reproduces=1,x,x^2,x^3,x^4", status=1)
        self.twoscale("prove", "tension4", "--claim", "reproduces=1,x,exp(t*x),exp(-t*x)")


class Table(Mary):
    def test_recurrence_and_limit(self):
        import mpmath
        mpmath.mp.dps = 50
        for m in (3, 4):
            d = self.twoscale_json("table", f"tension4:arity={m}", "--v0", "-2/5", "--levels", "3", "--digits", "40")
            self.assertEqual(d["arity"], m)
            angle = mpmath.acos(mpmath.mpf(-2) / 5)
            for level in d["levels"]:
                k, low, a = level["k"], level["lowest"], [mpmath.mpf(c) for c in level["coefficients"]]
                for theta, power in ((0, 0), (0, 1), (angle, 0), (-angle, 0)):
                    e = mpmath.exp(mpmath.mpc(0, theta) / mpmath.mpf(m) ** (k + 1))
                    f = lambda x: mpmath.mpf(x) ** power * e ** x
                    for s in range(m):
                        total = sum(c * f(m * ((s - (low + i)) // m)) for i, c in enumerate(a) if (s - low - i) % m == 0)
                        self.assertLess(abs(total - f(s)), mpmath.mpf("1e-37"))
            last = d["levels"][-1]
            self.assertEqual(d["tail"]["from"], 3)
            self.assertLess(float(d["tail"]["bound"]), 1e-2)
        self.assertEqual(d["limit"]["lowest"], -7)

    def test_ternary_limit_is_lagrange(self):
        d = self.twoscale_json("table", TERNARY, "--v0", "2", "--levels", "2", "--double")
        expected = [-4, -5, 0, 30, 60, 81, 60, 30, 0, -5, -4]
        self.assertEqual([float(c) for c in d["limit"]["coefficients"]], [c / 81 for c in expected])

    def test_a_singular_level_is_refused(self):
        scheme = "interpolating:family=harmonic,l=3,arity=3"
        self.assertIn("k = 0", self.refused("table", scheme, "--v0", "-1/2", "--levels", "3", naming="-1/2"))
        self.assertIn("k = 1", self.refused("table", 'interpolating:space="1,x,cos(t*x),sin(t*x),cos(8*t*x),sin(8*t*x)",arity=3',
                                            "--v0", "cos(6*pi/7)", "--levels", "3"))


class Refine(Mary):
    def test_a_circle_from_every_regular_polygon(self):
        """No v^0 > -1 is singular, so every N >= 3 and every star polygon of fewer than half a turn a step serves."""
        for m, levels in ((3, 4), (4, 3), (5, 3)):
            for n in range(3, 13):
                out = self.rows(self.twoscale("refine", f"tension4:arity={m}", "--v0", f"cos(2*pi/{n})", "--levels", levels,
                                              self.polygon(n)))
                self.assertEqual(len(out), n * m ** levels)
                for j, (x, y) in enumerate(out):
                    t = 2 * math.pi * j / len(out)
                    self.assertAlmostEqual(x, math.cos(t), delta=1e-14)
                    self.assertAlmostEqual(y, math.sin(t), delta=1e-14)
        for n, turns in ((5, 2), (7, 3), (12, 5)):
            out = self.rows(self.twoscale("refine", TERNARY, "--v0", f"cos({2 * turns}*pi/{n})", "--levels", "4",
                                          self.polygon(n, turns)))
            for x, y in out:
                self.assertAlmostEqual(math.hypot(x, y), 1, delta=1e-13)

    def test_circles_from_three_points(self):
        """{1, cos, sin} has the ternary 3-point rule."""
        for n in range(3, 9):
            out = self.rows(self.twoscale("refine", 'interpolating:space="1,cos(t*x),sin(t*x)",arity=3', "--v0",
                                          f"cos(2*pi/{n})", "--levels", "4", self.polygon(n)))
            self.assertTrue(all(abs(math.hypot(x, y) - 1) < 1e-14 for x, y in out))

    def test_the_binary_recurrence_makes_no_circle(self):
        """Each step of {1, x, e^{+-tx}} is unique; with v^{k+1} = sqrt((1 + v^k)/2) the second belongs to another t."""
        n = 6
        right = self.rows(self.twoscale("refine", TERNARY, "--v0", "1/2", "--levels", "1", self.polygon(n)))
        path = self.points(right)
        half = self.rows(self.twoscale("refine", TERNARY, "--v0", "cos(pi/6)", "--levels", "1", path))
        third = self.rows(self.twoscale("refine", TERNARY, "--v0", "cos(pi/9)", "--levels", "1", path))
        self.assertGreater(max(abs(math.hypot(x, y) - 1) for x, y in half), 1e-6)
        self.assertLess(max(abs(math.hypot(x, y) - 1) for x, y in third), 1e-15)

    def test_open_ends(self):
        f = lambda t: (t, math.cosh(0.4 * t), math.exp(0.4 * t))
        for m in (3, 4):
            for scheme, beyond, v0 in ((f"tension4:arity={m}", 2, ("--v0", "cosh(2/5)")),
                                       (f"interpolating:family=harmonic,l=3,arity={m}", None, ("--v0", "cosh(2/5)")),
                                       ("interpolating:space=\"1,x,x^2,exp(t*x),exp(-t*x)\",arity=3", None, ("--v0", "cosh(2/5)"))):
                with self.subTest(scheme=scheme):
                    arity = 3 if "arity=3" in scheme else m
                    space = self.points([f(j) for j in range(8)])
                    out = self.rows(self.twoscale("refine", scheme, *v0, "--levels", "3", "--open=space", space))
                    self.assertEqual(len(out), 7 * arity ** 3 + 1)
                    for i, row in enumerate(out):
                        for a, b in zip(row, f(i / arity ** 3)):
                            self.assertAlmostEqual(a, b, delta=1e-11)
                    for ends in ([beyond] if beyond else range(1, 8)):
                        given = self.points([f(j) for j in range(-ends, 6 + ends)])
                        try:
                            out = self.rows(self.twoscale("refine", scheme, *v0, "--levels", "3", "--open=given", given))
                        except AssertionError:
                            if beyond:
                                raise
                            continue
                        for row in out:
                            for a, b in zip(row, f(row[0])):
                                self.assertAlmostEqual(a, b, delta=1e-12)
                        break
                    else:
                        self.fail("no number of points beyond the ends serves")
                    line = self.points([(j, 2.0 * j + 1) for j in range(6)])
                    out = self.rows(self.twoscale("refine", scheme, *v0, "--levels", "2", "--open=linear", line))
                    self.assertEqual(len(out), 5 * arity ** 2 + 1)
                    for i, (x, y) in enumerate(out):
                        self.assertAlmostEqual(x, i / arity ** 2, delta=1e-13)
                        self.assertAlmostEqual(y, 2 * x + 1, delta=1e-13)

    def test_dual_splines_of_arity_four(self):
        """A dual sigma of {1, x, ..} reproduces straight lines with data at (j + p)/m^k."""
        for space, m in (("1,x,x^2", 4), ("1,x,x^2,exp(t*x),exp(-t*x)", 4)):
            values = ("--v0", "3/2") if "t" in space else ()
            p = 1 / (2 * m - 2)
            line = self.points([(j + p, 3 - (j + p)) for j in range(9)])
            for rule in ("linear", "space"):
                out = self.rows(self.twoscale("refine", f'exponential-bspline:space="{space}",arity={m}', *values, "--levels", "2",
                                              f"--open={rule}", line))
                if rule == "space":
                    steps = [b[0] - a[0] for a, b in zip(out, out[1:])]
                    self.assertTrue(all(abs(s - 1 / m ** 2) < 1e-12 for s in steps))
                for x, y in out:
                    self.assertAlmostEqual(y, 3 - x, delta=1e-12)

    def test_many_digits(self):
        import mpmath
        mpmath.mp.dps = 60
        n = 5
        text = "".join(f"{mpmath.nstr(mpmath.cos(2*mpmath.pi*j/n), 55)},{mpmath.nstr(mpmath.sin(2*mpmath.pi*j/n), 55)}\n" for j in range(n))
        with open(self.path("c.csv"), "w", encoding="utf-8") as f:
            f.write(text)
        out = self.twoscale("refine", TERNARY, "--v0", "cos(2*pi/5)", "--levels", "2", "--digits", "40", self.path("c.csv"))
        for line in out.splitlines()[-20:]:
            x, y = map(mpmath.mpf, line.split(","))
            self.assertLess(abs(mpmath.hypot(x, y) - 1), mpmath.mpf("1e-39"))

    def test_fit_does_not_depend_on_the_arity(self):
        path = self.polygon(7)
        v0 = [self.twoscale_json("fit", f"tension4:arity={m}", "--closed", path)["v0"] for m in (2, 3, 4)]
        self.assertEqual(v0[0], v0[1])
        self.assertEqual(v0[0], v0[2])
        self.assertAlmostEqual(float(v0[0]), math.cos(2 * math.pi / 7), delta=1e-12)


class Regularity(Mary):
    def test_ternary_four_point(self):
        file = self.path("r.json")
        d = self.twoscale_json("regularity", "dd:l=2,arity=3", "--certificate", file)
        self.assertIn("valid", self.check(file))
        level = self.twoscale_json("regularity", TERNARY)
        self.assertEqual((d["continuity"], level["continuity"]), (1, 1))
        # zeta = 3 (S_3/3)^4 b with 3 b = -4/z + 11 - 4 z: one-by-one matrices -4, 11, -4.
        self.assertEqual(d["hoelder"]["exact"], "4 - log(11)/log(3)")

    def test_spectrum(self):
        d = self.twoscale_json("spectrum", "dd:l=2,arity=3")
        exact = [e["exact"] for e in d["eigenvalues"]]
        for power in ("1", "1/3", "1/9", "1/27"):
            self.assertIn(power, exact)


class Plot(Mary):
    def test_pictures(self):
        for arguments in (["curve", TERNARY, self.polygon(5), "--v0", "cos(2*pi/5)"], ["basic", TERNARY, "--v0", "0"],
                          ["curvature", TERNARY, self.polygon(5), "--v0", "cos(2*pi/5)"]):
            self.twoscale("plot", *arguments, "-o", self.path("p.svg"))
            self.assertGreater(os.path.getsize(self.path("p.svg")), 1000)


if __name__ == "__main__":
    unittest.main()
