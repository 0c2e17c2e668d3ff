# SPDX-License-Identifier: GPL-3.0-or-later
"""`table`, `refine`, `fit`, `plot`, `report` from outside: what a user types, gets, and is refused."""

import csv
import io
import json
import math
import os
import re
import subprocess
import unittest

from support import FilesTest, run

MIXED = "interpolating:family=mixed,l=3"
HARMONIC = "interpolating:family=harmonic,l=3"
RESONANT = "interpolating:family=resonant,l=3"


class Files(FilesTest):
    def points(self, name, rows):
        return self.path(name, "".join(",".join(map(repr, row)) + "\n" for row in rows))

    @staticmethod
    def rows(text):
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        return [tuple(map(float, line.split(","))) for line in lines if re.match(r"[-+.\d]", line)]


class Table(Files):
    def test_json_document(self):
        document = self.twoscale_json("table", "tension4", "--v0", "-2/5", "--levels", "3", "--digits", "50")
        self.assertEqual(document["format"], "twoscale/mask-table")
        self.assertEqual((document["arity"], document["p"], document["parameters"]), (2, "0", {"v0": "-2/5"}))
        self.assertEqual(document["precision"], {"digits": 50, "error": "5e-51"})
        self.assertEqual([level["k"] for level in document["levels"]], [0, 1, 2])
        self.assertEqual(document["limit"]["coefficients"], ["-0.0625", "0", "0.5625", "1", "0.5625", "0", "-0.0625"])
        import mpmath
        mpmath.mp.dps = 60
        v = mpmath.mpf(-2) / 5
        for level in document["levels"]:
            v = mpmath.sqrt((1 + v) / 2)
            w = 1 / (8 * v * (1 + v))
            expected = [-w, 0, mpmath.mpf(1) / 2 + w, 1, mpmath.mpf(1) / 2 + w, 0, -w]
            for text, value in zip(level["coefficients"], expected):
                self.assertLessEqual(abs(mpmath.mpf(text) - value), mpmath.mpf("5e-51"))
        self.assertEqual(document["tail"]["from"], 3)
        v = mpmath.sqrt((1 + v) / 2)
        self.assertGreaterEqual(mpmath.mpf(document["tail"]["bound"]), abs(1 / (8 * v * (1 + v)) - mpmath.mpf(1) / 16))

    def test_digits_from_17_to_10000(self):
        for digits in (17, 1000, 10000):
            document = self.twoscale_json("table", HARMONIC, "--v0", "cosh(3/5)", "--levels", "1", "--digits", str(digits))
            text = document["levels"][0]["coefficients"][0]
            self.assertEqual(len(re.sub(r"^-?0\.0*", "", text)), digits)
        self.refused("table", HARMONIC, "--v0", "2", "--levels", "1", "--digits", "10001", naming="10001")
        self.refused("table", HARMONIC, "--v0", "2", "--levels", "1", "--digits", "16", naming="16")

    def test_all_ways_to_say_the_same_value(self):
        def masks(*values):
            d = self.twoscale_json("table", MIXED, *values, "--levels", "4", "--digits", "40")
            return [level["coefficients"] for level in d["levels"]]
        self.assertEqual(masks("--v0", "1/2"), masks("--t", "I*pi/3"))
        self.assertEqual(masks("--v0", "0.5"), masks("--at", "v0=cos(pi/3)"))
        self.assertEqual(masks("--v0", "cosh(3/5)"), masks("--at", "t=0.6"))

    def test_csv_c_cpp_npy(self):
        arguments = ["table", MIXED, "--v0", "cos(2*pi/7)", "--levels", "3", "--double"]
        document = json.loads(self.twoscale(*arguments, "--format", "json"))
        text = self.twoscale(*arguments, "--format", "csv")
        rows = list(csv.DictReader(io.StringIO("".join(l for l in text.splitlines(True) if not l.startswith("#")))))
        self.assertEqual(list(rows[0]), ["k", "index", "value"])
        self.assertEqual([float(r["value"]) for r in rows if r["k"] == "1"], [float(c) for c in document["levels"][1]["coefficients"]])
        self.assertEqual([int(r["index"]) for r in rows if r["k"] == "limit"], list(range(-5, 6)))
        for form, compiler in (("c", ["gcc", "-std=c99", "-pedantic"]), ("cpp", ["g++", "-std=c++20"])):
            file = self.path("mask." + form)
            self.twoscale(*arguments, "--format", form, "-o", file)
            subprocess.run(compiler + ["-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c" if form == "c" else "c++", file], check=True)
            with open(file, encoding="utf-8") as f:
                self.assertIn("0BSD", f.read())
        import numpy
        file = self.path("mask.npy")
        self.twoscale(*arguments, "--format", "npy", "-o", file)
        array = numpy.load(file)
        self.assertEqual(array["level"].tolist(), [0, 1, 2, -1])
        self.assertEqual(array["coefficients"][2].tolist(), [float(c) for c in document["levels"][2]["coefficients"]])

    def test_a_singular_level_names_v0_and_k(self):
        for v0, k in (("-1/2", 0), ("0", 0), ("cos(2*pi/3)", 0)):
            message = self.refused("table", HARMONIC, "--v0", v0, "--levels", "3", naming=v0)
            self.assertIn(f"k = {k}", message)
        # {1, x, e^{+-it}, e^{+-3it}}: v^0 = cos(2 pi/3) fails; l = 4 harmonic fails at level 1 for cos(4 pi/5).
        self.assertIn("k = 1", self.refused("table", "interpolating:family=harmonic,l=4", "--v0", "cos(4*pi/5)", "--levels", "3"))
        self.refused("table", "interpolating:family=harmonic,l=4", "--v0", "(sqrt(5)-1)/4", "--levels", "3")
        self.twoscale("table", "interpolating:family=harmonic,l=4", "--v0", "(sqrt(5)-1)/4+10^-40", "--levels", "3")

    def test_refusals(self):
        base = ["table", MIXED, "--levels", "3"]
        self.refused(*base, naming="v")
        self.refused(*base, "--v0", "-1", naming="-1")
        self.refused(*base, "--v0", "-1.0001", naming="-1.0001")
        self.refused(*base, "--v0", "1+", naming="1+")
        self.refused(*base, "--v0", "abc", naming="abc")
        self.refused(*base, "--v0", "1/0")
        self.refused(*base, "--v0", "2", "--t", "1")
        self.refused(*base, "--at", "q=1", naming="q")
        self.refused(*base, "--at", "t", naming="t")
        self.refused(*base, "--t", "I*pi", naming="I*pi")
        self.refused(*base, "--v0", "2", "--format", "xml", naming="xml")
        self.refused("table", MIXED, "--v0", "2", "--levels", "-1")
        self.refused("table", "dd:l=2", "--v0", "2", "--levels", "3")

    def test_unwritable(self):
        done = run("twoscale", "table", "dd:l=2", "--levels", "2", "-o", "/nonexistent/x.csv")
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (4, 1))


class Refine(Files):
    def circle(self, n, turns=1):
        return self.points("circle.csv", [(math.cos(2 * math.pi * turns * j / n), math.sin(2 * math.pi * turns * j / n)) for j in range(n)])

    def test_circles(self):
        for scheme in (MIXED, HARMONIC, RESONANT):
            for n in (5, 6, 7):
                out = self.rows(self.twoscale("refine", scheme, "--v0", f"cos(2*pi/{n})", "--levels", "6", self.circle(n)))
                self.assertEqual(len(out), n * 64)
                for x, y in out:
                    self.assertAlmostEqual(math.hypot(x, y), 1, delta=4e-15)

    def test_the_astroid_by_the_right_members(self):
        lacunary = "interpolating:space=\"1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)\""
        for scheme, n in (("interpolating:family=harmonic,l=4", 7), (lacunary, 7), (lacunary, 5), ("interpolating:family=harmonic,l=4", 11)):
            def astroid(j, m):
                s = 2 * math.pi * j / m
                return 3 * math.cos(s) + math.cos(3 * s), 3 * math.sin(s) - math.sin(3 * s)
            start = self.points("astroid.csv", [astroid(j, n) for j in range(n)])
            out = self.rows(self.twoscale("refine", scheme, "--v0", f"cos(2*pi/{n})", "--levels", "5", start))
            for j, p in enumerate(out):
                for a, b in zip(p, astroid(j, 32 * n)):
                    self.assertAlmostEqual(a, b, delta=2e-13)

    def test_many_digits(self):
        import mpmath
        mpmath.mp.dps = 70
        n = 6
        text = "".join(f"{mpmath.nstr(mpmath.cos(2*mpmath.pi*j/n), 60)},{mpmath.nstr(mpmath.sin(2*mpmath.pi*j/n), 60)}\n" for j in range(n))
        out = self.twoscale("refine", MIXED, "--v0", "1/2", "--levels", "3", "--digits", "40", self.path("c.csv", text))
        for line in out.splitlines()[-20:]:
            x, y = map(mpmath.mpf, line.split(","))
            self.assertLess(abs(mpmath.hypot(x, y) - 1), mpmath.mpf("1e-39"))

    def test_open_curves(self):
        import itertools
        f = lambda t: (t, math.cosh(0.4 * t))
        given = self.points("given.csv", [f(j) for j in range(-4, 9)])
        out = self.rows(self.twoscale("refine", MIXED, "--v0", "cosh(2/5)", "--levels", "4", "--open=given", given))
        self.assertEqual(len(out), 4 * 16 + 1)
        space = self.points("space.csv", [f(j) for j in range(0, 7)])
        out2 = self.rows(self.twoscale("refine", MIXED, "--v0", "cosh(2/5)", "--levels", "4", "--open=space", space))
        self.assertEqual(len(out2), 6 * 16 + 1)
        for t, y in itertools.chain(out, out2):
            self.assertAlmostEqual(y, math.cosh(0.4 * t), delta=1e-12)
        # beccari2007 (10): p_1 = (1/2 - w) p_0 + (1/2 + 2w) p_1 - w p_2.
        out = self.rows(self.twoscale("refine", "dd:l=2", "--levels", "1", "--open=linear", self.points("l.csv", [(0, 1), (1, 5), (2, -3)])))
        self.assertAlmostEqual(out[1][1], (0.5 - 1 / 16) * 1 + (0.5 + 2 / 16) * 5 - (1 / 16) * -3, delta=1e-15)
        self.assertEqual(len(out), 5)

    def test_formats(self):
        start = self.path("p.csv", "x,y\n0,0\n1,0\n1,1\n0,1\n")
        import numpy
        numpy.save(self.path("p.npy"), numpy.array([[0., 0], [1, 0], [1, 1], [0, 1]]))
        reference = self.rows(self.twoscale("refine", "dd:l=2", "--levels", "2", start))
        for name in ("out.csv", "out.npy", "out.obj", "out.ply", "out.svg"):
            self.assertEqual(self.twoscale("refine", "dd:l=2", "--levels", "2", self.path("p.npy"), "-o", self.path(name)), "")
        self.assertEqual(numpy.load(self.path("out.npy")).tolist(), [list(r) for r in reference])
        with open(self.path("out.csv"), encoding="utf-8") as f:
            self.assertEqual(self.rows(f.read()), reference)
        with open(self.path("out.obj"), encoding="utf-8") as f:
            self.assertEqual(sum(line.startswith("v ") for line in f), 16)

    def test_refusals(self):
        good = self.path("good.csv", "0,0\n1,0\n1,1\n0,1\n")
        self.refused("refine", "dd:l=2", "--levels", "2", self.path("two.csv", "0,0\n1,1\n"), naming="3")
        self.assertIn("nan", self.refused("refine", "dd:l=2", "--levels", "2", self.path("nan.csv", "0,0\nnan,1\n1,1\n2,3\n")).lower())
        self.refused("refine", "dd:l=2", "--levels", "2", self.path("bad.csv", "0,0\n1,a\n1,1\n2,3\n"), naming="a")
        self.refused("refine", "dd:l=2", "--levels", "2", self.path("ragged.csv", "0,0\n1\n1,1\n"), naming="ragged.csv")
        self.refused("refine", "dd:l=2", "--levels", "2", self.path("empty.csv", ""), naming="empty.csv")
        self.refused("refine", "dd:l=2", "--levels", "2", "--open=given", good)
        self.refused("refine", "dd:l=2", "--levels", "2", "--open=sideways", good, naming="sideways")
        self.refused("refine", "dd:l=2", "--levels", "100", good)
        self.refused("refine", "dd:l=2", "--levels", "2", good, "-o", self.path("out.xyz"), naming="xyz")
        self.refused("refine", MIXED, "--levels", "2", good)
        self.refused("refine", HARMONIC, "--v0", "0", "--levels", "2", good, naming="0")
        done = run("twoscale", "refine", "dd:l=2", "--levels", "2", self.path("absent.csv"))
        self.assertEqual(done.returncode, 4)
        self.assertEqual(sorted(os.listdir(self.directory.name)), ["bad.csv", "empty.csv", "good.csv", "nan.csv", "ragged.csv", "two.csv"])


class Fit(Files):
    def test_values_are_found(self):
        catenary = self.points("catenary.csv", [(j * 0.5, math.cosh(0.3 * j * 0.5)) for j in range(9)])
        d = self.twoscale_json("fit", "tension4", catenary)
        self.assertEqual(d["format"], "twoscale/fit")
        self.assertAlmostEqual(float(d["v0"]), math.cosh(0.15), delta=1e-10)
        self.assertAlmostEqual(float(d["t"]), 0.15, delta=1e-9)
        n = 7
        heptagon = self.points("h.csv", [(math.cos(2 * math.pi * j / n), math.sin(2 * math.pi * j / n)) for j in range(n)])
        for scheme in ("tension4", MIXED, HARMONIC, RESONANT):
            d = self.twoscale_json("fit", scheme, "--closed", heptagon)
            self.assertAlmostEqual(float(d["v0"]), math.cos(2 * math.pi / n), delta=1e-9)

    def test_straight_data_fit_any_value(self):
        line = self.points("line.csv", [(j, 2 * j + 1) for j in range(8)])
        d = self.twoscale_json("fit", "tension4", line)
        self.assertIsNone(d["v0"])
        self.assertIn("any", self.twoscale("fit", "tension4", line))

    def test_no_fit_is_status_1(self):
        rough = self.points("rough.csv", [(0, 0), (1, 2), (2, -1), (3, 5), (4, 0), (5, 1), (6, 7)])
        self.twoscale("fit", "tension4", rough, status=1)

    def test_refusals(self):
        self.refused("fit", "tension4", self.path("few.csv", "0,0\n1,1\n2,3\n"))
        self.refused("fit", "dd:l=2", self.points("p.csv", [(j, j * j) for j in range(9)]))
        self.refused("fit", "interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"", self.path("p.csv"))


class Plot(Files):
    def test_pictures(self):
        start = self.path("p.csv", "0,0\n1,0\n1,1\n0,1\n")
        for form, magic in (("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")):
            for arguments in (["basic", HARMONIC, "--v0", "1/2"], ["curve", "tension4", start, "--v0", "0"]):
                file = self.path("out." + form)
                self.twoscale("plot", *arguments, "-o", file)
                with open(file, "rb") as f:
                    self.assertEqual(f.read(len(magic)), magic)
        self.refused("plot", "curve", "tension4", start, "--v0", "0", "-o", self.path("out.bmp"), naming="bmp")
        self.refused("plot", "nonsense", "tension4", "--v0", "0", "-o", self.path("out2.svg"), naming="nonsense")


class Report(Files):
    def test_only_papers_that_exist(self):
        self.refused("report", "nobody1999", "-o", self.path("r"), naming="nobody1999")


if __name__ == "__main__":
    unittest.main()
