# SPDX-License-Identifier: GPL-3.0-or-later
"""`refine` as docs/kernels.md describes it: pieces, threads."""

import os
import subprocess
import unittest

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


if __name__ == "__main__":
    unittest.main()
