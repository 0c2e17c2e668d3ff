# SPDX-License-Identifier: GPL-3.0-or-later
"""Mask tables in the programs they are for: Octave, node and tsc, glslangValidator, PyWavelets, OpenSubdiv."""

import json
import os
import shutil
import subprocess
import unittest

from support import FilesTest

SCHEMES = (("tension4", "--v0=-2/5"), ("bspline:n=2",), ("interpolating:family=mixed,l=2,arity=3", "--v0", "2"))
POLYGON = [(0.0, 0.0), (1.0, 0.1), (2.0, 1.0), (1.0, 3.0), (0.0, 2.0)]


def needs(*programs):
    missing = [p for p in programs if shutil.which(p) is None]
    return unittest.skipIf(missing, f"not installed: {', '.join(missing)}")


class Tables(FilesTest):
    def table(self, scheme, *arguments, levels=3):
        return self.twoscale("table", *scheme, "--levels", str(levels), *arguments)

    def refined(self, scheme, levels):
        file = self.path("in.csv", "".join(f"{x!r},{y!r}\n" for x, y in POLYGON))
        text = self.twoscale("refine", *scheme, "--levels", str(levels), file)
        return [list(map(float, line.split(","))) for line in text.splitlines()[1 if text[0] == "x" else 0:]]

    def close(self, got, want, tolerance=1e-14):
        self.assertEqual(len(got), len(want))
        self.assertLess(max(abs(x - y) for a, b in zip(got, want) for x, y in zip(a, b)), tolerance)

    @needs("octave-cli")
    def test_octave_reads_the_script_and_refines(self):
        for scheme in SCHEMES:
            file = self.path("mask_table.m", self.table(scheme, "--format", "matlab", "--prefix", "t", "--digits", "25"))
            points = "; ".join(f"{x!r} {y!r}" for x, y in POLYGON)
            # As getS takes it: a column and the dilation; upsampled, convolved, wrapped.
            code = (f"source('{file}'); p = [{points}]; for k = 0:2, a = t.mask(:, k + 1); n = rows(p) * t.arity; q = zeros(n, 2);"
                    "for j = 0:rows(p) - 1, for s = 1:numel(a), i = mod(t.arity * j + t.lowest + s - 1, n) + 1;"
                    "q(i, :) += a(s) * p(j + 1, :); end, end, p = q; end, printf('%.17g %.17g\\n', p.');"
                    "assert(iscolumn(t.mask(:, end)) && size(t.text, 1) == t.highest - t.lowest + 1);"
                    "assert(cellfun(@str2double, t.text(:)) == t.mask(:));")
            done = subprocess.run(["octave-cli", "--quiet", "--no-init-file", "--eval", code], capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.close([list(map(float, line.split())) for line in done.stdout.splitlines()], self.refined(scheme, 3))

    @needs("node", "tsc")
    def test_typescript_refines(self):
        for number, scheme in enumerate(SCHEMES):
            name = f"table{number}"
            self.path(f"{name}.ts", self.table(scheme, "--format", "typescript"))
            subprocess.run(["tsc", "--strict", "--noUnusedLocals", "--target", "es2020", "--module", "commonjs",
                            self.path(f"{name}.ts")], check=True)
            script = self.path("main.js", f"const t = require('./{name}.js');\nlet p = {json.dumps(POLYGON)};\n"
                               "for (let k = 0; k < 3; ++k) p = t.apply(k, p);\n"
                               "console.log(JSON.stringify([p, t.stencils(0), t.radius]));\n")
            points, rules, radius = json.loads(subprocess.run(["node", script], capture_output=True, text=True, check=True).stdout)
            self.close(points, self.refined(scheme, 3))
            self.assertEqual([len(r) for r in rules], [2 * radius + 1] * len(rules))
            if scheme[0] == "tension4":  # a kernel of 5 points with a zero
                self.assertEqual((rules[0], rules[1][0]), ([0, 0, 1, 0, 0], 0))

    @needs("glslangValidator")
    def test_glsl_compiles(self):
        for scheme in SCHEMES:
            text = self.table(scheme, "--format", "glsl", "--prefix", "t")
            for head in ("#version 130", "#version 450", "#version 300 es\nprecision highp float;"):
                for body, status in ((text, 0), (text.replace(" 1.0,", " vec2(1.0),", 1).replace(" 0.0,", " vec2(0.0),", 1), 2)):
                    file = self.path("shader.frag", f"{head}\n{body}\nuniform int k;\nout vec4 colour;\n"
                                     "void main() { colour = vec4(t_coefficient(k, t_lowest), t_p, 0.0, 1.0); }\n")
                    done = subprocess.run(["glslangValidator", file], capture_output=True, text=True, check=False)
                    if body == text or status == 0:
                        self.assertEqual(done.returncode, 0, done.stdout)
                    else:
                        self.assertNotEqual(done.returncode, 0)

    def test_pywavelets_reconstructs(self):
        try:
            import numpy
            import pywt
        except ImportError as error:
            self.skipTest(str(error))
        random = numpy.random.default_rng(5)
        for scheme in (("tension4", "--v0=-2/5"), ("bspline:n=2",), ("mixed:n=1", "--t", "1"), ("dd:l=3",)):
            space = {}
            exec(self.table(scheme, "--format", "pywavelets"), space)  # noqa: S102
            for k in range(5):
                wavelet = space["wavelet"](k)
                x = random.standard_normal(64)
                for mode in ("periodization", "symmetric", "zero"):
                    numpy.testing.assert_allclose(pywt.idwt(*pywt.dwt(x, wavelet, mode), wavelet, mode), x, atol=1e-12)
            broken = [list(f) for f in space["filter_bank"](0)]
            broken[2][len(broken[2]) // 2] += 1e-3
            wavelet = pywt.Wavelet("broken", filter_bank=broken)
            back = pywt.idwt(*pywt.dwt(x, wavelet, "periodization"), wavelet, "periodization")
            self.assertGreater(abs(back - x).max(), 1e-4)
        # Interpolating: the synthesis of low-pass samples alone is one step of subdivision.
        space = {}
        exec(self.table(("dd:l=2",), "--format", "pywavelets"), space)  # noqa: S102
        low = numpy.zeros(16)
        low[8] = 2 ** 0.5
        out = pywt.idwt(low, None, space["wavelet"](0), "periodization")
        numpy.testing.assert_allclose(sorted(out[abs(out) > 1e-9]), sorted([-1 / 16, -1 / 16, 9 / 16, 9 / 16, 1]), atol=1e-14)

    @unittest.skipUnless(os.path.exists("/usr/include/opensubdiv/far/stencilTable.h"), "not installed: libosd-dev")
    def test_opensubdiv_applies_the_stencils(self):
        for scheme in SCHEMES:
            self.path("stencil.h", self.table(scheme, "--format", "stencil", "--points", "5", "--prefix", "s"))
            main = self.path("main.cpp", """#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#include <cstdio>
#include <vector>
#include "stencil.h"
using namespace OpenSubdiv;
struct Point {
  double x, y;
  void Clear() { x = y = 0; }
  void AddWithWeight(const Point& p, double w) { x += w * p.x; y += w * p.y; }
};
template <class T> std::vector<int> list(const T& array) { return {std::begin(array), std::end(array)}; }
struct Table : Far::StencilTableReal<double> {
  Table()
      : StencilTableReal(S_POINTS, list(s_offsets), list(s_sizes), list(s_indices),
                         {std::begin(s_weights), std::end(s_weights)}, false, 0) {}
};
int main() {
  const Point in[] = {{0, 0}, {1, 0.1}, {2, 1}, {1, 3}, {0, 2}};
  const Table table;
  std::vector<Point> out(static_cast<std::size_t>(table.GetNumStencils()));
  table.UpdateValues(in, out.data());
  for (const Point& p : out) std::printf("%.17g %.17g\\n", p.x, p.y);
  std::vector<float> source, weights(std::begin(s_weights), std::end(s_weights)), target(2 * S_ROWS);
  for (const Point& p : in) source.insert(source.end(), {float(p.x), float(p.y)});
  const Osd::BufferDescriptor two(0, 2, 2);
  if (!Osd::CpuEvaluator::EvalStencils(source.data(), two, target.data(), two, s_sizes, s_offsets, s_indices, weights.data(), 0,
                                       S_ROWS)) return 1;
  for (std::size_t i = 0; i < target.size(); i += 2) std::printf("%.9g %.9g\\n", target[i], target[i + 1]);
}
""")
            subprocess.run(["g++", "-std=c++17", "-O1", main, "-o", self.path("run"), "-losdCPU"], check=True)
            text = subprocess.run([self.path("run")], capture_output=True, text=True, check=True).stdout
            points = [list(map(float, line.split())) for line in text.splitlines()]
            want = self.refined(scheme, 3)
            self.close(points[:len(want)], want)
            self.close(points[len(want):], want, 1e-5)


if __name__ == "__main__":
    unittest.main()
