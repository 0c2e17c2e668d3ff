# SPDX-License-Identifier: GPL-3.0-or-later
"""`table --evaluator`: programs in C, C++ and Python agree with the exact masks within the error that they state."""

import re
import subprocess
import unittest
from fractions import Fraction

from evaluators import U, Evaluators
from support import FilesTest


class Accuracy(FilesTest):
    def setUp(self):
        super().setUp()
        self.all = Evaluators(self.directory.name)

    def test_python_c_and_cpp_keep_their_bounds(self):
        exact = self.all.exact()
        results = {language: getattr(self.all, language)() for language in ("python", "c", "cpp")}
        for language, result in results.items():
            self.assertEqual(self.all.failures(result, exact), [], language)
        # The same operations, the same bits.
        self.assertEqual(results["c"], results["python"])
        self.assertEqual(results["c"], results["cpp"])
        # A last place too much is seen, wherever it is.
        names = [name for _, name, _, _ in self.all.calls()]
        for name, _ in self.all.cases:
            broken = [list(r) for r in results["python"]]
            at = names.index(name)
            broken[at][-1] *= 1 + (self.all.bound(name) + 1) * 2.0 ** -52
            self.assertEqual([f[0] for f in self.all.failures(broken, exact)], [name] if broken[at][-1] else [])

        i = next(i for i, call in enumerate(self.all.calls()) if call[2] == "next")
        broken = [list(r) for r in results["python"]]
        broken[i][0] *= 1 + 2.0 ** -50
        self.assertEqual(len(self.all.failures(broken, exact)), 1)

    def test_twice_the_precision_is_needed(self):
        case = next(c for c in self.all.cases if "harmonic" in c[0])
        self.all.cases = [case]
        space = {}
        exec(self.all.source(case[0], "python", "e"), space)  # noqa: S102
        exact = self.all.formula(case[0])
        limit = self.all.bound(case[0]) * U

        def worst():
            return max(abs(Fraction(got) / value - 1) for point in case[1]
                       for got, value in zip(space["e_mask"](*point), exact(point)) if value)
        self.assertLess(worst(), limit * Fraction(101, 100))
        space["_e_step"] = lambda s, x, c: (s[0] * x + c[0], 0)
        self.assertGreater(worst(), 1000 * limit)

    def test_python_takes_arrays_and_other_numbers(self):
        import mpmath
        import numpy
        space = {}
        exec(self.twoscale("table", "tension4", "--evaluator", "--format", "python", "--prefix", "e"), space)  # noqa: S102
        v = numpy.array([0.5, 1.0, 3.0])
        self.assertEqual(space["e_mask"](v)[2].tolist(), [space["e_mask"](x)[2] for x in v.tolist()])
        self.assertEqual(space["e_mask"](Fraction(1, 2))[2], Fraction(2, 3))
        with mpmath.workdps(50):
            v = space["e_start"](mpmath.mpf(-2) / 5)[0]
            self.assertLess(abs(space["e_mask"](v)[0] + 1 / (8 * v * (1 + v))), mpmath.mpf("1e-49"))

    def test_the_whole_catalogue(self):
        for entry in self.twoscale_json("list")["entries"]:
            for name in entry["examples"]:
                space = {}
                text = self.twoscale("table", name, "--evaluator", "--format", "python", "--prefix", "e")
                exec(text, space)  # noqa: S102
                names = re.search(r"def e_mask\((.*)\):", text).group(1).split(", ")
                bound = re.search(r"at most (\d+)\*u", re.sub(r"\n#\s*", " ", text))
                limit = int(bound.group(1)) * U * Fraction(101, 100) if bound else 0
                exact = self.all.formula(name)
                for shift in (0.0, 0.09375):
                    point = [{"v": 0.8125, "d": 0.75, "l": 0.4375, "s": -0.125}.get(n[0], 0.1171875) + shift + i / 32
                             for i, n in enumerate(names) if n]
                    for got, value in zip(space["e_mask"](*point), exact(point), strict=True):
                        self.assertLessEqual(abs(Fraction(got) - value), limit * abs(value), (name, point))

    def test_sequence_of_levels_follows_the_table(self):
        for name, v0 in (("interpolating:family=harmonic,l=3", "-2/5"), ("interpolating:family=mixed,l=2,arity=3", "3"),
                         ("tension4", "1")):
            space = {}
            exec(self.twoscale("table", name, "--evaluator", "--format", "python", "--prefix", "e"), space)  # noqa: S102
            table = self.twoscale_json("table", name, "--v0", v0, "--levels", "6", "--digits", "40")
            v = space["e_start"](float(Fraction(v0)))
            for level in table["levels"]:
                mask = space["e_mask"](*v)
                self.assertEqual((level["lowest"], len(level["coefficients"])), (space["e_lowest"], space["e_size"]))
                for got, text in zip(mask, level["coefficients"]):
                    self.assertLess(abs(Fraction(got) - Fraction(text)), 64 * U)
                v = space["e_next"](*v)


class Options(FilesTest):
    def test_values_are_substituted(self):
        space = {}
        text = self.twoscale("table", "four-point", "--at", "w=1/20", "--evaluator", "--format", "python")
        exec(text, space)  # noqa: S102
        self.assertEqual(space["twoscale_four_point_at_w_1_20_mask"]()[2:4], [0.55, 1])
        exec(self.twoscale("table", "tension4", "--v0=-2/5", "--evaluator", "--format", "python"), space)  # noqa: S102
        self.assertEqual(space["twoscale_tension4_start"](), [0.5477225575051661])
        self.refused("table", "four-point", "--at", "w=sqrt(2)/40", "--evaluator", "--format", "c", naming="w")

    def test_values_of_local_parameters_choose_the_piece(self):
        for values in ("1/3", "1", "0", "1/2"):
            space = {}
            exec(self.twoscale("table", "nuli4", "--at", f"lambda={values}", "--evaluator", "--format", "python", "--prefix",  # noqa: S102
                               "e"), space)
            exec(self.twoscale("table", "nuli4", "--evaluator", "--format", "python", "--prefix", "f"), space)  # noqa: S102
            one, other = space["e_mask"](2.0, 1.0, 0.5), space["f_mask"](2.0, 1.0, 0.5, float(Fraction(values)))
            for a, b in zip(one, other):
                self.assertAlmostEqual(a, b, 15)
        exec(self.twoscale("table", "lagrange4", "--at", "d=[1,1,1]", "--evaluator", "--format", "python", "--prefix", "e"), space)  # noqa: S102
        self.assertEqual(space["e_mask"](), [-1 / 16, 9 / 16, 9 / 16, -1 / 16])
        self.refused("table", "nuli4", "--at", "d=[1,1]", "--evaluator", "--format", "c", naming="[1,1]")
        self.refused("table", "nuli4", "--at", "lambda=2", "--evaluator", "--format", "c", naming="lambda")
        self.refused("table", "nuli4", "--at", "lambda=q", "--evaluator", "--format", "c", naming="q")
        self.refused("table", "hermite-circle", "--at", "s=[1/3,1/3],w=0", "--evaluator", "--format", "c", naming="w")

    def test_a_frequency_that_is_a_number_is_known_to_start(self):
        space = {}
        exec(self.twoscale("table", "interpolating:space=1,x,cos(pi*x/3),sin(pi*x/3)", "--evaluator", "--format", "python",  # noqa: S102
                           "--prefix", "e"), space)
        self.assertEqual(space["e_start"](), [0.75 ** 0.5])

    def test_every_language_says_what_it_is(self):
        for language in ("c", "cpp", "python", "julia", "glsl", "typescript", "javascript"):
            arguments = ("table", "tension4", "--evaluator", "--format", language)
            text = self.twoscale(*arguments)
            self.assertEqual(text, self.twoscale(*arguments))
            words = re.sub(r"\n(//|#)\s*", " ", text)
            for fact in ("Generated by twoscale", "0BSD, free for any use", "Scheme: tension4", "arity 2", "support [-3, 3]",
                         "p = 0", "every coset sums to 1", "v = cosh(t/2^(k+1))", "4 multiplications", "relative error"):
                self.assertIn(fact, words, language)

    def test_refusals(self):
        self.refused("table", "tension4", "--evaluator", "--format", "csv", naming="csv")
        self.refused("table", "tension4", "--evaluator", "--format", "c", "--prefix", "1x", naming="1x")
        self.refused("table", "tension4", "--evaluator", "--format", "c", "--levels", "3", naming="--levels")
        self.refused("table", "tension4", "--evaluator", "--format", "c", "--at", "q=3", naming="q")
        self.refused("table", "tension4", "--v0", "2", naming="--levels")
        file = self.path("moving.toml", '[scheme]\nname = "moving"\n[parameters.d]\nscope = "local"\noffsets = [0]\n'
                         '[[phase]]\nresidue = 0\nstencil = {"0" = "d_0", "1" = "1 - d_0"}\n'
                         '[[phase]]\nresidue = 1\nstencil = {"0" = "1/2", "1" = "1/2"}\n')
        self.refused("table", file, "--evaluator", "--format", "c", naming="moving")

    def test_names_are_identifiers_of_every_language(self):
        file = self.path("words.toml", '[scheme]\nname = "words"\nshift = 0\nsymbol = "(1 + z)*(lambda + (1 - lambda - t1)*z + t1*z^2)"\n'
                         '[parameters.lambda]\nscope = "constant"\n[parameters.t1]\nscope = "constant"\n')
        space = {}
        exec(self.twoscale("table", file, "--evaluator", "--format", "python", "--prefix", "e"), space)  # noqa: S102
        self.assertEqual(space["e_mask"](0.25, 0.5), [0.25, 0.5, 0.75, 0.5])
        file = self.path("p.toml", '[scheme]\nname = "words"\nsymbol = "(1 + z)*(p + (1 - 2*p)*z + p*z^2)"\n'
                         '[parameters.p]\nscope = "constant"\n')
        header = self.path("e.hpp", self.twoscale("table", file, "--evaluator", "--format", "cpp", "--prefix", "e"))
        subprocess.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-fsyntax-only", "-x", "c++", "-include",
                        header, "/dev/null"], check=True)


if __name__ == "__main__":
    unittest.main()
