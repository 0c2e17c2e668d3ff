# SPDX-License-Identifier: GPL-3.0-or-later
"""The Hermite scheme from outside: `stencil`, `refine hermite-circle`, its pictures, and what is refused."""

import math
import os
import unittest
from fractions import Fraction

import mpmath

from support import FilesTest, ProgramTest, run


class Files(FilesTest):
    def refined(self, scheme, text, *options):
        out = self.twoscale("refine", scheme, "--quiet", *options, self.path("in.csv", text)).splitlines()
        return out[0], [tuple(line.split(",")) for line in out[1:]]


class Stencil(ProgramTest):
    def test_matrix(self):
        document = self.twoscale_json("stencil", "hermite-circle", "--at", "s=[-1/5,1/7],w=1/2")
        self.assertEqual((document["format"], document["scheme"], document["lowest"]),
                         ("twoscale/stencil", "hermite-circle", 0))
        matrix = document["matrix"]
        self.assertEqual([len(row) for row in matrix], [6, 6, 6])
        # u = w/7 - (1-w)/5 = -1/35: the printed formula lambda_25 = phi_9(v, u) with the arguments swapped.
        F = Fraction
        v, u = F(-1, 5), F(-1, 35)
        phi9 = lambda u, v: (1 - u * v)**3 * (v**2 + 1)**3 / (4 * (u * v + 1)**3 * (v - 1)**3 * (v + 1)**3)
        self.assertEqual((F(matrix[2][4]), F(matrix[2][5])), (phi9(u, v), phi9(v, u)))
        self.assertEqual(F(matrix[0][0]) + F(matrix[0][1]), 1)
        self.assertEqual(F(matrix[1][0]) + F(matrix[1][1]), 0)

    def test_tension_by_key_and_by_value(self):
        by_key = self.twoscale_json("stencil", "hermite-circle:w=1/2", "--at", "s=[-1/5,1/7]")
        by_value = self.twoscale_json("stencil", "hermite-circle", "--at", "s=[-1/5,1/7],w=1/2")
        self.assertEqual(by_key["matrix"], by_value["matrix"])
        plain = self.twoscale_json("stencil", "hermite-circle", "--at", "s=[-1/5,1/7]")
        c2 = self.twoscale_json("stencil", "hermite-circle:variant=c2", "--at", "s=[-1/5,1/7],w=1")
        self.assertEqual(plain["at"], {"s": ["-1/5", "1/7"], "w": "1"})
        self.assertEqual(plain["matrix"], c2["matrix"])

    def test_other_schemes(self):
        self.assertEqual(self.twoscale_json("stencil", "dd:l=2")["coefficients"], ["-1/16", "9/16", "9/16", "-1/16"])

    def test_refusals(self):
        self.refused("stencil", "hermite-circle", naming="s")
        self.refused("stencil", "hermite-circle", "--at", "s=[1/5]", naming="s")
        self.refused("stencil", "hermite-circle", "--at", "s=[1/5,#]", naming="#")
        self.refused("stencil", "hermite-circle", "--at", "s=[1/5,1/5]", naming="pole")
        self.refused("stencil", "hermite-circle", "--at", "s=[1/5,1]", naming="pole")
        self.refused("stencil", "hermite-circle", "--at", "s=[1/5,1/3],w=0", naming="w")
        self.refused("stencil", "hermite-circle", "--at", "s=[1/5,1/3],d=1", naming="d")
        self.refused("stencil", "hermite-circle:w=0", "--at", "s=[1/5,1/3]", naming="0")

    def test_show(self):
        document = self.twoscale_json("show", "hermite-circle:variant=c2,w=1/2")
        self.assertEqual((document["block"], document["parameters"], document["local_parameters"]), (3, ["w"], {"s": [0, 1]}))
        self.assertEqual(document["parameter_details"]["w"]["default"], "1/2")
        self.assertIn("f_{2j+1} =", self.twoscale("show", "hermite-circle"))

    def test_spectrum_of_small_steps(self):
        document = self.twoscale_json("spectrum", "hermite-circle")
        self.assertEqual(document["hermite"]["spectral_order"], 5)
        self.assertTrue(document["hermite"]["consistent"])
        self.assertTrue(document["hermite"]["reproduces_polynomials"])
        self.assertEqual([(e["exact"], e["multiplicity"], e["geometric"]) for e in document["eigenvalues"]],
                         [("1", 1, 1), ("1/2", 1, 1), ("1/4", 1, 1), ("1/8", 2, 2), ("1/16", 2, 2), ("1/32", 2, 2)])
        at = self.twoscale_json("spectrum", "hermite-circle", "--at", "w=1/2")["hermite"]["scales"]
        self.assertNotIn("w", "".join(at))
        self.assertIn("spectral condition  of order 5", self.twoscale("spectrum", "hermite-circle"))
        self.refused("spectrum", "hermite-circle", "--at", "q=1", naming="q")


class Refine(Files):
    def test_circles(self):
        angles = [0.3, 0.35, 2.0, 3.9, 5.1]
        text = "".join(f"{2 + 3 * math.cos(a)!r},{-1 + 3 * math.sin(a)!r}\n" for a in angles)
        header, rows = self.refined("hermite-circle", text, "--levels", "10")
        self.assertEqual((header, len(rows)), ("x,y", 5 << 10))
        for x, y in rows:
            self.assertLess(abs(math.hypot(float(x) - 2, float(y) + 1) - 3), 1e-12)

    def test_circles_to_the_last_digit(self):
        with mpmath.workdps(90):
            angles = [mpmath.mpf(a) for a in ("-0.2", "-0.9", "-3.3", "-5")]  # clockwise
            number = lambda x: mpmath.nstr(x, 85)
            text = "x,y,z\n" + "".join(f"{number(mpmath.cos(a))},1.5,{number(mpmath.sin(a))}\n" for a in angles)
            _, rows = self.refined("hermite-circle", text, "--levels", "4", "--digits", "60", "--open", "given")
            self.assertEqual(len(rows), 49)
            for x, y, z in rows:
                self.assertEqual(mpmath.mpf(y), mpmath.mpf("1.5"))
                self.assertLess(abs(mpmath.hypot(mpmath.mpf(x), mpmath.mpf(z)) - 1), mpmath.mpf("2e-60"))

    def test_columns(self):
        text = "0,0\n4,-1\n5,2\n2,5\n-1,3\n"
        header, all_columns = self.refined("hermite-circle:w=3/2", text, "--levels", "2", "--jets")
        self.assertEqual(header, "fx,fy,px,py,rx,ry,sigma")
        self.assertEqual([row[:2] for row in all_columns], self.refined("hermite-circle:w=3/2", text, "--levels", "2")[1])
        # What came out goes in again.
        again = header + "\n" + "".join(",".join(row) + "\n" for row in all_columns[::4])
        for x, y in zip(self.refined("hermite-circle", again, "--levels", "2", "--at", "w=1.5")[1], all_columns):
            for a, b in zip(x, y):
                self.assertAlmostEqual(float(a), float(b), delta=1e-10 * (1 + abs(float(b))))
        # A repeated end vertex is left out.
        self.assertEqual(self.refined("hermite-circle", text + "0,0\n", "--levels", "2"),
                         self.refined("hermite-circle", text, "--levels", "2"))

    def test_columns_without_names(self):
        text = "1,0,0,8,-64,0\n0,1,-8,0,0,0\n-1,-1,1,-8,9,9\n"
        header, rows = self.refined("hermite-circle", text, "--levels", "1")
        self.assertEqual((header, len(rows)), ("fx,fy,px,py,rx,ry", 6))

    def test_first_pole(self):
        path = self.path("in.csv", "0,0\n4,-1\n5,2\n2,5\n-1,3\n")
        said = run("twoscale", "refine", "hermite-circle:w=1.25", "--levels", "1", path).stderr
        pole = float(said.split("w* =")[1])
        self.assertGreater(pole, 1)
        self.twoscale("refine", f"hermite-circle:w={pole - 1e-9!r}", "--levels", "3", path)
        self.refused("refine", f"hermite-circle:w={pole + 1e-9!r}", "--levels", "1", path, naming="w*")
        self.refused("refine", "hermite-circle", "--at", "w=100", "--levels", "1", path, naming="w*")
        self.assertEqual(run("twoscale", "refine", "hermite-circle:variant=c2,w=100", "--levels", "1", path).stderr, "")

    def test_refusals(self):
        def refused(text, *options, naming):
            out = self.path("out.csv")
            self.refused("refine", "hermite-circle", "--levels", "2", *options, self.path("bad.csv", text), "-o", out,
                         naming=naming)
            self.assertFalse(os.path.exists(out))
        refused("0,0\n1,1\n", naming="3 points")
        refused("0,0\n1,1\n2,2\n", naming="line")
        refused("1,1\n1,1\n1,1\n", naming="equal")
        refused("0,0\n1,0\nnan,1\n", naming="nan")
        refused("0,0,1,1\n1,0,1,1\n1,1,1,1\n", naming="4")
        refused("fx,fy,px\n0,0,1\n1,0,1\n1,1,1\n", naming="p")
        refused("fx,fy,lambda\n0,0,1\n1,0,1\n1,1,1\n", naming="lambda")
        refused("fx,fy,sigma\n1,0,0\n0,1,2\n-1,0,1\n", naming="sigma")
        refused("0,0\n1,0\n1,1\n", "--at", "w=0", naming="w")
        refused("0,0\n1,0\n1,1\n", "--at", "w=-1/2", naming="w")
        refused("0,0\n1,0\n1,1\n", "--v0", "2", naming="level variable")

    def test_cases_are_decided_in_intervals(self):
        """The first pole of these data is 1/tan(1/8): a tie is undecided, the 25th digit is seen."""
        path = self.path("in.csv", "fx,fy,px,py,rx,ry,sigma\n0,0,1,2,3,4,-1\n1,1,2,1,0,-1,0\n3,0,1,-2,-1,0,1\n")
        common = ("--levels", "2", "--digits", "30", "--open", "given", path)
        tie = run("twoscale", "refine", "hermite-circle", "--at", "w=1/tan(1/8)", *common)
        self.assertEqual((tie.returncode, tie.stdout, len(tie.stderr.splitlines())), (3, "", 1))
        self.assertIn("whether w is below the first pole", tie.stderr)
        self.twoscale("refine", "hermite-circle", "--at", "w=1/tan(1/8)-10^(-25)", *common)
        self.refused("refine", "hermite-circle", "--at", "w=1/tan(1/8)+10^(-25)", *common, naming="w*")

    def test_points_that_double_cannot_tell_apart(self):
        """With digits the numbers of the file are exact, also where it is decided which vertices measure the data."""
        near = ["0", "4", "5", "2", "-1"], ["0", "-1", "2", "5", "3"]
        text = "".join(f"{x},{y}\n" for x, y in zip(*near))
        tiny = "".join(f"{x}e-25,{y}e-25\n" for x, y in zip(*near))
        # Moved by (1, 1): in double one point. 1 + x*1e-25 written out.
        def moved(x):
            x = int(x)
            return f"1.{x:025d}" if x >= 0 else f"0.{10**25 + x:025d}"
        one = "".join(f"{moved(x)},{moved(y)}\n" for x, y in zip(*near))
        options = ("--levels", "1", "--digits", "60")
        self.refused("refine", "hermite-circle", "--levels", "1", self.path("one.csv", one), naming="equal")
        self.refused("refine", "hermite-circle", *options, self.path("same.csv", "1,1\n1.0,1e0\n1,1\n"), naming="equal")
        rows = self.refined("hermite-circle", one, *options)[1]
        self.assertEqual(len(rows), 10)
        for row, a, b in zip(rows[::2], *near):
            self.assertEqual([Fraction(x) - 1 for x in row], [Fraction(int(a), 10**25), Fraction(int(b), 10**25)])
        with mpmath.workdps(70):
            # Sizes alone do not matter.
            for a, b in zip(self.refined("hermite-circle", text, *options)[1], self.refined("hermite-circle", tiny, *options)[1]):
                for u, v in zip(a, b):
                    self.assertLess(abs(mpmath.mpf(u) - mpmath.mpf(v) * 10**25), mpmath.mpf(10)**-57)
        # The last vertex repeats the first one to 1e-14 of the size, here 5.38..e-14.
        for last, count in (("5.385e-14", 10), ("5.386e-14", 12)):
            self.assertEqual(len(self.refined("hermite-circle", text + f"{last},0\n", *options)[1]), count)

    def test_points_in_space(self):
        # No plane: the least moments agree. Digits agree with more digits.
        self.refused("refine", "hermite-circle", "--levels", "1", self.path("t.csv", "1,1,1\n1,-1,-1\n-1,1,-1\n-1,-1,1\n"),
                     naming="plane")
        text = "3,0,0.5\n1,2.5,-0.25\n-2,1,1\n-2.5,-1.5,0\n0.5,-2,0.75\n"
        few = self.refined("hermite-circle", text, "--levels", "2", "--digits", "20")[1]
        many = self.refined("hermite-circle", text, "--levels", "2", "--digits", "50")[1]
        double = self.refined("hermite-circle", text, "--levels", "2")[1]
        for a, b, c in zip(few, many, double):
            for x, y, z in zip(a, b, c):
                self.assertAlmostEqual(float(mpmath.mpf(x) - mpmath.mpf(y)), 0, delta=1e-19)
                self.assertAlmostEqual(float(y), float(z), delta=1e-12)

    def test_awkward_points(self):
        """What Algorithm 1 as printed mishandles: all come out finite and near their polygons."""
        turn = 2 * math.pi
        cases = {
            "repeated end vertex, up to rounding": [(math.cos(a), math.sin(a)) for a in (0, 1, 2.5, 4, turn)],
            "nearly collinear triples": [(0, 0), (2, 1e-9), (4, 0), (6, 0.3), (6, 3), (3, 3.002), (0, 3)],
            "collinear triples": [(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (0, 2)],
            "pentagram": [(math.cos(a), math.sin(a)) for a in (2 * turn * j / 5 for j in range(5))],
            "two turns, not round": [(2 * math.cos(a), math.sin(a) + 0.1 * math.cos(2 * a)) for a in (2 * turn * j / 7 for j in range(7))],
            "a vertex at the centre": [(0, 0), (1, 0), (1, 1), (-1, 1), (-1, -1), (1, -1)],
            "clockwise": [(0, 3), (3, 3.1), (4, 0), (1, -1)],
            "neighbours that are one point": [(0, 0), (1, 0.2), (3, 0), (1, 0.2), (0.5, 2)],
        }
        for name, points in cases.items():
            for options in ([], ["--open", "given"]):
                if options and name == "neighbours that are one point":
                    continue
                with self.subTest(name, open=bool(options)):
                    text = "".join(f"{x!r},{y!r}\n" for x, y in points)
                    rows = self.refined("hermite-circle", text, "--levels", "5", *options)[1]
                    size = max(math.hypot(x - u, y - v) for x, y in points for u, v in points)
                    for x, y in rows:
                        self.assertLess(min(math.hypot(float(x) - u, float(y) - v) for u, v in points), size)
        for x, y, z in self.refined("hermite-circle", "0,2,0\n4,2,-1\n5,2,2\n2,2,5\n-1,2,3\n", "--levels", "4")[1]:
            self.assertAlmostEqual(float(y), 2, delta=1e-13)  # a plane y = const

    def test_pictures(self):
        path = self.path("in.csv", "0,0\n4,-1\n5,2\n2,5\n-1,3\n")
        for kind, options in (("curve", []), ("comb", []), ("curvature", ["--at", "w=3/2"]), ("sweep", ["--values", "1/2,1,3/2"])):
            image = self.path(kind + ".svg")
            self.twoscale("plot", kind, "hermite-circle", *options, path, "-o", image)
            with open(image, encoding="utf-8") as file:
                self.assertIn("<svg", file.read())

    def test_commands_for_scalar_schemes_refuse(self):
        self.refused("table", "hermite-circle", "--levels", "2")
        self.refused("prove", "hermite-circle", "--claim", "sum-rules=2", naming="sum-rules")
        self.refused("regularity", "hermite-circle", "--over", "w=[1,2]", naming="--over")


class Proofs(Files):
    def certificate(self, scheme, *claims, status=0):
        path = self.path("certificate.json")
        options = [x for c in claims for x in ("--claim", c)]
        return path, self.twoscale_json("prove", scheme, *options, "--certificate", path, status=status)["claims"]

    def test_claims_and_certificates(self):
        for scheme, continuity, status in (("hermite-circle", "proved", 0), ("hermite-circle:variant=c2,w=7/5", "proved", 0),
                                           ("hermite-circle:w=7/5", "refuted", 1)):
            path, claims = self.certificate(scheme, status=status)
            verdicts = {(c["claim"], c["subject"]): c["verdict"] for c in claims}
            self.assertEqual(verdicts.pop(("continuity", "2")), continuity)
            self.assertEqual(verdicts.pop(("symmetric", ""), "refuted"), continuity)  # the same schemes
            self.assertEqual(set(verdicts.values()), {"proved"})
            self.assertIn("valid", self.check(path))
            self.assertIn("valid", self.twoscale("check", path))

    def test_counterexamples(self):
        path, claims = self.certificate("hermite-circle:w=7/5", "symmetric", "circle", status=1)
        self.assertEqual([c["verdict"] for c in claims], ["refuted", "refuted"])
        self.assertIn("30793/62500", claims[0]["witness"])
        report = self.check(path)
        self.assertIn("differs from that of the mirror image at s_0 = 0, s_1 = 1/7, w = 7/5", report)
        self.assertIn("leaves the circle at s_0 = 0, s_1 = 1/7, w = 7/5", report)

    def test_a_changed_coefficient_is_refused(self):
        path, _ = self.certificate("hermite-circle", "continuity=2")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace('"numerators": [\n     "', '"numerators": [\n     "-', 1).replace("--", ""))
        self.check(path, status=2)  # the seal

    def test_regularity(self):
        document = self.twoscale_json("regularity", "hermite-circle", "--at", "w=7/5")
        self.assertEqual((document["format"], document["continuity"], document["geometric"]), ("twoscale/regularity", 1, 2))
        self.assertIn("r jumps", document["reason"])
        self.assertEqual(self.twoscale_json("regularity", "hermite-circle")["continuity"], 2)
        text = self.twoscale("regularity", "hermite-circle:variant=c2,w=7/5")
        self.assertIn("continuity  C^2 in t", text)
        self.refused("regularity", "hermite-circle", "--at", "w=0", naming="w")
        self.refused("regularity", "hermite-circle", "--at", "w=sqrt(2)", naming="rational")

    def test_report(self):
        directory = self.path("page")
        summary = self.twoscale_json("report", "hermite2010", "-o", directory)
        self.assertTrue(summary["certificates_valid"])
        self.assertLess(summary["largest_exact_deviation"], 1e-12)
        with open(os.path.join(directory, "index.html"), encoding="utf-8") as file:
            page = file.read()
        # The commands of the page run in its directory.
        import html
        import re
        import shlex
        commands = [html.unescape(c) for c in re.findall(r'<span class="prompt">\$ </span>([^\n]*)', page)]
        self.assertGreater(len(commands), 8)
        for line in commands[:4] + commands[-2:]:
            words = shlex.split(line)
            self.assertEqual(words[0], "twoscale")
            done = run("twoscale", *words[1:], cwd=directory)
            self.assertIn(done.returncode, (0, 1) if words[1] == "prove" else (0,), line + done.stderr)
        self.refused("report", "hermite2010", "--at", "w=2", "-o", directory, naming="hermite2010")

    def test_scheme_pages(self):
        import html
        import re
        import shlex
        for scheme, verdicts in (("hermite-circle", [8, 0]), ("hermite-circle:w=7/5", [6, 3])):
            directory = self.path("page")
            summary = self.twoscale_json("report", scheme, "-o", directory)
            self.assertTrue(summary["certificates_valid"])
            self.assertEqual([summary["verdicts"][v] for v in ("proved", "refuted")], verdicts)
            with open(os.path.join(directory, "index.html"), encoding="utf-8") as file:
                page = file.read()
            for section in ("definition", "claims", "smoothness", "spectrum", "pictures"):
                self.assertIn(f'id="{section}"', page)
            for name in ("claims", "smoothness"):
                self.assertIn("valid", self.check(os.path.join(directory, "certificates", name + ".json")))
            commands = [html.unescape(c) for c in re.findall(r'<span class="prompt">\$ </span>([^\n]*)', page)]
            self.assertEqual(len(commands), 9)
            for line in commands if "w=7/5" in scheme else []:
                program, *words = shlex.split(line)
                done = run(program, *words, cwd=directory)
                self.assertIn(done.returncode, (0, 1) if words[0] == "prove" else (0,), line + done.stderr)
        self.refused("report", "hermite-circle", "--at", "w=2", "-o", self.path("none"), naming="w=2")
        self.assertFalse(os.path.exists(self.path("none")))
        # Beyond the first pole of the sample points the page says so.
        self.assertEqual(self.twoscale_json("report", "hermite-circle:w=100", "-o", self.path("far"))["pictures"], 1)
        self.assertIn("| symmetric |  | proved |", self.twoscale("report", "hermite-circle", "--format", "md"))

    def test_other_schemes_of_blocks(self):
        scheme = self.path("h.toml", '[scheme]\nname = "h"\nblock = 2\n'
                           '[[phase]]\nresidue = 0\nstencil = {"0" = [["1", "0"], ["0", "1"]]}\n'
                           '[[phase]]\nresidue = 1\nstencil = {"0" = [["1/2", "1/8"], ["-3/2", "-1/4"]], '
                           '"1" = [["1/2", "-1/8"], ["3/2", "-1/4"]]}\n')
        claims = self.twoscale_json("prove", scheme)["claims"]
        self.assertEqual([(c["claim"], c["subject"], c["verdict"]) for c in claims],
                         [("interpolatory", "", "proved"), ("symmetric", "", "proved"), ("spectral", "3", "proved")])
        summary = self.twoscale_json("report", scheme, "-o", self.path("page"))
        self.assertEqual((summary["verdicts"]["proved"], summary["pictures"]), (3, 0))
        self.assertIn("undecided", self.twoscale("prove", scheme, "--claim", "continuity=1", status=3))
        self.assertIn("undecided", self.twoscale("regularity", scheme, status=3))


if __name__ == "__main__":
    unittest.main()
