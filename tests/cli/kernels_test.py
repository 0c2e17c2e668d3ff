# SPDX-License-Identifier: GPL-3.0-or-later
"""`refine` as docs/kernels.md describes it: pieces, threads, limits, chord errors."""

import os
import subprocess
import unittest
from fractions import Fraction

import numpy

from support import FilesTest, program

SQUARE = "x,y\n0,0\n8,0\n8,8\n0,8\n"


class Kernels(FilesTest):
    def refine(self, *arguments, name="out.npy", points=SQUARE, scheme="dd:l=3"):
        self.twoscale("refine", scheme, *arguments, self.path("in.csv", points), "-o", self.path(name))
        return numpy.load(self.path(name)) if name.endswith(".npy") else open(self.path(name), encoding="utf-8").read()

    def bytes(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()


class Pieces(Kernels):
    def test_threads_do_not_show_in_the_bytes(self):
        self.refine("--levels", "16", "--threads", "1", name="one.npy")
        self.refine("--levels", "16", "--threads", "2", name="two.npy")
        self.assertEqual(self.bytes("one.npy"), self.bytes("two.npy"))
        self.assertEqual(len(self.bytes("one.npy")), 128 + 4 * 2**16 * 16)

    def test_csv_and_npy_hold_the_same_numbers(self):
        points = self.refine("--levels", "10")
        text = self.refine("--levels", "10", name="out.csv")
        self.assertEqual(text.splitlines()[0], "x,y")
        self.assertEqual([list(map(float, line.split(","))) for line in text.splitlines()[1:]], points.tolist())
        self.assertEqual(self.twoscale("refine", "dd:l=3", "--levels", "10", self.path("in.csv")), text)
        # obj is written as a whole.
        obj = self.refine("--levels", "10", name="out.obj")
        vertices = [list(map(float, line.split()[1:3])) for line in obj.splitlines() if line.startswith("v ")]
        self.assertEqual(vertices, points.tolist())

    def test_memory_does_not_grow_with_the_output(self):
        def peak(levels):
            code = ("import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True); "
                    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
            return int(subprocess.run(["/usr/bin/python3", "-c", code, program("twoscale"), "refine", "dd:l=3", "--levels",
                                       str(levels), self.path("in.csv", SQUARE), "-o", self.path("big.npy")],
                                      check=True, capture_output=True, text=True).stdout)
        if "asan" in program("twoscale"):
            self.skipTest("the sanitizer keeps what is freed")
        # 2^20 numbers are a piece; 4*2^20 points of 2 numbers are 64 MB.
        self.assertLess(peak(20) - peak(10), 40_000)

    def test_nothing_is_left_of_a_run_that_fails(self):
        huge = "1e308,0\n-1e308,1e308\n1e308,-1e308\n-1e308,0\n1e308,0\n"
        for name in ("out.npy", "out.csv"):
            self.refused("refine", "mask:coefficients=\"[-1,2,3,2,-1]\",lowest=-2", "--levels", "2",
                         self.path("huge.csv", huge), "-o", self.path(name), naming="does not fit a double")
        self.refused("refine", "mask:coefficients=\"[-1,2,3,2,-1]\",lowest=-2", "--levels", "2", self.path("huge.csv"))
        self.assertEqual(os.listdir(self.directory.name), ["huge.csv"])


class Limits(Kernels):
    def test_the_cubic_spline(self):
        rows = self.refine("--levels", "1", "--limit", "--with", "derivative,curvature", name="out.csv",
                           scheme="bspline:n=3").splitlines()
        self.assertEqual(rows[0], "x,y,dx,dy,curvature")
        first = [float(x) for x in rows[1].split(",")]
        for got, want in zip(first, (4 / 3, 4 / 3, 4, -4, 8**0.5 / 8)):
            self.assertAlmostEqual(got, want, places=14)
        # An interpolating rule keeps its points.
        self.assertEqual(self.refine("--levels", "4", "--limit").tolist(), self.refine("--levels", "4").tolist())

    def test_the_stencils_are_those_of_spectrum(self):
        # `spectrum` has them exactly, from the eigenvectors of the local matrix.
        impulse = "x\n" + "".join("1\n" if i == 6 else "0\n" for i in range(13))
        for scheme in ("bspline:n=3", "bspline:n=5", "dd:l=2", "dd:l=3", "bspline:n=3,arity=3"):
            rows = self.refine("--levels", "0", "--limit", "--with", "derivative", points=impulse, scheme=scheme)
            for stencil in self.twoscale_json("spectrum", scheme)["limit_stencils"][:2]:
                exact = numpy.zeros(13)
                for u, weight in enumerate(stencil["coefficients"], stencil["lowest"]):
                    exact[6 - u] = float(Fraction(weight))
                got = rows[:, stencil["derivative"]]
                self.assertLess(numpy.abs(got - exact).max(), 1e-15, scheme)

    def test_the_curvature_of_a_circle(self):
        circle = "".join(f"{5 * numpy.cos(numpy.pi * j / 4)!r},{5 * numpy.sin(numpy.pi * j / 4)!r}\n" for j in range(8))
        rows = self.refine("--v0", "cos(pi/4)", "--levels", "6", "--limit", "--with", "curvature", points=circle,
                           scheme="interpolating:family=harmonic,l=4")
        self.assertEqual(rows.shape, (512, 3))
        self.assertLess(numpy.abs(rows[:, 2] - 0.2).max(), 1e-9)

    def test_refusals(self):
        points = self.path("in.csv", SQUARE)
        refine = ("refine", "dd:l=2", "--levels", "2", points)
        self.refused(*refine, "--with", "derivative", naming="derivative")
        self.refused(*refine, "--limit", "--with", "curvature", naming="order 2")
        self.refused(*refine, "--limit", "--with", "colour", naming="colour")
        self.refused(*refine, "--limit", "--open=linear", naming="ends")
        self.refused(*refine, "--limit", "--digits", "30", naming="--limit")
        self.refused("refine", "bspline:n=0", "--levels", "2", "--limit", points, naming="bspline")
        self.refused("refine", "nuli4", "--levels", "2", "--limit", points, naming="nuli4")
        self.refused("refine", "bspline:n=3", "--levels", "2", "--limit", "--with", "derivative",
                     self.path("clash.csv", "x,dx\n0,0\n1,0\n1,1\n"), naming="dx")


class Chord(Kernels):
    def test_it_stops_when_it_is_near_enough(self):
        points = self.refine("--levels", "20", "--chord", "0.001", scheme="bspline:n=3")
        self.assertEqual(len(points), 4 * 2**6)  # |D^2| = 8 sqrt(2)/4^6 at level 6, a sixth of it is the bound
        fewer = self.refine("--levels", "2", "--chord", "1e-9", scheme="bspline:n=3")
        self.assertEqual(len(fewer), 16)
        self.assertEqual(self.refine("--levels", "6", scheme="bspline:n=3").tolist(), points.tolist())

    def test_refusals(self):
        points = self.path("in.csv", SQUARE)
        self.refused("refine", "dd:l=2", "--levels", "2", "--chord", "0", points, naming="--chord")
        self.refused("refine", "dd:l=2", "--levels", "2", "--chord", "0.1", "--open=given", points)
        self.refused("refine", "exponential-bspline:space=\"exp(t*x),exp(-t*x)\"", "--v0", "1/2", "--levels", "2",
                     "--chord", "0.1", points, naming="1 and x")


if __name__ == "__main__":
    unittest.main()
