# SPDX-License-Identifier: GPL-3.0-or-later
"""`refine` with a column v0: a tension for each edge."""

import csv
import io
import math
import os
import tempfile
import unittest
from decimal import Decimal

from support import ProgramTest


class EdgeTension(ProgramTest):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)

    def points(self, rows, header="x,y,v0"):
        path = os.path.join(self.directory.name, "in.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write(header + "\n" + "".join(",".join(map(str, row)) + "\n" for row in rows))
        return path

    @staticmethod
    def rows(text):
        return [tuple(map(float, row)) for row in list(csv.reader(io.StringIO(text)))[1:]]

    def test_equal_values_are_the_uniform_scheme(self):
        square = [(1, 0), (0, 1), (-1, 0), (0, -1)]
        mixed = self.twoscale("refine", "tension4", "--levels", "4", self.points([p + (0,) for p in square]))
        uniform = self.twoscale("refine", "tension4", "--levels", "4", "--v0", "0", self.points(square, "x,y"))
        self.assertEqual([line.rsplit(",", 1)[0] for line in mixed.splitlines()], uniform.splitlines())
        last = self.rows(mixed)[0][2]
        self.assertEqual(last, math.cos(math.pi / 32))

    def test_a_circle_stays_one_away_from_the_change(self):
        n, levels = 12, 6
        v = math.cos(2 * math.pi / n)
        points = [(math.cos(2 * math.pi * j / n), math.sin(2 * math.pi * j / n)) for j in range(n)]
        # Edges 0..7 have the circle's value, the others are tight.
        rows = [p + (repr(v) if j < 8 else 50,) for j, p in enumerate(points)]
        out = self.rows(self.twoscale("refine", "tension4", "--levels", levels, self.points(rows)))
        inside = out[1 * 2 ** levels:7 * 2 ** levels + 1]
        for x, y, _ in inside:
            self.assertAlmostEqual(math.hypot(x, y), 1, delta=1e-14)
        self.assertLess(math.hypot(*out[2 ** levels // 2][:2]), 1.5)
        outside = out[8 * 2 ** levels:12 * 2 ** levels]
        self.assertGreater(max(abs(1 - math.hypot(x, y)) for x, y, _ in outside), 1e-2)

    def test_digits_and_refining_again(self):
        rows = [(0, 0, 1), (4, 0, 20), (4, 3, "0.1"), (0, 3, 20)]
        whole = self.twoscale("refine", "tension4", "--levels", "3", "--digits", "40", self.points(rows))
        path = os.path.join(self.directory.name, "half.csv")
        self.twoscale("refine", "tension4", "--levels", "1", "--digits", "60", "-o", path, self.points(rows))
        again = self.twoscale("refine", "tension4", "--levels", "2", "--digits", "40", path)
        numbers = [[Decimal(x) for line in text.splitlines()[1:] for x in line.split(",")] for text in (whole, again)]
        self.assertEqual(len(numbers[0]), 4 * 8 * 3)
        for x, y in zip(*numbers):
            self.assertLess(abs(x - y), Decimal("1e-37"))

    def test_open_polygons_and_other_formats(self):
        rows = [(j, j * j % 5, 1 + j % 3) for j in range(8)]
        for rule in ("given", "linear", "space"):
            out = self.rows(self.twoscale("refine", "tension4", "--levels", "2", f"--open={rule}", self.points(rows)))
            self.assertEqual(len(out), (8 - (4 if rule == "given" else 0) - 1) * 4 + 1)
            first = 2 if rule == "given" else 0
            self.assertEqual(out[0][:2], (float(rows[first][0]), float(rows[first][1])))
            value = rows[first][2]
            for _ in range(2):
                value = math.sqrt((1 + value) / 2)
            self.assertAlmostEqual(out[0][2], value, delta=1e-15)
        obj = self.twoscale("refine", "tension4", "--levels", "1", "--format", "obj", self.points(rows))
        self.assertIn("v 0 0 0\n", obj)
        self.assertIn("property double v0", self.twoscale("refine", "tension4", "--levels", "1", "--format", "ply",
                                                          self.points(rows)))

    def test_refusals(self):
        rows = [(0, 0, 1), (1, 0, 2), (1, 1, 3)]
        self.refused("refine", "tension4", "--v0", "2", "--levels", "1", self.points(rows), naming="--v0")
        self.refused("refine", "dd:l=2", "--levels", "1", self.points(rows), naming="dd:l=2")
        self.refused("refine", "mixed:n=1", "--levels", "1", self.points(rows), naming="mixed")
        self.refused("refine", "tension4", "--levels", "1", self.points([(0, 0, 1), (1, 0, -1), (1, 1, 3)]), naming="-1")
        self.refused("refine", "tension4", "--levels", "1", self.points([(1,), (2,), (3,)], "v0"), naming="v0")
        # A singular step of one edge: v^0 = -1/2 for the harmonic 6-point scheme.
        self.refused("refine", "interpolating:family=harmonic,l=3", "--levels", "1",
                     self.points([(0, 0, 1), (1, 0, "-0.5"), (1, 1, 3)]), naming="-0.5")


if __name__ == "__main__":
    unittest.main()
