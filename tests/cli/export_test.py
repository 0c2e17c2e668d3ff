# SPDX-License-Identifier: GPL-3.0-or-later
"""`table --format F`: what can be read without the consumers' own tools."""

import re
import unittest
from fractions import Fraction

from support import FilesTest

SCHEMES = (("tension4", "--v0=-2/5"), ("bspline:n=2",), ("interpolating:family=mixed,l=2,arity=3", "--v0", "2"))
POLYGON = [(0.0, 0.0), (1.0, 0.1), (2.0, 1.0), (1.0, 3.0), (0.0, 2.0)]


class Formats(FilesTest):
    def refined(self, scheme, levels):
        file = self.path("in.csv", "".join(f"{x!r},{y!r}\n" for x, y in POLYGON))
        text = self.twoscale("refine", *scheme, "--levels", str(levels), file)
        return [complex(*map(float, line.split(","))) for line in text.splitlines()[1 if text[0] == "x" else 0:]]

    def close(self, got, want):
        self.assertEqual(len(got), len(want))
        self.assertLess(max(abs(a - b) for a, b in zip(got, want)), 1e-14)

    def test_python_module_refines(self):
        for scheme in SCHEMES:
            space = {}
            exec(self.twoscale("table", *scheme, "--levels", "3", "--digits", "30", "--format", "python"), space)  # noqa: S102
            points = [complex(x, y) for x, y in POLYGON]
            opened = space["apply_open"](0, points)
            for k in range(3):
                points = space["apply"](k, points)
                first = space["highest"] + 1 - space["arity"] if k == 0 else 0
                if k == 0:
                    self.close(opened, [points[i % len(points)] for i in range(first, first + len(opened))])
            self.close(points, self.refined(scheme, 3))
            table = self.twoscale_json("table", *scheme, "--levels", "3", "--digits", "30")
            self.assertEqual(space["mask_text"][1], table["levels"][1]["coefficients"])
            self.assertEqual(space["mask"][1], [float(x) for x in table["levels"][1]["coefficients"]])

    def test_matrix_market(self):
        for scheme in SCHEMES:
            text = self.twoscale("table", *scheme, "--levels", "2", "--points", "5", "--format", "matrixmarket")
            lines = [line.split() for line in text.splitlines() if not line.startswith("%")]
            rows, columns, entries = map(int, lines[0])
            self.assertEqual((columns, entries), (5, len(lines) - 1))
            out = [0j] * rows
            for i, j, weight in lines[1:]:
                out[int(i) - 1] += float(weight) * complex(*POLYGON[int(j) - 1])
            self.close(out, self.refined(scheme, 2))
            self.assertIn("errors of a row add up to at most", text)

    def test_filter_banks_reconstruct(self):
        for scheme in (("tension4", "--v0=-2/5"), ("bspline:n=2",), ("bspline:n=3",), ("mixed:n=1", "--t", "1")):
            space = {}
            exec(self.twoscale("table", *scheme, "--levels", "2", "--format", "pywavelets"), space)  # noqa: S102
            for k in (0, 1, 7):
                dec_lo, dec_hi, rec_lo, rec_hi = space["filter_bank"](k)
                n = space["length"]
                self.assertEqual({len(dec_lo), len(dec_hi), len(rec_lo), len(rec_hi)}, {n})
                if "mixed" not in scheme[0]:
                    self.assertAlmostEqual(sum(rec_lo), 2 ** 0.5, 14)
                for sign in (1, -1):  # rec_lo(z) dec_lo(+-z) + rec_hi(z) dec_hi(+-z) = 2 z^{n-1} or 0
                    product = [0.0] * (2 * n - 1)
                    for r, d in ((rec_lo, dec_lo), (rec_hi, dec_hi)):
                        for i in range(n):
                            for j in range(n):
                                product[i + j] += r[i] * d[j] * sign ** j
                    product[n - 1] -= 2 * (sign > 0)
                    self.assertLess(max(map(abs, product)), 1e-14, scheme)
        self.refused("table", "bspline:n=2,arity=3", "--levels", "1", "--format", "pywavelets", naming="bspline:arity=3,n=2")

    def test_numbers_are_the_same_everywhere(self):
        """Julia, MATLAB, TypeScript and LaTeX without their tools: the numbers in the text are those of the table."""
        arguments = ("table", "interpolating:family=harmonic,l=3", "--v0", "1/2", "--levels", "2")
        table = self.twoscale_json(*arguments, "--double")
        want = [float(x) for row in [*table["levels"], table["limit"]] for x in row["coefficients"]]
        number = r"-?\d+\.?\d*(?:e[-+]?\d+)?"
        for language, start, end in (("julia", "const mask = [", "\n]\n"), ("typescript", "number[])[] = [", "\n];"),
                                     ("matlab", ".mask = zeros(11, 3);", "\n];\n% end")):
            text = self.twoscale(*arguments, "--format", language)
            body = (text + "% end").split(start, 1)[1].split(end)[0]
            body = re.sub(r"(#|//|%).*|twoscale\w*\.mask\(.*\)", "", body)
            self.assertEqual([float(x) for x in re.findall(number, body)], want, language)
        text = self.twoscale(*arguments, "--double", "--format", "latex")
        rows = re.findall(r"& \$(-?\d+)\$ & \$([^$]*)\$ \\\\", text)
        self.assertEqual([float(re.sub(r" \\cdot 10\^\{(-?\d+)\}", r"e\1", x)) for _, x in rows], want)
        self.assertEqual([int(i) for i, _ in rows], 3 * list(range(-5, 6)))

    def test_every_format_is_deterministic_and_hides_no_option(self):
        formats = ("json csv c cpp python npy julia matlab glsl typescript latex pywavelets stencil matrixmarket").split()
        for name in formats:
            path = [self.path(f"{i}.out") for i in range(2)]
            for p in path:
                self.twoscale("table", "tension4", "--v0", "2", "--levels", "2", "--format", name, "-o", p)
            with open(path[0], "rb") as one, open(path[1], "rb") as two:
                data = one.read()
                self.assertEqual(data, two.read())
            self.assertIn(b"0BSD", data)
        self.refused("table", "tension4", "--v0", "2", "--levels", "2", "--format", "javascript", naming="javascript")
        self.refused("table", "tension4", "--v0", "2", "--levels", "2", "--format", "stencil", "--points", "2", naming="2")
        self.refused("table", "tension4", "--v0", "2", "--levels", "30", "--format", "stencil", naming="too large")
        self.refused("table", "tension4", "--v0", "2", "--levels", "2", "--format", "julia", "--prefix", "a-b", naming="a-b")
        self.refused("table", "tension4", "--v0", "2", "--levels", "2", "--format", "glsl", "--normalisation", "sum1",
                     naming="sum1")

    def test_c_hex_floats_are_the_rounded_doubles(self):
        table = self.twoscale_json("table", "tension4", "--v0=-2/5", "--levels", "2", "--double")
        text = self.twoscale("table", "tension4", "--v0=-2/5", "--levels", "2", "--format", "c", "--hex")
        hexes = re.findall(r"-?0x[0-9a-f.]+p[-+]\d+", text)
        self.assertEqual(hexes, [x for row in [*table["levels"], table["limit"]] for x in row["hex"]])
        exact = self.twoscale_json("table", "tension4", "--v0=-2/5", "--levels", "2", "--digits", "60")
        for row, fine in zip(table["levels"], exact["levels"]):
            for x, y in zip(row["hex"], fine["coefficients"]):
                value = float.fromhex(x)
                self.assertLessEqual(abs(Fraction(value) - Fraction(y)), Fraction(abs(value)) / 2 ** 53)


if __name__ == "__main__":
    unittest.main()
