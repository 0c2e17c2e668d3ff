#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user would run instead, timed beside our own benchmarks: SymPy, PARI/GP, mpmath, SciPy, NumPy.

    peers.py TWOSCALE RESULTS OUT [--full] [--only PART,...]

RESULTS holds the JSON files of the C++ benchmarks (from scripts/bench); the peers get the same spaces, the folded
system that `twoscale derive --format json` prints, the masks of `twoscale table`, and the matrices of an exponent (from
regularity.json). Prints one table, another one of exponents, and writes OUT.
All times are CPU seconds of one thread, medians, unless they say "wall clock"; "SymPy linsolve" is a first call.
Reading the input, building matrices and importing modules are not counted.
"""

import argparse
import json
import math
import multiprocessing
import os
import platform
import re
import resource
import statistics
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy
import scipy.signal
import sympy
from sympy.polys.densearith import dup_add, dup_mul, dup_mul_ground
from sympy.polys.domains import ZZ

import regularity_peer

FAMILIES = ("mixed", "harmonic", "resonant")
OTHERS = ("lacunary", "multiplicities", "two-frequencies")


# Measuring.

def measure(job, at_least=0.2, most=9):
    """Median CPU seconds of job(); slow jobs run once."""
    times = []
    while not times or (sum(times) < at_least and len(times) < most):
        start = time.process_time()
        job()
        times.append(time.process_time() - start)
    return statistics.median(times)


def within(seconds, function, *arguments):
    """function(*arguments) in a process of its own; None after so many seconds."""
    with multiprocessing.get_context("fork").Pool(1) as pool:
        try:
            return pool.apply_async(function, arguments).get(seconds)
        except multiprocessing.TimeoutError:
            return None


# Linear algebra: the folded system for omega.

def sympy_expression(text):
    return sympy.sympify(text.replace("^", "**"), rational=True)


def sympy_linsolve(system, again=True):
    """CPU seconds of the first call, and the median of further ones (again), which find SymPy's caches filled."""
    matrix = sympy.Matrix([[sympy_expression(x) for x in row] for row in system["matrix"]])
    rhs = sympy.Matrix([sympy_expression(x) for x in system["rhs"]])
    unknowns = sympy.symbols(f"w:{len(system['rhs'])}")

    def solve():
        return sympy.linsolve((matrix, rhs), *unknowns)

    start = time.process_time()
    solve()
    first = time.process_time() - start
    return first, measure(solve, most=5) if again else None


def unfolded(sigma, l):
    """The conditions zeta_{2j} = delta_j, |j| < l, for the 2l-1 coefficients of omega, nothing folded."""
    lowest, coefficients = sigma["lowest"], sigma["coefficients"]

    def at(i):
        return coefficients[i - lowest] if 0 <= i - lowest < len(coefficients) else "0"

    indices = range(1 - l, l)
    return {"matrix": [[at(2 * j - i) for i in indices] for j in indices],
            "rhs": ["1" if j == 0 else "0" for j in indices]}


def pari_matsolve(system, limit):
    """CPU seconds, measured inside gp over as many repetitions as make 0.2 s."""
    matrix = "[" + "; ".join(", ".join(row) for row in system["matrix"]) + "]"
    code = (f"A={matrix}; b=[{', '.join(system['rhs'])}]~;\n"
            "n=1; while(1, gettime(); for(i=1,n,matsolve(A,b)); t=gettime(); if(t>=200,break); n*=4); print(1.*t/n)\n")
    try:
        done = subprocess.run(["gp", "-q", "-f", "--default", "parisizemax=2000000000"], input=code, text=True,
                              capture_output=True, timeout=limit, check=True)
    except subprocess.TimeoutExpired:
        return None
    return float(done.stdout) / 1000


# The zero and value conditions of zeta.

def sympy_cancel(zeta, nodes):
    """CPU seconds of the same by expressions: the derivatives of 1 + P at the -w_i, each put to 0 by cancel()."""
    v, w = sympy.symbols("v w")
    half = [sympy_expression(c) for c in zeta[len(zeta) // 2:]]
    p = sum(((2 if m else 1) * a * sympy.chebyshevt(m, w) for m, a in enumerate(half)), sympy.Integer(0))

    def verify():
        for node in set(nodes):
            derivative = p
            for _ in range(nodes.count(node)):
                assert sympy.cancel(derivative.subs(w, -node)) == 0
                derivative = derivative.diff(w)

    return measure(verify, most=1)


def sympy_conditions(zeta, nodes):
    """CPU seconds of the faster of two ways to verify that 1 + P(w), w = (z + 1/z)/2, vanishes at the -w_i to their orders.

    zeta = 1 + P; P is odd, so the values at the w_i follow. Repeated synthetic division by w + w_i with coefficients in
    Z[v] over one denominator, in SymPy's dense lists of integers and in its sparse ring: what SymPy does fastest.
    """
    v = sympy.Symbol("v")
    half = [sympy.fraction(sympy_expression(c)) for c in zeta[len(zeta) // 2:]]
    bottom = sympy.Poly(1, v)
    for _, d in half:
        bottom = bottom.lcm(sympy.Poly(d, v))
    tops = [sympy.Poly(n, v) * bottom.exquo(sympy.Poly(d, v)) for n, d in half]
    chebyshev = [[int(a) for a in reversed(sympy.Poly(sympy.chebyshevt(m, v), v).all_coeffs())] for m in range(len(half))]
    chebyshev[0] = [1]
    dense = [[[ZZ(int(a)) for a in p.all_coeffs()] for p in polynomials]
             for polynomials in (tops, [sympy.Poly(w, v) for w in nodes])]
    ring, _ = sympy.polys.rings.ring("v", ZZ)
    sparse = [[ring.from_list(p) for p in polynomials] for polynomials in dense]

    def verify(tops, nodes, zero, times, add, scale):
        c = [zero] * len(tops)  # by powers of w
        for m, top in enumerate(tops):
            for power, a in enumerate(chebyshev[m]):
                if a:
                    c[power] = add(c[power], scale(top, a if m == 0 else 2 * a))
        for w in nodes:
            rest = c[-1]
            quotient = [rest]
            for a in reversed(c[:-1]):
                rest = add(a, scale(times(w, rest), -1))
                quotient.append(rest)
            assert not rest
            c = quotient[-2::-1]

    return min(
        measure(lambda: verify(*dense, [], lambda a, b: dup_mul(a, b, ZZ), lambda a, b: dup_add(a, b, ZZ),
                               lambda a, n: dup_mul_ground(a, ZZ(n), ZZ))),
        measure(lambda: verify(*sparse, ring(0), lambda a, b: a * b, lambda a, b: a + b, lambda a, n: a * n)))


# Tables: zeta as fractions of integer polynomials in v, evaluated by Horner.

def integer_fractions(coefficients):
    """The different coefficients of a symmetric mask as (numerator, denominator), highest power first."""
    v = sympy.Symbol("v")
    half = coefficients[len(coefficients) // 2:]
    fractions = [sympy.fraction(sympy.together(sympy_expression(c))) for c in half]
    return [tuple([int(a) for a in sympy.Poly(part, v).all_coeffs()] for part in f) for f in fractions]


def mpmath_table(fractions, v0, digits, levels, printing):
    """Masks of levels 0..levels-1; with `printing` as decimals."""
    with mpmath.workdps(digits + 10):
        fractions = [tuple([mpmath.mpf(a) for a in part] for part in f) for f in fractions]

        def table():
            v = mpmath.mpf(v0[0]) / v0[1] if isinstance(v0, tuple) else mpmath.cos(2 * mpmath.pi / 7)
            rows = []
            for _ in range(levels):
                v = mpmath.sqrt((1 + v) / 2)
                row = [mpmath.polyval(p, v) / mpmath.polyval(q, v) for p, q in fractions]
                rows.append([mpmath.nstr(a, digits, strip_zeros=False) for a in row] if printing else row)
            return rows

        return measure(table)


# Refinement of a closed polygon.

def scipy_refine(points, masks):
    for mask in masks:
        reach = len(mask) // 2
        pad = (reach + 1) // 2
        wrapped = numpy.concatenate([points[-pad:], points, points[:pad]])
        fine = scipy.signal.upfirdn(mask, wrapped, up=2, axis=0)
        first = reach + 2 * pad
        points = fine[first:first + 2 * len(points)]
    return points


def numpy_buffers(points, levels, masks):
    """For every level: the polygon with its ends wrapped, the next level, room for one product."""
    pad = len(masks[0][::2]) // 2
    shape = points.shape[1:]
    return [(numpy.empty(((len(points) << k) + 2 * pad,) + shape), numpy.empty((2 * len(points) << k,) + shape),
             numpy.empty((len(points) << k,) + shape)) for k in range(levels)]


def numpy_refine(points, masks, buffers=None):
    for mask, (wrapped, fine, product) in zip(masks, buffers or numpy_buffers(points, len(masks), masks)):
        odd = mask[::2]  # an interpolating mask has one even coefficient, 1
        pad = len(odd) // 2
        wrapped[:pad], wrapped[pad:-pad], wrapped[-pad:] = points[-pad:], points, points[:pad]
        fine[0::2] = points
        new = fine[1::2]
        numpy.multiply(wrapped[1:1 + len(points)], odd[0], out=new)
        for i, a in enumerate(odd[1:], 1):
            numpy.multiply(wrapped[1 + i:1 + i + len(points)], a, out=product)
            new += product
        points = fine
    return points


# Exponents.

def plain_polytope(label, radius):
    """CPU seconds with the search for candidates and without it; "open" if a polytope of the radius does not close."""
    blocks = [[numpy.array([[float(Fraction(x)) for x in row] for row in matrix]) for matrix in block]
              for block in json.loads(label)]
    found = regularity_peer.search(blocks)
    result = regularity_peer.joint_spectral_radius(blocks, found)
    if result is None or not math.isclose(result[0], radius, rel_tol=1e-6):
        return "open" if result is None else f"{result[0]:.6g}?"
    given = measure(lambda: regularity_peer.joint_spectral_radius(blocks, found))
    return measure(lambda: regularity_peer.search(blocks)) + given, given


# One run.

class Run:
    def __init__(self, arguments):
        self.twoscale = arguments.twoscale
        self.limit = 600 if arguments.full else 60
        self.ours = {}
        for path in sorted(Path(arguments.results).glob("*.json")):
            for b in json.loads(path.read_text())["benchmarks"]:
                if b.get("aggregate_name", "median") == "median":
                    scale = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[b["time_unit"]]
                    self.ours[b["run_name"]] = {"seconds": b["cpu_time"] * scale, "label": b.get("label", ""),
                                                "radius": b.get("radius"), "of_write": b.get("of_write"),
                                                "of_bound": b.get("of_bound")}
        self.rows = []

    def json(self, *arguments):
        command = [self.twoscale, *arguments, "--format", "json"]
        done = subprocess.run(command, text=True, capture_output=True, check=True)
        return json.loads(done.stdout)

    def compare(self, job, at, ours, peer, theirs):
        if ours not in self.ours:
            return
        mine = self.ours[ours]["seconds"]
        self.row(job, at, mine, peer, theirs)

    def row(self, job, at, mine, peer, theirs):
        ratio = theirs / mine if theirs is not None else None
        self.rows.append({"job": job, "at": at, "ours": mine, "peer": peer, "theirs": theirs, "ratio": ratio})
        # A limit is wall clock, so it gives no ratio.
        shown = seconds(theirs) if theirs is not None else f"> {self.limit} s" if peer else ""
        factor = f"{ratio:,.0f}" if ratio is not None and ratio >= 10 else f"{ratio:.1f}" if ratio is not None else ""
        print(f"{job:<32} {at:>16} {seconds(mine):>9}  {peer:<22} {shown:>9} {factor:>10}", flush=True)

    def derive(self):
        for name in FAMILIES + OTHERS:
            alive = {"sympy": True, "pari": True}
            for l in range(2, 11):
                ours = f"derive/{name}/l:{l}"
                if ours not in self.ours or (l > 8 and name in OTHERS):
                    continue
                derivation = self.json("derive", "--space", self.ours[ours]["label"])
                folded = derivation["folded"]
                if alive["sympy"] and l in (4, 8):
                    first = (within(self.limit, sympy_linsolve, unfolded(derivation["sigma"], l), False) or (None,))[0]
                    self.compare(f"derive {name}", f"l={l}", ours, "SymPy, not folded", first)
                    self.compare(f"factored {name}", f"l={l}", f"factored/{name}/l:{l}", "SymPy, not folded", first)
                if alive["sympy"]:
                    first, again = within(self.limit, sympy_linsolve, folded) or (None, None)
                    alive["sympy"] = first is not None
                    self.compare(f"derive {name}", f"l={l}", ours, "SymPy linsolve", first)
                    self.compare(f"factored {name}", f"l={l}", f"factored/{name}/l:{l}", "SymPy linsolve", first)
                    if again is not None:
                        self.compare(f"derive {name}", f"l={l}", ours, "SymPy, same call again", again)
                if alive["pari"]:
                    theirs = pari_matsolve(folded, self.limit)
                    alive["pari"] = theirs is not None
                    self.compare(f"derive {name}", f"l={l}", ours, "PARI matsolve", theirs)
                ternary = f"ternary/{name}/l:{l}"
                if ternary in self.ours and l % 2 == 0:
                    folded = self.json("derive", "--space", self.ours[ours]["label"], "--arity", "3")["folded"]
                    self.compare(f"ternary {name}", f"l={l}", ternary, "PARI matsolve", pari_matsolve(folded, self.limit))
                other = self.ours.get(f"ginac/{name}/l:{l}")
                if other:
                    self.compare(f"derive {name}", f"l={l}", ours, "GiNaC lsolve+normal", other["seconds"])
                    self.compare(f"factored {name}", f"l={l}", f"factored/{name}/l:{l}", "GiNaC lsolve+normal",
                                 other["seconds"])
                for route in ("generic", "hessenberg", "folded"):
                    own = self.ours.get(f"{route}/{name}/l:{l}")
                    if own and l == 8:
                        self.compare(f"derive {name}", f"l={l}", ours, f"own route: {route}", own["seconds"])
        for name in FAMILIES:
            for l in (16, 32, 64):
                if f"factored/{name}/l:{l}" in self.ours:
                    self.row(f"factored {name}", f"l={l}", self.ours[f"factored/{name}/l:{l}"]["seconds"], "", None)

    def process(self):
        """The whole program at l = 8, medians of 15: CPU seconds, and wall-clock seconds."""
        for name in FAMILIES + OTHERS[:2]:
            command = [self.twoscale, "derive", "--space", self.ours[f"derive/{name}/l:8"]["label"], "--format", "json"]
            wall, cpu = [], []
            for _ in range(15):
                begin, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
                subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
                wall.append(time.perf_counter() - start)
                end = resource.getrusage(resource.RUSAGE_CHILDREN)
                cpu.append(end.ru_utime - begin.ru_utime + end.ru_stime - begin.ru_stime)
            self.row(f"process: derive {name}", "l=8, json", statistics.median(cpu), "", None)
            self.row(f"process: derive {name}", "l=8, wall clock", statistics.median(wall), "", None)

    def prove(self):
        v = sympy.Symbol("v")
        for name in FAMILIES:
            for l in range(2, 11):
                if f"prove/{name}/l:{l}" in self.ours:
                    self.row(f"prove {name}", f"l={l}", self.ours[f"prove/{name}/l:{l}"]["seconds"], "", None)
                if l in (4, 6, 8, 10) and f"conditions/{name}/l:{l}" in self.ours:
                    zeta = self.json("derive", f"interpolating:family={name},l={l}")["zeta"]["coefficients"]
                    nodes = {"mixed": [sympy.Integer(1)] * (l - 1) + [v], "resonant": [sympy.Integer(1)] + [v] * (l - 1),
                             "harmonic": [sympy.chebyshevt(j, v) for j in range(l)]}[name]
                    for peer, job in (("SymPy, by division", sympy_conditions), ("SymPy, by cancel", sympy_cancel)):
                        self.compare(f"conditions {name}", f"l={l}", f"conditions/{name}/l:{l}", peer,
                                     within(self.limit, job, zeta, nodes))

    def table(self):
        for name in FAMILIES:
            zeta = self.json("derive", f"interpolating:family={name},l=3")["zeta"]
            fractions = integer_fractions(zeta["coefficients"])
            for text, v0 in (("-2/5", (-2, 5)), ("cos(2*pi/7)", None)):
                for digits in (50, 200, 1000, 10000):
                    ours = f"table/{name}/{text}/digits:{digits}"
                    for printing in (True, False):
                        theirs = mpmath_table(fractions, v0, digits, 60, printing)
                        peer = "mpmath" if printing else "mpmath, not printed"
                        self.compare(f"table {name} {text}", f"{digits} digits", ours, peer, theirs)

    def refine(self):
        levels = 8
        document = self.json("table", "interpolating:family=harmonic,l=3", "--v0", "1/2", "--levels", str(levels),
                             "--double")
        masks = [numpy.array([float(a) for a in row["coefficients"]]) for row in document["levels"]]
        job, kept = "refine 10^4 points, 8 levels", "kept buffers"
        for dim in (1, 2, 3, 4):
            points = numpy.sin(numpy.arange(10000 * dim, dtype=float)).reshape(10000, dim)
            buffers = numpy_buffers(points, levels, masks)
            expected = scipy_refine(points, masks)
            assert numpy.allclose(expected, numpy_refine(points, masks), atol=1e-12)
            assert numpy.allclose(expected, numpy_refine(points, masks, buffers), atol=1e-12)
            for peer, run in (("scipy upfirdn", lambda: scipy_refine(points, masks)),
                              ("numpy slices", lambda: numpy_refine(points, masks, buffers))):
                self.compare(job, f"D={dim}", f"ours/D:{dim}", peer, measure(run, at_least=1, most=5))
            for peer in ("eigen_sparse", "opensubdiv"):
                other = self.ours.get(f"{peer}/D:{dim}")
                if other:
                    name, ours = {"eigen_sparse": ("Eigen sparse", "ours"),
                                  "opensubdiv": ("OpenSubdiv, float", "ours_float")}[peer]
                    self.compare(job, f"D={dim}", f"{ours}/D:{dim}", name, other["seconds"])
                    # The bound: nobody can be faster than writing the result is.
                    self.compare("writing it alone", f"D={dim}", f"{ours.replace('ours', 'writing')}/D:{dim}", name,
                                 other["seconds"])
            allocating = measure(lambda: numpy_refine(points, masks), at_least=1, most=5)
            self.compare("the same, all allocating", f"D={dim}", f"ours_allocating/D:{dim}", "numpy slices", allocating)
            self.compare("the same, ours in a pool", f"D={dim}", f"ours_pooled/D:{dim}", "numpy slices", allocating)
        print(f"\n{'part of the rate of writing, or of the bound':<48} {'threads':>8} {'':>6}")
        for name, value in self.ours.items():
            threads = re.search(r"threads:(\d+)", name)
            shown = re.sub(r"/threads:\d+|/manual_time", "", name)
            for of, ratio in (("", value["of_write"]), (", of the bound", value["of_bound"])):
                if ratio:
                    print(f"{shown + of:<48} {threads[1] if threads else '1':>8} {100 * ratio:5.0f}%")

    def exponents(self):
        """A table of its own: the routes to an exponent, their certificates checked, the plain polytope beside ours."""
        members = {}  # set -> member -> what was measured
        for name, value in self.ours.items():
            checked, route, family, member = re.fullmatch(
                r"(check/|)(?:(regularity|polytope|jsr|enclosure)/([^/]*)/?(.*)|.*)", name).groups()
            if route:
                of = {"jsr": "polytope", "enclosure": "regularity"}.get(route, route)
                family = f"{route} {family}" if of != route else family
                entry = members.setdefault(family, {}).setdefault(member, {})
                entry[f"{of}, checked" if checked else of] = value["seconds"]
                if of == "polytope" and not checked:
                    entry["open"] = value["label"] == "open"
                    if not entry["open"]:
                        theirs = within(self.limit, plain_polytope, value["label"], value["radius"])
                        if isinstance(theirs, tuple):
                            entry["plain"], entry["word given"] = theirs
                        else:
                            entry["failed"] = theirs or f"> {self.limit} s"
        columns = ("regularity", "regularity, checked", "polytope", "polytope, checked", "plain", "word given")
        heads = ("exponent", "checked", "polytope", "checked", "plain", "given", "plain/polytope")
        print(f"\n{'exponents':<24} {'':>18} " + " ".join(f"{h:>9}" for h in heads))

        def line(family, at, entries):
            shown = []
            for column in columns:
                values = [e[column] for e in entries if e.get(column) is not None]
                shown.append(seconds(statistics.median(values)) if values else "")
            ratios = [e["plain"] / e["polytope"] for e in entries if e.get("plain") is not None]
            shown.append(f"{statistics.median(ratios):.1f}" if ratios else
                         "ours open" if all(e.get("open") for e in entries) else "")
            failed = [e["failed"] for e in entries if e.get("failed")]
            if failed:
                shown[4] = shown[4] or failed[0]
            print(f"{family:<24} {at:>18} " + " ".join(f"{s:>9}" for s in shown), flush=True)

        for family, of in members.items():
            if len(of) == 1 or any(":" in member for member in of):
                for member, entry in of.items():
                    line(family, member.replace(":", "="), [entry])
            else:
                line(family, f"median of {len(of)}", list(of.values()))
                for member, entry in of.items():
                    if max(entry.get("regularity", 0), entry.get("polytope", 0)) > 0.1:
                        line(family, member, [entry])
        return members

    def growth(self):
        """Exponents of growth in l, n, the number K of levels, digits, points: least squares in logarithms, from 4 and from
        8 on for l and n."""
        series = {}
        unit = {}
        for name, value in self.ours.items():
            found = re.fullmatch(r"(.*)/(l|n|K|digits|points):(\d+)", name)
            if found:
                unit[found[1]] = found[2]
                series.setdefault(found[1], []).append((int(found[3]), value["seconds"]))
        for row in self.rows:
            if row["peer"] in ("SymPy linsolve", "PARI matsolve") and row["theirs"]:
                series.setdefault(f"{row['peer']} {row['job'][7:]}", []).append((int(row["at"][2:]), row["theirs"]))
        result = {}
        print(f"\n{'growth like x^e':<40} {'x':>18} {'e':>6}")
        for name, points in series.items():
            x = unit.get(name, "l")
            for first in (4, 8) if x in "ln" else (1,):
                tail = [(p, s) for p, s in sorted(points) if p >= first]
                if len(tail) >= 3:
                    slope = numpy.polyfit(*zip(*[(math.log(p), math.log(s)) for p, s in tail]), 1)[0]
                    span = f"{x}={tail[0][0]}..{tail[-1][0]}"
                    result[f"{name} {span}"] = slope
                    print(f"{name:<40} {span:>18} {slope:6.1f}")
        return result


def seconds(value):
    for unit, scale in (("s", 1), ("ms", 1e-3), ("us", 1e-6)):
        if value >= scale:
            return f"{value / scale:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"


def machine():
    cores = os.cpu_count()
    compiler = subprocess.run(["c++", "-dumpfullversion"], text=True, capture_output=True, check=False).stdout.strip()
    packages = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}, ", "libflint-dev", "libflint-arb-dev",
                               "libginac-dev", "pari-gp"], text=True, capture_output=True, check=False).stdout
    return (f"{cores} cores {platform.machine()}, g++ {compiler}, {packages}SymPy {sympy.__version__} "
            f"({sympy.external.gmpy.GROUND_TYPES}), mpmath {mpmath.__version__} ({mpmath.libmp.BACKEND}), "
            f"SciPy {scipy.__version__}, NumPy {numpy.__version__}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("twoscale")
    parser.add_argument("results")
    parser.add_argument("out")
    parser.add_argument("--full", action="store_true", help="600 instead of 60 seconds for a case")
    parser.add_argument("--only", help="a comma list of derive, process, prove, table, refine, regularity")
    arguments = parser.parse_args()
    run = Run(arguments)
    wanted = arguments.only and arguments.only.split(",")
    print(machine() + "\n")
    print(f"{'job':<32} {'':>16} {'ours':>9}  {'peer':<22} {'theirs':>9} {'ratio':>10}")
    for part in (run.derive, run.process, run.prove, run.table, run.refine):
        if wanted is None or part.__name__ in wanted:
            part()
    exponents = run.exponents() if wanted is None or "regularity" in wanted else {}
    document = {"format": "twoscale/bench", "machine": machine(), "rows": run.rows, "exponents": exponents,
                "growth": run.growth(), "benchmarks": run.ours}
    Path(arguments.out).write_text(json.dumps(document, indent=1) + "\n")


if __name__ == "__main__":
    main()
