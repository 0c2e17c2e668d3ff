# SPDX-License-Identifier: GPL-3.0-or-later
"""Grids in `refine` and `plot surface`, `surface` descriptions, from outside."""

import math
import re
import unittest

from support import FilesTest, run

KLEIN = """
x = "(3+cos(pi*u/4)*sin(pi*v/2)-sin(pi*u/4)*sin(pi*v))*cos(pi*u/2)"
y = "(3+cos(pi*u/4)*sin(pi*v/2)-sin(pi*u/4)*sin(pi*v))*sin(pi*u/2)"
z = "sin(pi*u/4)*sin(pi*v/2)+cos(pi*u/4)*sin(pi*v)"
[u]
step = "1/2"
count = 16
[v]
step = "1/2"
count = 8
"""


class Grids(FilesTest):
    def torus(self, rows=8, columns=6):
        text = f"# grid {rows}x{columns}\nx,y,z\n"
        for i in range(rows):
            for j in range(columns):
                u, v = 2 * math.pi * i / rows, 2 * math.pi * j / columns
                text += f"{(3 + math.cos(v)) * math.cos(u)!r},{(3 + math.cos(v)) * math.sin(u)!r},{math.sin(v)!r}\n"
        return self.path("torus.csv", text)

    TORUS = ["--v0", "cos(pi/4)", "--tensor-v0", "1/2"]

    @staticmethod
    def rows(text):
        return [tuple(map(float, line.split(","))) for line in text.splitlines() if re.match(r"[-+.\d]", line)]


class Refine(Grids):
    def test_a_torus_from_8_by_6_points(self):
        text = self.twoscale("refine", "tension4", *self.TORUS, "--levels", 3, self.torus())
        self.assertEqual(text.splitlines()[:2], ["# grid 64x48", "x,y,z"])
        for x, y, z in self.rows(text):
            self.assertAlmostEqual((math.hypot(x, y) - 3) ** 2 + z ** 2, 1, places=13)

    def test_what_is_written_is_read(self):
        torus = self.torus()
        once = {}
        for form in ("csv", "npy", "obj"):
            file = self.path("once." + form)
            self.twoscale("refine", "tension4", *self.TORUS, "--levels", 1, torus, "-o", file)
            once[form] = self.twoscale("refine", "tension4", "--v0", "cos(pi/8)", "--tensor-v0", "cos(pi/6)",
                                       "--levels", 1, file)
        self.assertEqual(once["csv"], once["npy"])
        self.assertEqual(once["csv"], once["obj"])
        ply = self.twoscale("refine", "tension4", *self.TORUS, "--levels", 1, torus, "--format", "ply")
        self.assertIn("element face 192\n", ply)

    def test_directions_of_their_own(self):
        text = self.twoscale("refine", "bspline:n=3", "--open", "linear", "--tensor", "bspline:n=2", "--tensor-closed",
                             "--tensor-levels", 1, "--levels", 2, self.torus())
        self.assertEqual(text.splitlines()[0], "# grid 29x12")

    def test_digits(self):
        grid = self.path("g.csv", "# grid 3x4\n" + "".join(f"{i * j}.1\n" for i in range(3) for j in range(4)))
        text = self.twoscale("refine", "dd:l=2", "--levels", 1, "--digits", 20, grid)
        doubles = self.twoscale("refine", "dd:l=2", "--levels", 1, grid)
        self.assertEqual(text.splitlines()[0], "# grid 6x8")
        for a, b in zip(self.rows(text), self.rows(doubles)):
            self.assertAlmostEqual(a[0], b[0], places=13)

    def test_refusals(self):
        torus = self.torus()
        self.refused("refine", "tension4", *self.TORUS, "--levels", 1, torus, "--format", "svg", naming="svg")
        self.refused("refine", "tension4", "--v0", "0", "--levels", 1, "--tensor", "nosuch", torus, naming="nosuch")
        self.refused("refine", "tension4", "--v0", "0", "--levels", 1, "--tensor", "tension4", torus, naming="--tensor")
        self.refused("refine", "tension4", "--v0", "0", "--levels", 1, "--tensor-open", "ajar", torus, naming="ajar")
        polygon = self.path("p.csv", "0,0\n1,0\n1,1\n")
        self.refused("refine", "dd:l=2", "--levels", 1, "--tensor", "dd:l=2", polygon, naming="--tensor")
        self.refused("refine", "dd:l=2", "--levels", 1, self.path("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                     naming="t.obj:4")
        self.refused("refine", "dd:l=2", "--levels", 30, torus, naming="too many points")
        mesh = self.path("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 3 4 2\n")
        self.refused("refine", "dd:l=2", "--levels", 1, mesh, naming="--open RULE")
        self.refused("refine", "dd:l=2", "--levels", 1, "--tensor-open", "linear", mesh, naming="--open RULE")
        sheet = self.twoscale("refine", "dd:l=2", "--levels", 1, "--open", "linear", mesh, "--format", "obj")
        self.assertEqual((sheet.count("\nv "), sheet.count("\nf ")), (9, 4))

    def test_pictures(self):
        file = self.path("t.png")
        self.twoscale("plot", "surface", "tension4", *self.TORUS, self.torus(), "--levels", 2, "-o", file)
        with open(file, "rb") as image:
            self.assertEqual(image.read(4), b"\x89PNG")
        self.refused("plot", "surface", "tension4", "--v0", "0", self.path("p.csv", "0,0\n1,0\n1,1\n"), naming="p.csv")
        self.refused("plot", "curve", "dd:l=2", "--tensor", "dd:l=2", self.path("q.csv", "0,0\n1,0\n1,1\n"),
                     naming="--tensor")


class Surface(Grids):
    def test_two_ways_return_the_klein_bottle(self):
        d = self.twoscale_json("surface", self.path("klein.toml", KLEIN), "--explain", "--levels", 2)
        self.assertEqual((d["u"]["turns"], d["u"]["least_samples"]), ([1, 2, 3], 7))
        self.assertEqual((d["v"]["turns"], d["v"]["least_samples"]), ([0, 1, 2], 5))
        self.assertEqual([len(way["summands"]) for way in d["ways"]], [1, 5])
        for way in d["ways"]:
            self.assertEqual((way["rows"], way["columns"]), (64, 32))
            self.assertLess(way["largest_deviation"], 1e-14)

    def test_one_frequency_too_few_is_seen(self):
        wrong = KLEIN.replace("[v]", 'scheme = "tension4"\nv0 = "cos(pi/8)"\n[v]')
        d = self.twoscale_json("surface", self.path("wrong.toml", wrong), "--explain", "--levels", 2)
        self.assertGreater(d["ways"][0]["largest_deviation"], 1e-3)

    def test_points_come_out(self):
        text = self.twoscale("surface", self.path("klein.toml", KLEIN), "--levels", 1, "--digits", 25)
        self.assertEqual(text.splitlines()[0], "# grid 32x16")
        x, y, z = self.rows(text)[1 * 16 + 3]  # u = 1/4, v = 3/4
        u, v = math.pi / 16, 3 * math.pi / 8
        r = 3 + math.cos(u) * math.sin(v) - math.sin(u) * math.sin(2 * v)
        self.assertAlmostEqual(x, r * math.cos(2 * u), places=14)
        self.assertAlmostEqual(y, r * math.sin(2 * u), places=14)
        self.assertAlmostEqual(z, math.sin(u) * math.sin(v) + math.cos(u) * math.sin(2 * v), places=14)
        file = self.path("k.svg")
        self.twoscale("surface", self.path("klein.toml"), "--levels", 1, "-o", file)
        self.assertTrue(open(file, encoding="utf-8").read().startswith("<?xml"))

    def test_summands_of_grids(self):
        # cos u cos v + cos 2u: two grids, two pairs.
        n = 9
        for name, f in (("a.csv", lambda u, v: math.cos(u) * math.cos(v)), ("b.csv", lambda u, v: math.cos(2 * u))):
            self.path(name, f"# grid {n}x{n}\nz\n" + "".join(
                f"{f(2 * math.pi * i / n, 2 * math.pi * j / n)!r}\n" for i in range(n) for j in range(n)))
        text = ""
        for name, t in (("a.csv", "2*pi/9"), ("b.csv", "4*pi/9")):
            text += f'[[summand]]\ngrid = "{name}"\nu = {{scheme = "tension4", v0 = "cos({t})"}}\n' \
                    f'v = {{scheme = "tension4", v0 = "cos(2*pi/9)"}}\n'
        out = self.rows(self.twoscale("surface", self.path("sum.toml", text), "--levels", 2))
        self.assertEqual(len(out), (4 * n) ** 2)
        for i in range(4 * n):
            for j in range(0, 4 * n, 5):
                u, v = 2 * math.pi * i / (4 * n), 2 * math.pi * j / (4 * n)
                self.assertAlmostEqual(out[i * 4 * n + j][0], math.cos(u) * math.cos(v) + math.cos(2 * u), places=13)

    def test_refusals_name_file_line_and_text(self):
        def refused(change, naming, *arguments):
            old, new = change
            self.assertIn(old, KLEIN)
            message = self.refused("surface", self.path("bad.toml", KLEIN.replace(old, new)), "--levels", 1, *arguments,
                                   naming=naming)
            self.assertIn("bad.toml", message)
            return message

        self.assertIn("bad.toml:4", refused(('z = "sin(pi*u/4)', 'z = "tan(pi*u/4)'), "tan"))
        self.assertIn("bad.toml:4", refused(('z = "sin(', 'z = "sin(('), ""))
        self.assertIn("bad.toml:7", refused(("count = 16", "count = -3"), "count"))
        self.assertIn("bad.toml:7", refused(("count = 16", "counts = 16"), "counts"))
        self.assertIn("bad.toml:6", refused(('step = "1/2"\ncount = 16', "step = 0.5\ncount = 16"), "step"))
        self.assertIn("bad.toml:11", refused(("count = 8", 'count = 8\nends = "ajar"'), "ajar"))
        refused(("count = 8", 'count = 8\nv0 = "0"'), "without a scheme")
        refused(("[v]", "[w]"), "w")
        refused(("[u]", "[u"), "")
        self.refused("surface", self.path("half.toml", KLEIN.replace("16", "8")), naming="does not close")
        self.refused("surface", self.path("linear.toml", KLEIN + 'ends = "linear"\n'), naming="linear")
        self.refused("surface", self.path("few.toml", KLEIN.replace("16", "6").replace('"1/2"', '"4/3"', 1)), naming="")
        self.refused("surface", self.path("empty.toml", ""), naming="formulas")
        self.refused("surface", self.path("klein.toml", KLEIN), "--format", "json", naming="--explain")
        self.refused("surface", self.path("klein.toml", KLEIN), "-o", self.path("x.bmp"), naming="bmp")
        self.assertEqual(run("twoscale", "surface", self.path("nowhere.toml")).returncode, 4)
        self.refused("surface", self.path("g.toml", '[[summand]]\ngrid = "g.csv"\n'), naming="scheme")
        self.path("poly.csv", "1,2\n3,4\n")
        self.refused("surface", self.path("p.toml", '[[summand]]\ngrid = "poly.csv"\nu = {scheme = "dd:l=2"}\n'
                                                    'v = {scheme = "dd:l=2"}\n'), naming="poly.csv")


if __name__ == "__main__":
    unittest.main()
