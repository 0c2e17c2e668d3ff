# SPDX-License-Identifier: GPL-3.0-or-later
"""`table --evaluator` in JavaScript and TypeScript agrees with the exact masks as it does in C, long rules too; GLSL
compiles, and run as C++ with floats it keeps its bound."""

import re
import shutil
import subprocess
import unittest
from fractions import Fraction

from evaluators import Evaluators
from support import FilesTest

# Enough of GLSL for the evaluators: arrays and vec2; floats that are rounded after every operation.
SHIM = """#include <array>
#include <cmath>
#include <cstdio>
using std::sqrt;
struct vec2 { float x, y; vec2(float a, float b) : x(a), y(b) {} };
#define precise
"""


def needs(*programs):
    missing = [p for p in programs if shutil.which(p) is None]
    return unittest.skipIf(missing, f"not installed: {', '.join(missing)}")


class Languages(FilesTest):
    def setUp(self):
        super().setUp()
        self.all = Evaluators(self.directory.name, long=True)

    @needs("node")
    def test_javascript(self):
        result = self.all.javascript()
        self.assertEqual(self.all.failures(result, self.all.exact()), [])
        self.assertEqual(result, self.all.c())

    @needs("node", "tsc")
    def test_typescript(self):
        self.assertEqual(self.all.typescript(), self.all.python())

    def test_c_with_contraction(self):
        result = self.all.c(("gcc", "-std=gnu99", "-O2", "-march=native"))
        self.assertEqual(self.all.failures(result, self.all.exact()), [])

    def test_cpp_with_exact_and_long_numbers(self):
        name = "interpolating:family=harmonic,l=4"
        self.path("h.hpp", self.all.source(name, "cpp", "h"))
        main = self.path("main.cpp", """#include "h.hpp"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <iomanip>
#include <iostream>
using Exact = boost::multiprecision::cpp_rational;
using Long = boost::multiprecision::cpp_bin_float_100;
int main() {
  for (const Exact& x : h::mask<Exact>(Exact(3) / 4)) std::cout << x << " ";
  std::cout << std::setprecision(100) << "\\n";
  const Long v = h::start<Long>(Long(-2) / 5)[0];
  for (const Long& x : h::mask<Long>(v)) std::cout << x << " ";
}
""")
        subprocess.run(["g++", "-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror", "-Wshadow", main, "-o", self.path("program")],
                       check=True)
        exact, long = subprocess.run([self.path("program")], capture_output=True, text=True, check=True).stdout.splitlines()
        self.assertEqual([Fraction(x) for x in exact.split()], self.all.formula(name)((0.75,)))
        table = self.twoscale_json("table", name, "--v0=-2/5", "--levels", "1", "--digits", "110")
        for got, text in zip(long.split(), table["levels"][0]["coefficients"], strict=True):
            self.assertLess(abs(Fraction(got) - Fraction(text)), Fraction(1, 10 ** 95))

    @needs("tsc", "glslangValidator")
    def test_the_whole_catalogue_compiles(self):
        names = [name for entry in self.twoscale_json("list")["entries"] for name in entry["examples"]]

        def emitted(language):
            return "".join(self.all.source(name, language, f"c{i}") for i, name in enumerate(names))
        flags = ["-Wall", "-Wextra", "-Werror", "-pedantic", "-Wshadow", "-Wconversion", "-fsyntax-only"]
        uses = "".join(f"template <class T> auto u{i}() {{ return c{i}::p + double(c{i}::size); }}\n" for i in range(len(names)))
        for command in (["gcc", "-std=c99", *flags, self.path("all.c", emitted("c"))],
                        ["g++", "-std=c++20", *flags, self.path("all.cpp", emitted("cpp") + uses)],
                        ["tsc", "--strict", "--noEmit", "--target", "es2020", self.path("all.ts", emitted("typescript"))],
                        ["glslangValidator", self.path("all.vert", f"#version 300 es\n{emitted('glsl')}\nvoid main() {{}}\n")]):
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    @needs("glslangValidator")
    def test_glsl_compiles(self):
        for head in ("#version 130", "#version 450", "#version 300 es\nprecision highp float;",
                     "#version 320 es\nprecision highp float;"):
            body = "\n".join(self.all.sources("glsl").values())
            file = self.path("shader.frag", head + "\n" + body + "\nout vec4 colour;\nvoid main() { colour = vec4(e0_mask(0.5)[2]); }\n")
            done = subprocess.run(["glslangValidator", file], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            with open(file, encoding="utf-8") as text:
                broken = text.read().replace("* v", "* w", 1)
            file = self.path("broken.frag", broken)
            self.assertNotEqual(subprocess.run(["glslangValidator", file], capture_output=True, check=False).returncode, 0)

    def test_glsl_keeps_its_bound_in_floats(self):
        name, points = next(c for c in self.all.cases if "harmonic" in c[0])
        text = self.all.source(name, "glsl", "e")
        bound = int(re.search(r"at most (\d+)\*u", re.sub(r"\n//\s*", " ", text)).group(1))
        text = re.sub(r"\bfloat\[(\d+)\]\(", r"std::array<float, \1>({", text)
        text = re.sub(r"(\{\n(?:.|\n)*?)\n    \);", r"\1});", text)  # the list of the coefficients
        text = text.replace("(v_0) / 2.0))", "(v_0) / 2.0)})")
        text = re.sub(r"(sqrt\(\(1\.0 \+ \w+\) / 2\.0\))\)", r"\1})", text)
        text = re.sub(r"\bfloat\[(\d+)\]", r"std::array<float, \1>", text)
        text = re.sub(r"(?<![\w.])(\d+\.\d+)", r"\1F", text)
        values = [Fraction(round(v * 2 ** 20), 2 ** 20) for (v,) in points if v < 16]  # floats
        values = [v for v in values if v not in (0, Fraction(1, 2))]  # not singular
        calls = "".join(f"  for (float x : e_mask({float(v).hex()}F)) std::printf(\"%.9g \", x);\n  std::printf(\"\\n\");\n" for v in values)
        main = self.path("main.cpp", f"{SHIM}{text}\nint main() {{\n{calls}}}\n")
        subprocess.run(["g++", "-std=c++20", "-O1", "-ffp-contract=off", "-U__VERSION__", "-D__VERSION__=450", main, "-o", self.path("program")], check=True)
        lines = subprocess.run([self.path("program")], capture_output=True, text=True, check=True).stdout.splitlines()
        exact = self.all.formula(name)
        for v, line in zip(values, lines):
            for got, value in zip(map(float, line.split()), exact((v,))):
                self.assertLessEqual(abs(Fraction(got) - value), bound * abs(value) / 2 ** 24 * Fraction(101, 100), v)


if __name__ == "__main__":
    unittest.main()
