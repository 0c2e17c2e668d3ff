# SPDX-License-Identifier: GPL-3.0-or-later
"""The algebra and the numbers of reports/hermite2010/tension.md, by SymPy and mpmath; `stencil` and `refine` against both.

Notation as there: s = tan(sigma/8), X(s) = 2s/(1-s^2) = tan(sigma/4); derivatives in x are P = p/2, R = r/4.
"""

import os
import tempfile
import unittest

import mpmath
import sympy as sp

from support import ProgramTest

W, S, H, Y = sp.symbols("w s h y")
B = 10 * Y**3 - 15 * Y**4 + 6 * Y**5
E_LEFT = (W - 1) / W * S * (1 - S**2) ** 2 / (2 * (1 + S**2) ** 2)
E_RIGHT = -(W - 1) / W * S * (1 - S**2) * (7 + S**2) / (2 * (1 + S**2) ** 2)


def doubled(s):
    return 2 * s / (1 - s**2)


def hermite_rule(v, u):
    """The 3x6 matrix of one step: quintic Hermite interpolation of (1+x^2)^2 f, not the weights of the paper."""
    number = (lambda n: mpmath.mpf(n)) if isinstance(v, mpmath.mpf) else sp.Integer
    a, b, x = doubled(v), doubled(u), (u + v) / (1 - u * v)
    h = b - a
    y = (x - a) / h

    def basis(y):  # value, first and second derivative of the quintic Hermite basis f0, f1, p0, p1, r0, r1
        one = number(1)
        phi0 = [one - 10 * y**3 + 15 * y**4 - 6 * y**5, -30 * y**2 + 60 * y**3 - 30 * y**4, -60 * y + 180 * y**2 - 120 * y**3]
        psi0 = [y - 6 * y**3 + 8 * y**4 - 3 * y**5, 1 - 18 * y**2 + 32 * y**3 - 15 * y**4, -36 * y + 96 * y**2 - 60 * y**3]
        chi0 = [(y**2 - 3 * y**3 + 3 * y**4 - y**5) / 2, (2 * y - 9 * y**2 + 12 * y**3 - 5 * y**4) / 2,
                (2 - 18 * y + 36 * y**2 - 20 * y**3) / 2]
        return phi0, psi0, chi0

    phi0, psi0, chi0 = basis(y)
    phi1, psi1, chi1 = basis(1 - y)
    # Columns N(a), N(b), N'(a), N'(b), N''(a), N''(b); rows N, N', N'' at x.
    n = [[[phi0, phi1][e][d] * (-1) ** (d * e) / h**d for e in (0, 1)] +
         [[psi0, psi1][e][d] * (-1) ** (d * e + e) * h / h**d for e in (0, 1)] +
         [[chi0, chi1][e][d] * (-1) ** (d * e) * h**2 / h**d for e in (0, 1)] for d in range(3)]
    weight = lambda z: ((1 + z**2) ** 2, 4 * z * (1 + z**2), 4 + 12 * z**2)
    columns = []
    for order in range(3):
        for end in (0, 1):
            d = weight((a, b)[end])
            # Derivatives in x of D c for the unit datum: c^(order) = 1 in t, 2^-order in x.
            c = [number(0)] * 3
            c[order] = number(1) / 2**order
            data = [d[0] * c[0], d[1] * c[0] + d[0] * c[1], d[2] * c[0] + 2 * d[1] * c[1] + d[0] * c[2]]
            m = [sum(n[k][2 * j + end] * data[j] for j in range(3)) for k in range(3)]
            d = weight(x)
            c0 = m[0] / d[0]
            c1 = (m[1] - d[1] * c0) / d[0]
            c2 = (m[2] - d[2] * c0 - 2 * d[1] * c1) / d[0]
            columns.append([c0, 2 * c1, 4 * c2])
    return [[column[k] for column in columns] for k in range(3)]


class Algebra(unittest.TestCase):
    def test_lengths_of_the_two_halves(self):
        """Lemma 2: the fake lengths of the halves against the halves of the fake interval."""
        def angle_middle(a, b):  # tan of the mean angle
            return sp.tan((sp.atan(a) + sp.atan(b)) / 2)
        def taylor(f):
            return sum(sp.simplify(sp.diff(f, H, k).subs(H, 0)) * H**k / sp.factorial(k) for k in range(3))
        fake = S + W * H
        middle = taylor(angle_middle(S, S + H))
        fake_middle = doubled(taylor(angle_middle(S, fake)))
        left = doubled(S + W * (middle - S)) - doubled(S)
        right = doubled(middle + W * (S + H - middle)) - doubled(middle)
        y_left = fake_middle - doubled(S)
        y_right = doubled(fake) - fake_middle
        for length, y, kick in ((left, y_left, E_LEFT), (right, y_right, E_RIGHT)):
            second = lambda e: sp.diff(e, H, 2).subs(H, 0) / 2
            first = lambda e: sp.diff(e, H).subs(H, 0)
            self.assertEqual(sp.simplify(first(length) - first(y)), 0)
            self.assertEqual(sp.simplify((second(length) - second(y)) / first(y) ** 2 - kick), 0)

    def test_a_wrong_length_adds_a_multiple_of_the_tangent(self):
        """Lemma 3: data of q on length 1, read on length 1 + e: the second derivative changes by -e P B'' to first order."""
        e, p0 = sp.symbols("e P0")
        q = sum(sp.Symbol(f"q{k}") * Y**k for k in range(4))
        first = p0 + sp.integrate(q, Y)
        value = sp.integrate(first, Y)
        length = 1 + e
        c = sp.symbols("c0:6")
        quintic = sum(c[k] * Y**k for k in range(6))
        conditions = [quintic.subs(Y, 0) - value.subs(Y, 0), quintic.subs(Y, 1) - value.subs(Y, 1)]
        for order, given in ((1, first), (2, q)):
            d = sp.diff(quintic, Y, order) / length**order
            conditions += [d.subs(Y, 0) - given.subs(Y, 0), d.subs(Y, 1) - given.subs(Y, 1)]
        solution = sp.solve(conditions, c, dict=True)[0]
        second = sp.diff(quintic.subs(solution), Y, 2) / length**2
        change = sp.diff(second, e).subs(e, 0)
        # The part with the large factor 1/H is the one of P; the rest is a bounded factor times e q.
        self.assertEqual(sp.expand(sp.diff(change, p0) + sp.diff(B, Y, 2)), 0)

    def test_the_two_halves_share_a_triangular_form(self):
        """On cubics q: q(y) -> q(y/2), q((1+y)/2) are lower triangular in 1, y, y^2, y^3 with diagonal 1, 1/2, 1/4, 1/8."""
        for inner in (Y / 2, (1 + Y) / 2):
            for k in range(4):
                image = sp.Poly(sp.expand(inner**k), Y)
                self.assertEqual(image.degree(), k)
                self.assertEqual(image.coeff_monomial(Y**k), sp.Rational(1, 2**k))

    def test_series_at_a_vertex(self):
        """Sums over the levels along L^infinity of B'', 2^n B', 4^n B at 2^-n: 120/7, 100/7, 48/7."""
        for order, expected in ((2, sp.Rational(120, 7)), (1, sp.Rational(100, 7)), (0, sp.Rational(48, 7))):
            poly = sp.Poly(sp.diff(B, Y, order), Y)
            total = 0
            for (power,), coefficient in poly.terms():
                ratio = sp.Rational(2 ** (2 - order), 2**power)
                self.assertLess(ratio, 1)
                total += coefficient / (1 - ratio)
            self.assertEqual(total, expected)

    def test_jump_and_drift(self):
        jump = -sp.Rational(240, 7) * (E_LEFT + E_RIGHT)
        self.assertEqual(sp.simplify(jump - sp.Rational(240, 7) * (W - 1) / W * S * (1 - S**2) * (3 + S**2) / (1 + S**2) ** 2), 0)
        second = sp.diff(B, Y, 2)
        self.assertEqual(second.subs(Y, sp.Rational(1, 3)), sp.Rational(40, 9))
        self.assertEqual(second.subs(Y, sp.Rational(2, 3)), -sp.Rational(40, 9))
        # Inside (LR)^infinity the point sits at 2/3 of an edge whose half was taken as L, at 1/3 after R.
        drift = -2 * (E_LEFT * second.subs(Y, sp.Rational(2, 3)) + E_RIGHT * second.subs(Y, sp.Rational(1, 3)))
        self.assertEqual(sp.simplify(drift - sp.Rational(320, 9) * (W - 1) / W * S * (1 - S**2) / (1 + S**2) ** 2), 0)
        theta = sp.Symbol("theta")
        in_angle = (S * (1 - S**2) / (1 + S**2) ** 2).subs(S, sp.tan(theta))
        self.assertEqual(sp.simplify(in_angle - sp.sin(4 * theta) / 4), 0)

    def test_the_step_without_the_parameter_of_the_paper(self):
        """p = f' of (8) would need f linear in the dyadic parameter for t: it is linear in t, that is in tan(sigma/4)."""
        v, u = sp.Rational(1, 10), sp.Rational(1, 3)
        rule = hermite_rule(v, u)
        t = [(1 + doubled(v)) / 2, (1 + doubled(u)) / 2]
        new = [sum(rule[k][j] * d for j, d in enumerate([t[0], t[1], 1, 1, 0, 0])) for k in range(3)]
        self.assertEqual(new, [(1 + (u + v) / (1 - u * v)) / 2, 1, 0])
        self.assertNotEqual(new[0], (t[0] + t[1]) / 2)


class Experiment(unittest.TestCase):
    """60 digits and more, 30 levels; the printed rule with w = 7/5."""

    def setUp(self):
        self.precision = mpmath.workdps(100)
        self.precision.__enter__()
        self.addCleanup(self.precision.__exit__, None, None, None)
        self.w = mpmath.mpf(7) / 5
        self.sigma = [mpmath.mpf(4) / 5, mpmath.mpf(2)]
        # Two components: f_0, f_1, p_0, p_1, r_0, r_1.
        m = mpmath.mpf
        self.data = [[m(1), m(2), m(3), -m(1) / 2, m(1) / 3, m(5) / 7], [m(0), m(1) / 2, m(1), m(2), -m(1), m(1) / 4]]

    def walk(self, word, variant="printed"):
        left, right = self.sigma
        edge = [list(d) for d in self.data]
        for letter in word:
            v, u = mpmath.tan(left / 8), mpmath.tan(right / 8)
            if variant == "printed":
                rule = hermite_rule(v, v + self.w * (u - v))
            else:
                rule = hermite_rule(v, u)
                rule = [[rule[k][j] * self.w ** (j // 2 - k) for j in range(6)] for k in range(3)]
            middle = (left + right) / 2
            fresh = [[sum(a * b for a, b in zip(row, d)) for row in rule] for d in edge]
            if letter == "L":
                right = middle
                edge = [[d[0], n[0], d[2], n[1], d[4], n[2]] for d, n in zip(edge, fresh)]
            else:
                left = middle
                edge = [[n[0], d[1], n[1], d[3], n[2], d[5]] for d, n in zip(edge, fresh)]
            yield left, right, edge

    @staticmethod
    def wedge(edge, end):
        (x, y) = edge
        return x[2 + end] * y[4 + end] - x[4 + end] * y[2 + end]

    def value(self, expression, sigma):
        s = mpmath.tan(sigma / 8)
        f = sp.lambdify((S, W), expression, "mpmath")
        return f(s, self.w)

    def test_one_sided_limits_at_a_vertex(self):
        for word, end, sign, kick in (("L" * 30, 0, -1, E_LEFT), ("R" * 30, 1, 1, E_RIGHT)):
            steps = list(self.walk(word))
            expected = sign * mpmath.mpf(240) / 7 * self.value(kick, self.sigma[end])
            error = [max(abs((d[5 - end] - d[4 + end]) / d[2 + end] - expected) for d in steps[k][2]) for k in (19, 29)]
            self.assertLess(error[1], 1e-5)
            self.assertLess(error[1], error[0] / 500)  # O(2^-k), up to a power of k

    def test_drift_along_alternating_halves(self):
        steps = list(self.walk("LR" * 16))
        (_, _, before), (left, _, after) = steps[-3], steps[-1]
        expected = mpmath.mpf(80) / 9 * (self.w - 1) / self.w * mpmath.sin(left / 2)
        for old, new in zip(before, after):
            self.assertLess(abs((new[4] - old[4]) / new[2] - expected), 1e-7)
        # r itself has no limit: it has moved by about 16 drifts.
        self.assertGreater(abs(after[0][4]), 10 * abs(expected * after[0][2]))

    def test_curvature_converges(self):
        for word in ("LR" * 16, "L" * 32, "R" * 32, "LLR" * 11, "LRRLLLRR" * 4):
            steps = list(self.walk(word))
            start, later, end = self.wedge(steps[15][2], 0), self.wedge(steps[23][2], 0), self.wedge(steps[-1][2], 0)
            self.assertLess(abs(later - end), abs(end) * 1e-4)
            self.assertLess(abs(later - end), abs(start - end) / 16 + mpmath.mpf(10) ** -40)
            for k, (_, _, edge) in enumerate(steps[8:], 9):
                self.assertLess(abs(self.wedge(edge, 0) - self.wedge(edge, 1)), 50 * k**3 * mpmath.mpf(2) ** -k)

    def test_the_variant_is_the_interpolant_of_f_wp_wwr(self):
        """Its r converges, to c''/w^2; the curvature at the vertices is that of the data."""
        for word in ("LR" * 15, "L" * 30, "R" * 30):
            steps = list(self.walk(word, "c2"))
            for d in steps[-1][2]:
                self.assertLess(abs(d[4] - d[5]), 1e-6)
                self.assertLess(abs((d[1] - d[0]) / (mpmath.tan(steps[-1][1] / 4) - mpmath.tan(steps[-1][0] / 4)) * 2
                                    - self.w * d[2]), 1e-6)


class Program(ProgramTest):
    def test_stencils(self):
        for variant in ("printed", "c2"):
            for s, w in ((("-1/5", "1/7"), "1/2"), (("1/3", "2/5"), "9/4"), (("-1/3", "1/3"), "1"), (("0", "1/9"), "3")):
                document = self.twoscale_json("stencil", f"hermite-circle:variant={variant}", "--at", f"s=[{s[0]},{s[1]}],w={w}")
                self.assertEqual(document["at"], {"s": list(s), "w": w})
                v, u, w = sp.Rational(s[0]), sp.Rational(s[1]), sp.Rational(w)
                if variant == "printed":
                    expected = hermite_rule(v, v + w * (u - v))
                else:
                    plain = hermite_rule(v, u)
                    expected = [[plain[k][j] * w ** (j // 2 - k) for j in range(6)] for k in range(3)]
                self.assertEqual([[sp.Rational(x) for x in row] for row in document["matrix"]], expected)

    def test_refine_in_many_digits(self):
        """A closed polygon to level 4 in 40 digits, the closing edge with converted derivatives."""
        rows = ["3,0.25,-1,7,-40,1,0.1", "1,2,-9,3,-11,-30,1.2", "-2,1.5,-6,-8,35,-9,2.4", "-1,-2,5,-6,30,22,3.9",
                "2.5,-1.5,7,6,1,30,5.5"]
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "in.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write("fx,fy,px,py,rx,ry,sigma\n" + "\n".join(rows) + "\n")
            for variant, w in (("printed", "1"), ("printed", "5/4"), ("c2", "3/2")):
                out = self.twoscale("refine", f"hermite-circle:variant={variant},w={w}", "--levels", "4", "--digits", "40",
                                    "--quiet", path).split()
                self.assertEqual(out[0], "fx,fy,px,py,rx,ry,sigma")
                with mpmath.workdps(70):
                    expected = self.refined([[mpmath.mpf(x) for x in row.split(",")] for row in rows], 4, variant,
                                            mpmath.mpf(sp.Rational(w).p) / sp.Rational(w).q)
                    self.assertEqual(len(out) - 1, len(expected))
                    for line, row in zip(out[1:], expected):
                        for text, value in zip(line.split(","), row):
                            self.assertLessEqual(abs(mpmath.mpf(text) - value), abs(value) * mpmath.mpf("1e-39"))

    @staticmethod
    def refined(rows, levels, variant, w):
        def rates(sigma):
            a = mpmath.tan(sigma / 4)
            return (1 + a * a) / 8, a * (1 + a * a) / 16
        omega = w if variant == "c2" else 1
        first, again = rows[0], rows[0][6] + 2 * mpmath.pi
        if again < 2 * mpmath.pi:
            raise AssertionError("the closing edge is meant to leave the chart")
        # The closing edge in the chart of vertex 0: the last vertex is converted.
        last = list(rows[-1])
        (t1, t2), (n1, n2) = rates(last[6]), rates(last[6] - 2 * mpmath.pi)
        p = [x * t1 / n1 for x in last[2:4]]
        r = [(x * t1**2 + (y * t2 - q * n2) / omega) / n1**2 for x, y, q in zip(last[4:6], last[2:4], p)]
        closing = last[:2] + p + r + [last[6] - 2 * mpmath.pi]
        out = []
        for i, row in enumerate(rows):
            edge = [row, rows[i + 1]] if i + 1 < len(rows) else [closing, first]
            for _ in range(levels):
                finer = []
                for a, b in zip(edge, edge[1:]):
                    v, u = mpmath.tan(a[6] / 8), mpmath.tan(b[6] / 8)
                    rule = hermite_rule(v, v + w * (u - v) if variant == "printed" else u)
                    new = []
                    for k in range(3):
                        scale = [w ** (j - k) if variant == "c2" else 1 for j in range(3)]
                        for c in (0, 1):
                            new.append(sum(scale[j] * (rule[k][2 * j] * a[2 * j + c] + rule[k][2 * j + 1] * b[2 * j + c])
                                           for j in range(3)))
                    finer += [a, new + [(a[6] + b[6]) / 2]]
                edge = finer + [edge[-1]]
            out += [row] + edge[1:-1]
        return out

    # ---- Points alone: Algorithm 1 and the derivatives, written again from docs/hermite.md

    def test_points_alone_in_many_digits(self):
        """Two closed polygons to level 4 and one in space that lies in no plane, in 40 digits."""
        polygons = {"plane": ["0,0", "4,-1", "5,2", "2,5", "-1,3"],
                    "uneven": ["1.5,0.1", "1.2,0.9", "-0.4,1.25", "-1.3,-0.2", "-0.9,-1", "0.8,-0.75"],
                    "space": ["3,0,0.5", "1,2.5,-0.25", "-2,1,1", "-2.5,-1.5,0", "0.5,-2,0.75"]}
        with tempfile.TemporaryDirectory() as directory, mpmath.workdps(80):
            for name, rows in polygons.items():
                path = os.path.join(directory, name + ".csv")
                with open(path, "w", encoding="utf-8") as file:
                    file.write("\n".join(rows) + "\n")
                points = [[mpmath.mpf(x) for x in row.split(",")] for row in rows]
                for variant, w in (("printed", "5/4"), ("c2", "3/4")):
                    out = self.twoscale("refine", f"hermite-circle:variant={variant},w={w}", "--levels", "4", "--digits", "40",
                                        "--quiet", path).split()
                    expected = self.from_points(points, 4, variant, mpmath.mpf(sp.Rational(w).p) / sp.Rational(w).q)
                    self.assertEqual(len(out) - (0 if out[0][0] in "-0123456789" else 1), len(expected))
                    for line, row in zip(out[-len(expected):], expected):
                        for text, value in zip(line.split(","), row):
                            self.assertLessEqual(abs(mpmath.mpf(text) - value), abs(value) * mpmath.mpf("1e-39"), name)

    def from_points(self, points, levels, variant, w):
        dim, n = len(points[0]), len(points)
        f = [mpmath.matrix(p + [mpmath.mpf(0)] * (3 - dim)) for p in points]
        dot = lambda a, b: sum(a[i] * b[i] for i in range(3))
        norm = lambda a: mpmath.sqrt(dot(a, a))
        cross = lambda a, b: mpmath.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])

        def centre(a, m, b):  # solves for the point of the plane that is equally far from the three
            u, v = a - m, b - m
            normal = cross(u, v)
            return m + mpmath.lu_solve(mpmath.matrix([list(u), list(v), list(normal)]),
                                       mpmath.matrix([dot(u, u) / 2, dot(v, v) / 2, 0]))

        b = sum((centre(f[i - 1], f[i], f[(i + 1) % n]) for i in range(n)), mpmath.matrix([0, 0, 0])) / n
        normal = mpmath.matrix([0, 0, 1])
        if dim == 3:
            moments = mpmath.matrix(3, 3)
            for p in f:
                moments += (p - b) * (p - b).T
            values, vectors = mpmath.eigsy(moments)
            normal = vectors[:, 0]
            if normal[2] < 0:
                normal = -normal
        e1 = mpmath.matrix([1, 0, 0])
        if dim == 3:
            e1 = mpmath.matrix([normal[2], 0, -normal[0]])
            e1 /= norm(e1)
        e2 = cross(normal, e1)
        sigma = [mpmath.atan2(dot(p - b, e2), dot(p - b, e1)) for p in f]
        steps = [(y - x) % (2 * mpmath.pi) for x, y in zip(sigma, sigma[1:] + sigma[:1])]
        self.assertLess(abs(sum(steps) - 2 * mpmath.pi), 1e-20, "one turn, counterclockwise")
        sigma = [-mpmath.pi + sum(steps[:i]) for i in range(n)]
        rates = lambda s: ((1 + mpmath.tan(s / 4) ** 2) / 8, mpmath.tan(s / 4) * (1 + mpmath.tan(s / 4) ** 2) / 16)
        omega = w if variant == "c2" else 1
        data = []
        for i in range(n):
            left, right = f[i - 1], f[(i + 1) % n]
            c = centre(left, f[i], right)
            inward = (c - f[i]) / dot(c - f[i], c - f[i])  # curvature vector of the circle
            tangent = cross(cross(f[i] - left, right - f[i]), f[i] - c)
            radius = [norm(f[i] - left) / (2 * mpmath.sin(steps[i - 1] / 2)), norm(right - f[i]) / (2 * mpmath.sin(steps[i] / 2))]
            speed = 2 / (1 / radius[0] + 1 / radius[1])
            first, second = tangent * (speed / norm(tangent)), inward * speed**2
            t1, t2 = rates(sigma[i])
            p = first / t1
            data.append((f[i], p, (second - p * t2) / t1**2, sigma[i]))
        # The closing edge ends a turn after vertex 0: its data there have the same derivatives in sigma.
        start = data[0]
        (o1, o2), (t1, t2) = rates(start[3]), rates(start[3] + 2 * mpmath.pi)
        p = start[1] * (o1 / t1)
        data.append((start[0], p, (start[2] * o1**2 + (start[1] * o2 - p * t2) / omega) / t1**2, start[3] + 2 * mpmath.pi))
        out = []
        for edge in zip(data, data[1:]):
            edge = list(edge)
            for _ in range(levels):
                finer = []
                for a, c in zip(edge, edge[1:]):
                    v, u = mpmath.tan(a[3] / 8), mpmath.tan(c[3] / 8)
                    rule = hermite_rule(v, v + w * (u - v) if variant == "printed" else u)
                    new = [sum((w ** (j - k) if variant == "c2" else 1) * (rule[k][2 * j] * a[j] + rule[k][2 * j + 1] * c[j])
                               for j in range(3)) for k in range(3)]
                    finer += [a, (*new, (a[3] + c[3]) / 2)]
                edge = finer + [edge[-1]]
            out += [list(x[0])[:dim] for x in edge[:-1]]
        return out


if __name__ == "__main__":
    unittest.main()
