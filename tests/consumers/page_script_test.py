# SPDX-License-Identifier: GPL-3.0-or-later
"""The script of the pages, run by node, computes what `refine` computes."""

import csv
import io
import json
import re
import shutil
import subprocess
import unittest
from fractions import Fraction

from support import FilesTest

# Loads the scripts of a page without a browser and refines with them. Input: {scripts, cases: [{levels, constants,
# refinements, ends, points, wrong}]}; `points` else than those of the page; `wrong` adds to one coefficient of the mask.
HARNESS = """
const vm = require("vm");
const input = JSON.parse(require("fs").readFileSync(0, "utf8"));
const curves = [], waiting = [];
const context = vm.createContext({
  document: {addEventListener: (_, f) => waiting.push(f), getElementById: (id) => id, querySelectorAll: () => []},
  keep: (root, scheme, config) => curves.push({scheme, config}),
});
for (const script of input.scripts) vm.runInContext(script, context);
vm.runInContext("interactiveCurve = keep", context);
waiting.forEach((f) => f());
const {scheme, config} = curves[0];
const refine = vm.runInContext("refine", context);
console.log(JSON.stringify({config, results: input.cases.map((c) => {
  const used = {...scheme, mask: (...values) => scheme.mask(...values).map((x, i) =>
    c.wrong && c.wrong.index === i ? x + c.wrong.by : x)};
  const settings = {levels: c.levels.map((x, i) => (x - config.levels[i].offset) / config.levels[i].scale),
    vertices: config.vertices, constants: c.constants, ends: c.ends || "closed", beyond: config.beyond,
    locals: config.locals.map((p) => ({...p, values: c.edges && p.rest !== undefined ? c.edges : undefined}))};
  const v = scheme.start(...settings.levels);
  return {points: refine(used, settings, c.points || config.points, c.refinements),
    weight: config.locals.length > 0 || config.vertices ? 4 : scheme.mask(...v, ...settings.constants).reduce((s, x) => s + Math.abs(x), 0),
    size: scheme.size};
})}));
"""

# Name, values for the evaluator (levels, constants), the same for `refine`.
CASES = (
    ("tension4", [-0.95], [], "v0=-0.95"), ("tension4", [1], [], "v0=1"), ("tension4", [1000], [], "v0=1000"),
    ("interpolating:family=harmonic,l=3", [0.3], [], "v0=0.3"), ("dd:l=3", [], [], ""), ("bspline:n=2", [], [], ""),
    ("interpolating:family=mixed,l=2,arity=3", [-0.5], [], "v0=-0.5"),
    ('interpolating:space="1,x,exp(s*x),exp(-s*x),cos(t*x),sin(t*x)"', [2, 0.25], [], "v0_s=2,v0_t=0.25"),
    ('quasi-spline:space="1, x, exp(t*x), exp(-t*x)",tension=a', [5], [0.375], "v0=5,a=0.375"),
    ("corner-cutting", [], [0.3125], "w=0.3125"),
)

# For open polygons: enough for points beyond the ends of a 6-point rule.
MORE_POINTS = [[0, 0], [1, 0.5], [2, 0.2], [3.2, 1.4], [2.4, 2.8], [1.6, 1.7], [0.6, 3], [-0.6, 1.6], [-1, 0.25],
               [-2, 1], [-2.5, 2.25], [-1.5, 3]]


@unittest.skipUnless(shutil.which("node"), "node is not there")
class PageScript(FilesTest):
    def scripts(self, *report):
        self.twoscale("report", *report, "-o", self.path("page"), "--quiet")
        with open(self.path("page/index.html"), encoding="utf-8") as file:
            return re.findall(r"<script>(.*?)</script>", file.read(), re.DOTALL)

    def node(self, scripts, cases):
        done = subprocess.run(["node", "-e", HARNESS], input=json.dumps({"scripts": scripts, "cases": cases}), text=True,
                              capture_output=True, check=False, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def refined(self, scheme, points, refinements, *options, columns=""):
        """The points as `refine` finds them; `columns`: what follows x,y of each line."""
        lines = ["x,y" + (columns and "," + columns[0])]
        for j, p in enumerate(points):
            lines.append(",".join(repr(x) for x in p) + (columns and "," + columns[1][j]))
        self.path("points.csv", "\n".join(lines) + "\n")
        text = self.twoscale("refine", scheme, "--levels", refinements, "--format", "csv", *options,
                             self.path("points.csv"))
        return [[Fraction(row["x"]), Fraction(row["y"])] for row in csv.DictReader(io.StringIO(text))]

    def largest_excess(self, ours, theirs, refinements, both=False):
        """The largest distance over what rounding can do: every step adds size + 64 roundings of numbers of the size of
        the points, and multiplies what is there by the sum of the absolute weights (64: those of a coefficient). `both`: theirs are rounded as well."""
        self.assertEqual(len(ours["points"]), len(theirs))
        size = max(abs(x) for p in theirs for x in p)
        weight = max(1.0, ours["weight"])
        bound = (2 if both else 1) * refinements * (ours["size"] + 64) * 2.0**-53 * float(size) * weight**refinements
        return max(float(abs(Fraction(x) - y)) for p, q in zip(ours["points"], theirs) for x, y in zip(p, q)) / bound

    def test_agrees_with_refine(self):
        for scheme, levels, constants, at in CASES:
            options = ["--at", at] if at else []
            with self.subTest(scheme=scheme, at=at):
                scripts = self.scripts(scheme, *options)
                case = {"levels": levels, "constants": constants, "refinements": 4}
                wrong = [{**case, "wrong": {"index": i, "by": 1e-9}} for i in range(2)]
                found = self.node(scripts, [case, *wrong])
                theirs = self.refined(scheme, found["config"]["points"], 4, "--digits", "25", *options)
                self.assertLess(self.largest_excess(found["results"][0], theirs, 4), 1)
                for result in found["results"][1:]:
                    self.assertGreater(self.largest_excess(result, theirs, 4), 1, "a wrong coefficient is not seen")

    def test_open_polygons(self):
        shifted = 'mask:coefficients="1/4,1,7/4,2,7/4,1,1/4",arity=4,lowest=-1'  # p = 2/3
        for scheme, levels, constants, at in (*CASES, ("bspline:n=3,arity=3", [], [], ""), (shifted, [], [], "")):
            options = ["--at", at] if at else []
            scripts = self.scripts(scheme, *options)
            for ends in ("linear", "given"):
                for refinements in (0, 1, 3):
                    with self.subTest(scheme=scheme, at=at, ends=ends, refinements=refinements):
                        case = {"levels": levels, "constants": constants, "refinements": refinements, "ends": ends,
                                "points": MORE_POINTS}
                        found = self.node(scripts, [case, {**case, "wrong": {"index": 0, "by": 1e-9}}])
                        theirs = self.refined(scheme, MORE_POINTS, refinements, "--digits", "25", "--open", ends, *options)
                        # A mirrored point has two roundings, and its weights 2 and -1 have the sum 3.
                        for result in found["results"]:
                            result["weight"] *= 3 if ends == "linear" else 1
                        if refinements == 0:
                            self.assertEqual(found["results"][0]["points"], [list(map(float, p)) for p in theirs])
                            continue
                        self.assertLess(self.largest_excess(found["results"][0], theirs, refinements), 1)
                        self.assertGreater(self.largest_excess(found["results"][1], theirs, refinements), 1,
                                           "a wrong coefficient is not seen")

    def test_too_few_points(self):
        """None come out where `refine` refuses, and some with one point more."""
        for scheme, ends, least in (("dd:l=3", "given", 10), ("dd:l=3", "linear", 3), ("dd:l=4", "linear", 4),
                                    ("bspline:n=2", "given", 4), ("nuli4", "given", 6), ("nuli6", "given", 10)):
            with self.subTest(scheme=scheme, ends=ends):
                cases = [{"levels": [], "constants": [], "refinements": 2, "ends": ends, "points": MORE_POINTS[:n]}
                         for n in (least - 1, least)]
                few, enough = self.node(self.scripts(scheme), cases)["results"]
                self.assertEqual(few["points"], [])
                self.assertNotEqual(enough["points"], [])
                self.refined(scheme, MORE_POINTS[:least], 2, "--open", ends)
                few_points = "x,y\n" + "".join(f"{x},{y}\n" for x, y in MORE_POINTS[:least - 1])
                self.refused("refine", scheme, "--levels", 2, "--open", ends, "--format", "csv",
                             self.path("few.csv", few_points), naming=f"at least {least} points")

    def test_knots_and_edge_parameters(self):
        edges = [0.5, 0.25, 0.5, 0.875, 0, 1, 0.625, 0.125, 0.75, 1, 0, 0.375]
        for scheme in ("nuli4", "nuli6", "lagrange4", "nuli:n=3"):
            scripts = self.scripts(scheme)
            columns = ("lambda", list(map(repr, edges))) if scheme in ("nuli4", "nuli6") else ""
            for ends in ("closed", "linear", "given"):
                with self.subTest(scheme=scheme, ends=ends):
                    case = {"levels": [], "constants": [], "refinements": 3, "edges": edges, "ends": ends,
                            "points": MORE_POINTS}
                    found = self.node(scripts, [case, {**case, "wrong": {"index": 1, "by": 1e-9}}])
                    options = [] if ends == "closed" else ["--open", ends]
                    theirs = self.refined(scheme, MORE_POINTS, 3, *options, columns=columns)
                    self.assertLess(self.largest_excess(found["results"][0], theirs, 3, both=True), 1)
                    self.assertGreater(self.largest_excess(found["results"][1], theirs, 3, both=True), 1,
                                       "a wrong coefficient is not seen")

    def test_vertices_with_derivatives(self):
        scripts = self.scripts("hermite2010")
        for w, ends in (("1", "closed"), ("1.25", "closed"), ("0.5", "closed"), ("1", "given"), ("1.25", "given")):
            case = {"levels": [], "constants": [float(w)], "refinements": 4, "ends": ends}
            found = self.node(scripts, [case, {**case, "wrong": {"index": 2, "by": 1e-9}}])
            config = found["config"]
            lines = ["fx,fy,px,py,rx,ry,sigma"] + [
                ",".join(map(repr, [*f, *v["p"], *v["r"], v["sigma"]])) for f, v in zip(config["points"], config["vertices"])]
            text = self.twoscale("refine", "hermite-circle", "--at", f"w={w}", "--levels", 4, "--format", "csv",
                                 *([] if ends == "closed" else ["--open", ends]), self.path("v.csv", "\n".join(lines) + "\n"))
            theirs = [[Fraction(row["fx"]), Fraction(row["fy"])] for row in csv.DictReader(io.StringIO(text))]
            self.assertLess(self.largest_excess(found["results"][0], theirs, 4, both=True), 1)
            self.assertGreater(self.largest_excess(found["results"][1], theirs, 4, both=True), 1)

    def test_singular_values_are_not_finite(self):
        scripts = self.scripts("interpolating:family=harmonic,l=3")
        found = self.node(scripts, [{"levels": [-0.5], "constants": [], "refinements": 1}])
        self.assertIn([None, None], found["results"][0]["points"])


if __name__ == "__main__":
    unittest.main()
