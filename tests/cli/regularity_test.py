# SPDX-License-Identifier: GPL-3.0-or-later
"""`regularity` from outside: the document of the contract, classical masks with their certificates, matrices from
files, ranges of a parameter, refusals, limits of time."""

import json
import os
import tempfile
import time
import unittest
from fractions import Fraction

import classic_masks
import mpmath
from support import ProgramTest, run, to_sympy

FOUR = 'mask:coefficients="-w,0,1/2+w,1,1/2+w,0,-w",lowest=-3'
SMALL = Fraction(1, 10 ** 9)


def algebraic_value(exact):
    """An exact number of the contract to 40 digits: an expression, or the zero of a polynomial in an interval."""
    mpmath.mp.dps = 40
    if isinstance(exact, str):
        return mpmath.mpf(str(to_sympy(exact).evalf(40)))
    import sympy
    x = sympy.Symbol("x")
    p = sympy.Poly(to_sympy(exact["polynomial"]), x)
    low, high = (sympy.Rational(e) for e in exact["interval"])
    assert p.count_roots(low, high) == 1
    if low == high:
        return mpmath.mpf(low.p) / low.q
    while high - low > sympy.Rational(1, 10 ** 35):
        middle = (low + high) / 2
        low, high = (low, middle) if p.eval(low) * p.eval(middle) <= 0 else (middle, high)
    return mpmath.mpf(low.p) / low.q


def exponent_value(exact):
    """An exact exponent: an expression, with rho if it has one."""
    if isinstance(exact, str):
        return algebraic_value(exact)
    import sympy
    rho = sympy.Float(str(algebraic_value(exact["rho"])), 40)
    return mpmath.mpf(str(to_sympy(exact["expression"]).subs(sympy.Symbol("rho"), rho).evalf(35)))


class RegularityTest(ProgramTest):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def path(self, name):
        return os.path.join(self.directory, name)

    def written(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as f:
            f.write(text)
        return self.path(name)

    def expect_exponent(self, e):
        """The keys of an exponent, and its exact value between its bounds, which are near if there is one."""
        self.assertEqual(set(e), {"exact", "lower", "upper"})
        low, high = (None if e[k] is None else Fraction(e[k]) for k in ("lower", "upper"))
        if low is not None and high is not None:
            self.assertLessEqual(low, high)
        if e["exact"] is not None:
            value = exponent_value(e["exact"])
            self.assertLessEqual(mpmath.mpf(low.numerator) / low.denominator, value + mpmath.mpf(10) ** -20)
            self.assertGreaterEqual(mpmath.mpf(high.numerator) / high.denominator, value - mpmath.mpf(10) ** -20)
            self.assertLess(high - low, SMALL)

    def expect_radius(self, r):
        self.assertEqual(set(r), {"exact", "lower", "upper", "cycles", "bounded_products"})
        low, high = Fraction(r["lower"]), Fraction(r["upper"])
        self.assertLessEqual(low, high)
        self.assertIn(r["bounded_products"], (True, None))
        if r["exact"] is not None:
            value = algebraic_value(r["exact"])
            self.assertLessEqual(mpmath.mpf(low.numerator) / low.denominator, value + mpmath.mpf(10) ** -20)
            self.assertGreaterEqual(mpmath.mpf(high.numerator) / high.denominator, value - mpmath.mpf(10) ** -20)

    def certified(self, *arguments, status=0):
        """The document, its certificate accepted by the checker."""
        file = self.path("certificate.json")
        d = self.twoscale_json("regularity", *arguments, "--certificate", file, status=status)
        self.assertEqual((d["format"], d["version"]), ("twoscale/regularity", 1))
        if d["certificate"] is not None:
            self.assertEqual(d["certificate"], file)
            self.check(file)
            os.remove(file)
        self.assertFalse(os.path.exists(file))
        return d


class Document(RegularityTest):
    KEYS = {"format", "version", "scheme", "arity", "continuity", "hoelder", "sobolev", "attained", "sum_rules",
            "remainder", "jsr", "stable", "method", "limit_scheme", "certificate"}

    def test_stationary(self):
        d = self.certified("dd:l=3")
        self.assertLessEqual(self.KEYS, set(d))
        self.assertEqual(d["scheme"], "dd:l=3")
        self.assertEqual((d["arity"], d["continuity"], d["sum_rules"], d["stable"]), (2, 2, 6, True))
        self.assertEqual(d["hoelder"]["exact"], "6 - log(9)/log(2)")
        self.assertEqual((d["attained"], d["method"], d["limit_scheme"]), (True, "nonnegative-symbol", None))
        self.assertEqual(d["jsr"]["exact"], "9")
        remainder = [Fraction(c) for c in d["remainder"]]
        self.assertEqual(sum(remainder), 2)
        mask = classic_masks.convolved(remainder, classic_masks.power(classic_masks.mean(2), 6))
        self.assertEqual(mask, classic_masks.pseudo_spline(3, 2))
        self.expect_exponent(d["hoelder"])
        self.expect_exponent(d["sobolev"])
        self.expect_radius(d["jsr"])
        self.assertIsNone(self.twoscale_json("regularity", "dd:l=3")["certificate"])

    def test_all_levels(self):
        for scheme in ("tension4", "interpolating:family=harmonic,l=3", "mixed:n=2"):
            d = self.certified(scheme)
            self.assertLessEqual(self.KEYS | {"applies_to_all_levels", "generated_space", "excluded_v0"}, set(d))
            self.assertTrue(d["applies_to_all_levels"])
            self.assertEqual(set(d["limit_scheme"]), {"lowest", "coefficients"})
            self.assertIsNone(d["attained"])
        d = self.certified("tension4")
        self.assertEqual(d["hoelder"]["exact"], self.certified("dd:l=2")["hoelder"]["exact"])
        self.assertEqual(d["limit_scheme"]["coefficients"], ["-1/16", "0", "9/16", "1", "9/16", "0", "-1/16"])
        self.assertEqual(d["limit_scheme"]["lowest"], -3)

    def test_without_convergence(self):
        d = self.certified('mask:coefficients="1,1,1"')
        self.assertLessEqual(self.KEYS | {"obstacle"}, set(d))
        self.assertEqual((d["method"], d["jsr"], d["stable"], d["continuity"]), ("none", None, None, -1))
        self.assertIn("3", d["obstacle"])
        self.assertIn("diverges", self.twoscale("regularity", 'mask:coefficients="1,1,1"'))

    def test_not_stable(self):
        d = self.certified('mask:coefficients="1,0,0,1"')
        self.assertEqual((d["stable"], d["hoelder"]["exact"], d["hoelder"]["upper"]), (False, None, None))
        self.assertIsNone(d["attained"])

    def test_values_of_constants(self):
        d = self.certified(FOUR, "--at", "w=1/16")
        self.assertEqual(d["hoelder"], self.certified("dd:l=2")["hoelder"])
        self.assertEqual(self.certified(FOUR, "--at", "w=0.0625")["hoelder"], d["hoelder"])

    def test_an_enclosure(self):
        scheme = classic_masks.scheme(2, classic_masks.six_points(Fraction(1, 64)))
        wide = self.certified(scheme, "--width", "1/10")
        narrow = self.certified(scheme, "--width", "1/1000")
        for d, width in ((wide, Fraction(1, 10)), (narrow, Fraction(1, 1000))):
            self.assertEqual((d["method"], d["hoelder"]["exact"], d["jsr"]["exact"]), ("enclosure", None, None))
            low, high = Fraction(d["jsr"]["lower"]), Fraction(d["jsr"]["upper"])
            self.assertLessEqual(high / low - 1, width * 11 / 10)
            self.expect_exponent(d["hoelder"])
        self.assertLessEqual(Fraction(wide["hoelder"]["lower"]), Fraction(narrow["hoelder"]["upper"]))
        self.assertLessEqual(Fraction(narrow["hoelder"]["lower"]), Fraction(wide["hoelder"]["upper"]))

    def test_the_same_bytes(self):
        six = classic_masks.scheme(2, classic_masks.six_points(Fraction(1, 64)))
        for arguments in (("dd:l=4",), ("tension4",), (six,), (FOUR, "--over", "w=[1/100,1/20]")):
            seen = set()
            for threads in ("1", "1", "2"):
                file, certificate = self.path("out.json"), self.path("c.json")
                text = self.twoscale("regularity", *arguments, "--format", "json", "--certificate", certificate,
                                     "--threads", threads)
                self.twoscale("regularity", *arguments, "--format", "json", "--certificate", certificate,
                              "--threads", threads, "-o", file)
                with open(file, encoding="utf-8") as f, open(certificate, encoding="utf-8") as g:
                    self.assertEqual(f.read(), text)
                    seen.add((text, g.read()))
            self.assertEqual(len(seen), 1, arguments)

    def test_text(self):
        text = self.twoscale("regularity", "dd:l=2")
        for piece in ("order 4", "Hölder", "2 exactly", "not attained", "C^1"):
            self.assertIn(piece, text)


class Classics(RegularityTest):
    def test_exponents(self):
        rows = classic_masks.table()
        self.assertGreater(len(rows), 100)
        for name, m, mask, order, exponent, attained in rows:
            with self.subTest(name):
                d = self.certified(classic_masks.scheme(m, mask))
                self.assertEqual(d["sum_rules"], order)
                self.assertTrue(d["stable"])
                self.assertEqual(d["attained"], attained)
                e = d["hoelder"]
                if exponent is None:
                    self.assertIsNone(e["exact"])
                    continue
                low, high = Fraction(e["lower"]), Fraction(e["upper"])
                if isinstance(exponent, str):
                    self.assertEqual(e["exact"], exponent)
                else:
                    self.assertIsNotNone(e["exact"])
                    self.assertLess(abs(low - Fraction(exponent)), Fraction(1, 10 ** 11))
                self.assertLess(high - low, Fraction(1, 10 ** 11))
                # The largest l with l < exponent, and smoothness in the mean beside the one in the maximum.
                self.assertTrue(d["continuity"] < high and low <= d["continuity"] + 1)
                self.assertLessEqual(Fraction(d["sobolev"]["lower"]) - Fraction(1, 2), high)
                self.assertGreaterEqual(Fraction(d["sobolev"]["upper"]), low)
                self.assertEqual(exponent_value(e["exact"]) > 0, high > 0)
                self.expect_exponent(e)
                self.expect_exponent(d["sobolev"])
                self.expect_radius(d["jsr"])


class Matrices(RegularityTest):
    def radius(self, text, *arguments, status=0):
        d = self.certified("--matrices", self.written("m.json", text), *arguments, status=status)
        self.assertEqual(set(d), {"format", "version", "scheme", "jsr", "method", "certificate"})
        self.expect_radius(d["jsr"])
        return d["jsr"]

    def test_spellings(self):
        self.assertEqual(self.radius('[[[1,1],[0,1]],[["1","0"],["2/2","1.0"]]]')["exact"], "1/2 + sqrt(5)/2")
        self.assertEqual(self.radius("[[[0.1]]]")["exact"], "1/10")
        self.assertEqual(self.radius("[[[1e-1]]]")["exact"], "1/10")
        self.assertEqual(self.radius('[[["1/10"]]]')["exact"], "1/10")
        self.assertEqual(self.radius('[[["1 + 1/3"]], [[-1.25]]]')["exact"], "4/3")
        self.assertEqual(self.radius("[[[99999999999999999999999999]]]")["exact"], "99999999999999999999999999")
        self.assertEqual(self.radius("[[[-0]]]")["exact"], "0")
        self.assertEqual(self.radius("\n[ [\t[1, 2], [3, 4] ],\r\n [[0,0],[0,0]] ]\n")["cycles"], [[0]])

    def test_known(self):
        golden = self.radius("[[[1,1],[0,1]],[[1,0],[1,1]]]")
        self.assertEqual(golden["exact"], "1/2 + sqrt(5)/2")
        self.assertEqual([sorted(w) for w in golden["cycles"]], [[0, 1]])
        self.assertTrue(golden["bounded_products"])
        self.assertEqual(self.radius("[[[4,0],[-1,-1]],[[-1,-1],[0,4]]]")["exact"], "4")
        self.assertEqual(self.radius("[[[1,2],[0,1]],[[1,0],[2,1]]]")["exact"], "1 + sqrt(2)")
        turn = self.radius('[[["3/5","-4/5"],["4/5","3/5"]]]')
        self.assertLessEqual(Fraction(turn["lower"]), 1)
        self.assertGreaterEqual(Fraction(turn["upper"]), 1)

    def test_text(self):
        file = self.written("m.json", "[[[1,1],[0,1]],[[1,0],[1,1]]]")
        text = self.twoscale("regularity", "--matrices", file)
        self.assertIn("2 matrices of size 2", text)
        self.assertIn("1/2 + sqrt(5)/2", text)

    def test_refusals(self):
        for text, naming in (
                ("[]", "no matrices"), ("[[]]", "matrix 1"), ("[[[]]]", "row 1"), ("{}", "array"), ("1", "1"),
                ("[[[1,2],[3]]]", "row 2"), ("[[[1,2]]]", "row 1"), ("[[[1]],[[1,2],[3,4]]]", "matrix 2"),
                ("[[[NaN]]]", "JSON"), ("[[[Infinity]]]", "JSON"), ('[[["NaN"]]]', "NaN"), ('[[["nan"]]]', "nan"),
                ("[[[null]]]", "null"), ("[[[true]]]", "true"), ('[[["1/0"]]]', "1/0"), ('[[["w"]]]', "w"),
                ('[[["sqrt(2)"]]]', "sqrt(2)"), ("[[[[1]]]]", "column 1"), ("[[[1]", "JSON"), ("[[[1]]] x", "JSON"),
                ("", "JSON"), ("[1,2]", "matrix 1"), ("[[1,2]]", "row 1"), ("[[[{}]]]", "object"), ("[{}]", "object"),
                ('[[["9^9^9^9"]]]', "9^9^9^9"), ('[[[""]]]', "column 1"), ("[[[1,]]]", "JSON"), ("[[[0x10]]]", "JSON"),
                ('[[["' + "1" * 10001 + '"]]]', "10000"), ("[" * 100000, "nested")):
            with self.subTest(text[:40]):
                out, certificate = self.path("out"), self.path("c.json")
                self.refused("regularity", "--matrices", self.written("m.json", text), "-o", out, "--certificate",
                             certificate, naming=naming, timeout=20)
                self.assertFalse(os.path.exists(out) or os.path.exists(certificate))

    def test_huge_numbers_do_not_hang(self):
        for entry in ("1e999999999", '"1e999999999"', "1e-999999999", '"2^999999999"', '"1e99999999999999999999"'):
            begin = time.monotonic()
            self.refused("regularity", "--matrices", self.written("m.json", f"[[[{entry}]]]"), timeout=20)
            self.assertLess(time.monotonic() - begin, 10)
        self.refused("regularity", FOUR, "--at", "w=1e999999999", naming="1e999999999", timeout=20)
        self.refused("regularity", FOUR, "--over", "w=[0,1e999999999]", naming="1e999999999", timeout=20)
        self.refused("regularity", "dd:l=2", "--width", "1e-999999999", naming="1e-999999999", timeout=20)

    def test_files(self):
        def expect(*arguments, naming):
            done = run("twoscale", "regularity", *arguments)
            self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (4, "", 1), done.stderr)
            self.assertIn(naming, done.stderr)
        nowhere = self.path("no/such/file")
        expect("--matrices", nowhere, naming=nowhere)
        expect("--matrices", self.directory, naming=self.directory)
        expect("dd:l=2", "-o", nowhere, naming=nowhere)
        expect("dd:l=2", "--certificate", nowhere, naming=nowhere)
        out = self.path("out")
        expect("dd:l=2", "--certificate", nowhere, "-o", out, naming=nowhere)
        expect(FOUR, "--over", "w=[1/100,1/20]", "--certificate", nowhere, "-o", out, naming=nowhere)
        matrices = self.written("m.json", "[[[1]]]")
        expect("--matrices", matrices, "--certificate", nowhere, "-o", out, naming=nowhere)
        self.assertFalse(os.path.exists(out))

    def test_limit_of_time(self):
        # Two rotations of R^6 by angles that are no rational multiples of pi: the radius is 1, no polytope closes.
        def rotation(n, i, j, c, s):
            r = [[Fraction(int(a == b)) for b in range(n)] for a in range(n)]
            r[i][i], r[j][j], r[i][j], r[j][i] = c, c, -s, s
            return r

        def product(*factors):
            result = factors[0]
            for f in factors[1:]:
                result = [[sum(x * f[k][j] for k, x in enumerate(row)) for j in range(len(f))] for row in result]
            return result

        q = Fraction
        a = product(rotation(6, 0, 1, q(3, 5), q(4, 5)), rotation(6, 2, 3, q(5, 13), q(12, 13)),
                    rotation(6, 4, 5, q(5, 13), q(12, 13)))
        b = product(rotation(6, 1, 2, q(8, 17), q(15, 17)), rotation(6, 3, 4, q(20, 29), q(21, 29)),
                    rotation(6, 5, 0, q(20, 29), q(21, 29)))
        text = json.dumps([[[str(x) for x in row] for row in m] for m in (a, b)])
        begin = time.monotonic()
        # Undecided within the limit, with the best bounds; without a limit an enclosure is an answer.
        jsr = self.radius(text, "--time-limit", "2", status=3)
        self.assertLess(time.monotonic() - begin, 10)
        self.assertIsNone(jsr["exact"])
        self.assertLessEqual(Fraction(jsr["lower"]), 1)
        self.assertGreaterEqual(Fraction(jsr["lower"]), 1 - SMALL)
        self.assertGreaterEqual(Fraction(jsr["upper"]), 1)

    def test_numbers_of_any_size(self):
        # The leading vectors of the long products met here have entries beyond the range of doubles.
        c = "-13/64,-3/16,1/16,-3/64,-3/32,9/16,41/32,33/32,21/32,19/64,-29/64,-21/32,-1/4"
        d = self.certified(f'mask:coefficients="{c}",lowest=0', "--time-limit", "4", status=3)
        self.assertEqual(d["continuity"], 0)
        self.assertLess(Fraction(d["hoelder"]["lower"]), Fraction(d["hoelder"]["upper"]))

    def test_paired_options(self):
        matrices = self.written("m.json", "[[[1]]]")
        self.refused("regularity", "--matrices", matrices, "--over", "w=[0,1]", naming="w=[0,1]")
        self.refused("regularity", FOUR, "--at", "w=1/16,w=1/8", naming="given twice: w")
        out, certificate = self.path("no/such/out"), self.path("c.json")
        done = run("twoscale", "regularity", "dd:l=2", "--certificate", certificate, "-o", out)
        self.assertEqual(done.returncode, 4)
        self.assertFalse(os.path.exists(certificate))


class Over(RegularityTest):
    INTERVAL = {"from", "to", "from_included", "to_included"}

    def test_the_document(self):
        d = self.certified(FOUR, "--over", "w=[1/100,1/20]")
        self.assertLessEqual({"format", "version", "scheme", "arity", "over", "sum_rules", "radius", "continuity",
                              "samples", "certificate"}, set(d))
        self.assertEqual(d["over"], {"name": "w", "interval": ["1/100", "1/20"]})
        self.assertEqual((d["format"], d["version"], d["sum_rules"]), ("twoscale/regularity", 1, 2))
        self.assertEqual(len(d["radius"]), 1)
        r = d["radius"][0]
        self.assertLessEqual(self.INTERVAL | {"exact", "polynomial", "method", "cycles"}, set(r))
        self.assertEqual((r["from"], r["to"], r["from_included"], r["to_included"]), ("1/100", "1/20", True, True))
        self.assertEqual((r["exact"], r["method"]), ("1 + sqrt(-(16*w - 1))", "nonnegative-symbol"))
        for c in d["continuity"]:
            self.assertEqual(set(c), {"l", "proved", "refuted", "level_dependent"})
            for i in c["proved"] + c["refuted"] + [c["level_dependent"]]:
                self.assertEqual(set(i), self.INTERVAL)
        self.assertEqual([(c["l"], [(i["from"], i["to"]) for i in c["proved"]], c["refuted"]) for c in d["continuity"]],
                         [(0, [("1/100", "1/20")], []), (1, [("1/100", "1/20")], [])])
        self.assertEqual(d["samples"][0]["value"], "1/100")
        self.assertEqual(d["samples"][-1]["value"], "1/20")
        import sympy
        w, x = sympy.symbols("w x")
        radius, polynomial = to_sympy(r["exact"]), to_sympy(r["polynomial"])
        for s in d["samples"]:
            self.assertEqual(set(s), {"value", "sum_rules", "continuity", "hoelder"})
            self.expect_exponent(s["hoelder"])
            value = radius.subs(w, to_sympy(s["value"]))
            self.assertEqual(sympy.simplify(polynomial.subs({w: to_sympy(s["value"]), x: value})), 0)
            self.assertLess(abs(Fraction(s["hoelder"]["lower"]) - Fraction(str((2 - sympy.log(value, 2)).evalf(20)))),
                            Fraction(1, 10 ** 10))
            self.assertEqual(d["samples"][-1]["hoelder"],
                             self.twoscale_json("regularity", FOUR, "--at", "w=1/20")["hoelder"])

    def test_the_theorem_of_the_quasi_splines(self):
        """jeong2013, Theorem 3.1: the joint spectral radius in closed form on each range, and C^l from it."""
        mask = 'mask:coefficients="w/8,(1+2*w)/8,(4-w)/8,(3-2*w)/4,(4-w)/8,(1+2*w)/8,w/8",lowest=-3'
        d = self.certified(mask, "--over", "w=[-4,5]")
        import sympy
        w = sympy.Symbol("w", positive=True)
        expected = [("-4", "1/4", 2 - 4 * w), ("1/4", "1/2", w + sympy.sqrt(w * (4 - 7 * w))), ("1/2", "1", 2 * w),
                    ("1", "5", 4 * w - 2)]
        self.assertEqual([(r["from"], r["to"]) for r in d["radius"]], [e[:2] for e in expected])
        for r, (low, high, value) in zip(d["radius"], expected):
            exact = to_sympy(r["exact"]).subs(sympy.Symbol("w"), w)
            for at in (sympy.Rational(low), sympy.Rational(high), (sympy.Rational(low) + sympy.Rational(high)) / 2):
                self.assertEqual(sympy.simplify((exact - value).subs(w, at)), 0)
        ends = [("-7/2", "9/2"), ("-3/2", "5/2"), ("-1/2", "3/2"), ("0", "1")]
        self.assertEqual([[(i["from"], i["to"], i["from_included"], i["to_included"]) for i in c["proved"]]
                          for c in d["continuity"]], [[(*e, False, False)] for e in ends])
        self.assertEqual((d["exceptional"]["value"], d["exceptional"]["continuity"]), ("1/4", 4))

    def test_text(self):
        text = self.twoscale("regularity", FOUR, "--over", "w = [1/100, 0.05]")
        self.assertIn("1 + sqrt(-(16*w - 1))", text)
        self.assertIn("C^1", text)

    def test_refusals(self):
        for arguments, naming in (
                ((FOUR, "--over", "w"), "w"), ((FOUR, "--over", "w=[0]"), "w=[0]"), ((FOUR, "--over", "w=[0,x]"), "x"),
                ((FOUR, "--over", "=[0,1]"), "=[0,1]"), ((FOUR, "--over", "w=[0,1"), "w=[0,1"),
                ((FOUR, "--over", "w=[0,1,2]"), "w=[0,1,2]"), ((FOUR, "--over", "u=[0,1]"), "w"),
                ((FOUR, "--over", "w=[1,0]"), "w"), ((FOUR, "--over", "w=[1,1]"), "w"),
                ((FOUR, "--over", "w=[0,sqrt(2)]"), "sqrt(2)"), (("dd:l=2", "--over", "w=[0,1]"), "w"),
                (("tension4", "--over", "v=[0,1]"), "v")):
            with self.subTest(arguments=arguments):
                out = self.path("out")
                self.refused("regularity", *arguments, "-o", out, naming=naming)
                self.assertFalse(os.path.exists(out))


class Refusals(RegularityTest):
    def test_arguments(self):
        for arguments, naming in (
                ((), "regularity"), (("nonsense",), "nonsense"), (("dd:l=2", "--at", "w=1"), "w"),
                (("dd:l=x",), "x"), (("tension4", "--at", "v=1"), "v"), ((FOUR,), "w"), ((FOUR, "--at", "w"), "w"),
                ((FOUR, "--at", "w="), ""), ((FOUR, "--at", "w=sqrt(2)"), "sqrt(2)"), ((FOUR, "--at", "u=1"), "u"),
                ((FOUR, "--at", "w=1/0"), "1/0"), ((FOUR, "--at", "w=v"), "v"), ((FOUR, "--at", "w=1,w=2"), "w"),
                (("dd:l=2", "--width", "0"), "--width"), (("dd:l=2", "--width", "x"), "x"),
                (("dd:l=2", "--width", "-1/2"), "--width"), (("dd:l=2", "--vertices", "1"), "--vertices"),
                (("dd:l=2", "--format", "xml"), "xml"), (("dd:l=2", "--nonsense"), "--nonsense"),
                (("dd:l=2", "--matrices", "m.json"), "--matrices"), (("nuli4",), "nuli4")):
            with self.subTest(arguments=arguments):
                certificate = self.path("c.json")
                self.refused("regularity", *arguments, "--certificate", certificate, naming=naming)
                self.assertFalse(os.path.exists(certificate))


if __name__ == "__main__":
    unittest.main()
