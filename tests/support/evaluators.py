# SPDX-License-Identifier: GPL-3.0-or-later
"""Emitted evaluators run in their languages, and the exact values to compare with."""

import json
import math
import os
import re
import subprocess
from fractions import Fraction

from support import run

U = Fraction(1, 2 ** 53)

# A relation that is no frequency: w^k = w^2 + 3w.
FADING = ('[scheme]\nname = "fading"\n[parameters.w]\nscope = "level"\nrelation = "w^2 + 3*w"\ndomain = "(-5/4, 1]"\n'
          'default = "1/2"\n[[phase]]\nresidue = 0\nstencil = {"0" = 1}\n'
          '[[phase]]\nresidue = 1\nstencil = {"-1" = "-1/16 - w", "0" = "9/16 + w", "1" = "9/16 + w", "2" = "-1/16 - w"}\n')


def near(*singular):
    """Both sides of values, from far to 2^-40 of them."""
    return [s * (1 + sign * 2.0 ** -e) for s in singular for e in (3, 12, 24, 33, 40) for sign in (1, -1)]


V = [1.0, math.nextafter(1, 0), math.nextafter(1, 2), 1 - 2.0 ** -20, 1 + 1e-8, 0.9, 0.3, 1e-3, 1.7, 40.0, 1e5]
COS = [math.cos(math.pi * a / b) for a, b in ((1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (2, 5), (1, 7), (3, 7), (1, 10))
       if b != 2]
PAIRS = [(0.6, 0.8), (0.5, 1.5), (1.0, 1.0), (1e-6, 2.0), (math.sqrt(0.5), 1 - 2.0 ** -30), (0.25, 1 / 3)]
D = [(1.0, 1.0, 1.0), (0.1, 2.0, 7.5), (1e-6, 1.0, 3.0), (1 / 3, 1e4, 0.7)]
LAMBDA = [0.0, 1e-12, 0.3, 0.5, math.nextafter(0.5, 0), 2 / 3, 1 / 3, 1 - 2.0 ** -30, 1.0]

# Scheme (FADING: a file of that text), and the arguments of mask.
CASES = [
    ("tension4", [(v,) for v in V]),
    ("interpolating:family=harmonic,l=4", [(v,) for v in V + near(*COS)]),
    ("interpolating:family=mixed,l=8", [(v,) for v in V]),
    ("interpolating:family=mixed,l=2,arity=3", [(v,) for v in V + near(0.5)]),
    ("exponential-bspline:space=1,x,cos(s*x),sin(s*x),exp(t*x),exp(-t*x)", PAIRS),
    ("interpolating:space=1,x,cos(s*x),sin(s*x),exp(t*x),exp(-t*x)", PAIRS),
    ("quasi-spline:space=1,x,x^2,exp(t*x),exp(-t*x),omega=omega", [(v, w) for v in (0.5, 1.0, 1.25) for w in (-0.1, 0.0, 2.0)]),
    ("four-point", [(1 / 16,), (1e-9,)]),
    ("dd:l=4", [()]),
    ("bspline:n=3,arity=3", [()]),
    ("lagrange4", D),
    ("nuli4", [(*d, x) for d in D for x in LAMBDA]),
    ("nuli6", [(d[2], *d, d[1], a, b, c) for d in D[:2] for a, b, c in
               ((0.5, 0.5, 0.5), (1.0, 0.0, 0.25), (1.0, 1e-9, 0.3), (0.3, 1.0, 0.0), (0.0, 0.7, 1.0), (1.0, 0.25, 1.0))]),
    ("hermite-circle", [(0.5, -0.2, 1 / 7), (1.0, 0.0, 0.25), (1.5, -2.0 ** -20, 2.0 ** -21)]),
    ("hermite-circle:variant=c2", [(0.5, -0.2, 1 / 7), (1.25, 0.1, 0.100001)]),
]
# Scheme, arguments of start and next, the relation as a function of the finer value.
LEVELS = [
    ("tension4", [-1 + 2.0 ** -30, -0.5, 0.0, 0.7, 1.0, 1 - 2.0 ** -53, 3.0, 1e10], lambda x: 2 * x * x - 1),
    ("interpolating:family=mixed,l=2,arity=3", [-1 + 2.0 ** -30, -0.9, 0.0, 1.0, 1 + 2.0 ** -52, 1 - 2.0 ** -53, 3.0, 1e10],
     lambda x: 4 * x ** 3 - 3 * x),
    ("bspline-arity-5", [-1 + 2.0 ** -20, -0.5, 0.9, 7.0], lambda x: 16 * x ** 5 - 20 * x ** 3 + 5 * x),
    # w = v - 1
    ("fading", [-0.125, 0.5, 1.0, 1 + 2.0 ** -40, 1.9], lambda x: x * x + x - 1),
]
NAMES = {"bspline-arity-5": "exponential-bspline:space=1,exp(t*x),exp(-t*x),arity=5"}


LONG = ("nuli6", "hermite-circle")


class Evaluators:
    """The evaluators of CASES (those of LONG on demand) and LEVELS."""

    def __init__(self, directory, long=False):
        self.directory = directory
        self.cases = [case for case in CASES if long or case[0] not in LONG]
        self.known = {}

    def path(self, name, text=None):
        path = os.path.join(self.directory, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path

    def scheme(self, name):
        if name == "fading":
            return self.path("fading.toml", FADING)
        return NAMES.get(name, name)

    def source(self, name, language, prefix):
        key = name, language, prefix
        if key not in self.known:
            done = run("twoscale", "table", self.scheme(name), "--evaluator", "--format", language, "--prefix", prefix)
            if done.returncode != 0:
                raise RuntimeError(done.stderr)
            self.known[key] = done.stdout
        return self.known[key]

    def bound(self, name):
        """What the header states: the relative error in units of u."""
        source = next((text for key, text in self.known.items() if key[0] == name and key[1] != "glsl"), None)
        text = re.sub(r"\n(//|#)\s*", " ", source or self.source(name, "c", "e"))
        if "every coefficient is exact" in text:
            return 0
        return int(re.search(r"at most (\d+)\*u, u = 2\^-53", text).group(1))

    def calls(self):
        """(prefix, name, function, arguments, count of results)."""
        for i, (name, points) in enumerate(self.cases):
            for point in points:
                yield f"e{i}", name, "mask", point
        for i, (name, values, _) in enumerate(LEVELS):
            for value in values:
                for function in ("start", "next"):
                    yield f"l{i}", name, function, (value,)

    def sources(self, language):
        seen = {}
        for prefix, name, _, _ in self.calls():
            if prefix not in seen:
                seen[prefix] = self.source(name, language, prefix)
        return seen

    # ---- Results, one list a call

    def python(self):
        spaces = {}
        for prefix, text in self.sources("python").items():
            spaces[prefix] = {}
            exec(text, spaces[prefix])  # noqa: S102
        return [list(spaces[p][f"{p}_{f}"](*a)) for p, _, f, a in self.calls()]

    def _numbers(self, command):
        text = subprocess.run(command, text=True, capture_output=True, check=True).stdout
        return [[float(x) for x in line.split()] for line in text.splitlines()]

    def c(self, compiler=("gcc", "-std=c99", "-O1")):
        body = ""
        for p, _, f, a in self.calls():
            size = f"{p}_size" if f == "mask" else "1"
            arguments = "".join(f"{x.hex()}, " for x in a)
            body += f"    {p}_{f}({arguments}out); print(out, {size});\n"
        text = "".join(self.sources("c").values())
        self.path("evaluators.c", text)
        main = self.path("main.c", '#include "evaluators.c"\n#include "evaluators.c"\n#include <stdio.h>\n'
                         "static void print(const double *x, int n)\n{\n    int i;\n"
                         '    for (i = 0; i < n; ++i) printf("%.17g ", x[i]);\n    printf("\\n");\n}\n'
                         f"int main(void)\n{{\n    double out[64];\n{body}    return 0;\n}}\n")
        subprocess.run([*compiler, "-Wall", "-Wextra", "-Werror", "-pedantic", main, "-lm", "-o", self.path("c-program")],
                       check=True)
        return self._numbers([self.path("c-program")])

    def cpp(self):
        body = ""
        for p, _, f, a in self.calls():
            body += f"  print({p}::{f}<double>({', '.join(x.hex() for x in a)}));\n"
        self.path("evaluators.hpp", "".join(self.sources("cpp").values()))
        main = self.path("main.cpp", '#include "evaluators.hpp"\n#include "evaluators.hpp"\n#include <cstdio>\n'
                         "template <class List> static void print(const List& list)\n{\n"
                         '  for (double x : list) std::printf("%.17g ", x);\n  std::printf("\\n");\n}\n'
                         # At compile time the sums and products are the same; a root may differ in the last place.
                         "constexpr auto early = e1::mask<double>(0.75);\n"
                         "static_assert(l0::start<double>(1.0)[0] == 1 && l1::next<double>(1.0)[0] == 1);\n"
                         "static_assert(e1::mask<long double>(0.75L)[7] == 1 && e1::mask<float>(0.75F)[7] == 1);\n"
                         "static_assert(l0::start<double>(0.125)[0] == 0.75);\n"
                         f"int main()\n{{\n  if (early != e1::mask<double>(0.75)) return 1;\n{body}}}\n")
        subprocess.run(["g++", "-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wshadow", "-Wconversion", main,
                        "-o", self.path("cpp-program")], check=True)
        return self._numbers([self.path("cpp-program")])

    def _node(self, before, name):
        body = "".join(f"print({name(p, f)}({', '.join(map(repr, a))}));\n" for p, _, f, a in self.calls())
        script = self.path("main.js", f"{before}\nconst print = (list) => console.log(list.join(' '));\n{body}")
        return self._numbers(["node", script])

    def javascript(self):
        return self._node("".join(self.sources("javascript").values()), lambda p, f: f"{p}_{f}")

    def typescript(self):
        before = ""
        for prefix, text in self.sources("typescript").items():
            self.path(f"{prefix}.ts", text)
            before += f"const {prefix} = require('./{prefix}.js');\n"
        subprocess.run(["tsc", "--strict", "--noUnusedLocals", "--target", "es2020", "--module", "commonjs",
                        *(self.path(f"{prefix}.ts") for prefix in self.sources("typescript"))], check=True)
        return self._node(before, lambda p, f: f"{p}.{p}_{f}")

    # ---- Exact values

    def exact(self):
        values, formulas = [], {}
        for _, name, function, point in self.calls():
            if function != "mask":
                values.append(None)
                continue
            if name not in formulas:
                formulas[name] = self.formula(name)
            values.append(formulas[name](point))
        return values

    def formula(self, name):
        """Exact values of mask at a point, as a function."""
        document = json.loads(run("twoscale", "show", self.scheme(name), "--format", "json").stdout)
        if "symbol" not in document:
            return lambda point: self._stencil(name, document, point)
        texts = document["symbol"]["coefficients"]
        names = [*document["level_variables"], *document["parameters"]]
        code = [compile(re.sub(r"(?<!\*\*)\b(\d+)\b", r"F(\1)", t.replace("^", "**")), name, "eval") for t in texts]
        return lambda point: [eval(c, {"F": Fraction}, dict(zip(names, map(Fraction, point)))) for c in code]

    def _stencil(self, name, document, point):
        """Of a scheme with local parameters: what the command `stencil` prints."""
        left = [str(Fraction(x)) for x in point]
        local = document["local_parameters"]
        at = [f"{p}={left.pop(0)}" for p in document.get("parameters", []) if p not in local]
        for p, details in local.items():
            if not left:  # the mask has no argument for it: it is at its value at rest
                break
            offsets = details if isinstance(details, list) else details["offsets"]
            at.append(f"{p}=[{','.join(left.pop(0) for _ in offsets)}]")
        done = run("twoscale", "stencil", self.scheme(name), "--at", ",".join(at), "--format", "json")
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        document = json.loads(done.stdout)
        rows = document["matrix"] if "matrix" in document else [document["coefficients"]]
        return [Fraction(x) for row in rows for x in row]

    # ---- Comparison

    def failures(self, results, exact):
        """What is beyond the stated bounds."""
        bounds = {}
        relations = {name: relation for name, _, relation in LEVELS}
        found = []
        for (_, name, function, point), result, values in zip(self.calls(), results, exact):
            if function == "mask":
                if name not in bounds:
                    bounds[name] = self.bound(name)
                if len(result) != len(values):
                    found.append((name, point, "size"))
                    continue
                # To first order in u; the rest is far below one per cent.
                limit = bounds[name] * U * Fraction(101, 100)
                for i, (got, value) in enumerate(zip(result, values)):
                    if abs(Fraction(got) - value) > limit * abs(value):
                        error = float(abs(Fraction(got) - value) / U / abs(value)) if value else math.inf
                        found.append((name, point, i, error, bounds[name]))
            else:
                x = Fraction(result[0])
                relation, v = relations[name], Fraction(point[0])
                if not relation(x * (1 - 2 * U)) <= v <= relation(x * (1 + 2 * U)):
                    found.append((name, function, point, result))
        return found
