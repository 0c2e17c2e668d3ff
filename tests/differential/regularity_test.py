# SPDX-License-Identifier: GPL-3.0-or-later
"""`regularity` against arithmetic of its own: growth of the iterated coefficients in floating point, spectral radii of
the reported cycles by PARI/GP, differences of refined data, Fourier transforms for the Sobolev exponent."""

import json
import os
import tempfile
import unittest
from fractions import Fraction

import classic_masks
import numpy
from support import ProgramTest, pari, to_pari


def masks():
    """name, arity, mask: the table of classical masks, and lopsided ones."""
    for name, m, mask, *_ in classic_masks.table():
        yield name, m, mask
    state = 2024
    for k in range(24):  # pseudorandom remainders
        values = []
        for _ in range(3 + k % 4):
            state = (1103515245 * state + 12345) % 2 ** 31
            values.append(Fraction(state // 65536 % 13 - 4))
        m, order = 2 + k % 3, 1 + k % 3
        values[0] = values[0] or Fraction(1)
        values[-1] = values[-1] or Fraction(2)
        total = sum(values)
        if total == 0:
            continue
        rest = classic_masks.scaled(m / total, values)
        yield f"pseudorandom {k}", m, classic_masks.convolved(rest, classic_masks.power(classic_masks.mean(m), order))


def transition_matrices(c, m):
    n0 = len(c) - 1
    size = max(1, -(-n0 // (m - 1)))
    at = lambda i: c[i] if 0 <= i <= n0 else Fraction(0)
    return [[[at(n0 + 1 - m + s + p - m * q) for q in range(size)] for p in range(size)] for s in range(m)]


def product(a, b):
    return [[sum(x * b[k][j] for k, x in enumerate(row)) for j in range(len(b[0]))] for row in a]


def of_word(matrices, word):
    p = matrices[word[0]]
    for s in word[1:]:
        p = product(matrices[s], p)
    return p


def pari_matrix(rows):
    if len(rows) == 1:
        return f"Mat({rows[0][0]})"
    return "[" + "; ".join(", ".join(str(x) for x in row) for row in rows) + "]"


class Regularity(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.documents = []
        for name, m, mask in masks():
            test = cls("twoscale_json")
            cls.documents.append((name, m, mask, test.twoscale_json("regularity", classic_masks.scheme(m, mask))))

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    @staticmethod
    def norms(c, m, steps):
        """Of the first powers of the subdivision operator of c, in the maximum norm."""
        iterated, norms = numpy.ones(1), []
        for k in range(steps):
            # c_{k+1}(z) = c(z) c_k(z^m)
            dilated = numpy.zeros((len(iterated) - 1) * m + 1)
            dilated[::m] = iterated
            iterated = numpy.convolve(c, dilated)
            stride = m ** (k + 1)
            padded = numpy.zeros(-(-len(iterated) // stride) * stride)
            padded[:len(iterated)] = numpy.abs(iterated)
            norms.append(padded.reshape(-1, stride).sum(axis=0).max())
        return norms

    def test_growth(self):
        """max |coefficient| of c(z) c(z^m) ... is at least (rho - epsilon)^n up to a constant and, summed over the
        cosets mod m^n, a submultiplicative bound of rho from above."""
        seen = 0
        for name, m, mask, d in self.documents:
            if d["jsr"] is None:
                continue
            seen += 1
            with self.subTest(name):
                c = numpy.array([float(Fraction(x)) for x in d["remainder"]])
                low, high = (float(Fraction(d["jsr"][k])) for k in ("lower", "upper"))
                n = {2: 13, 3: 8, 4: 6, 5: 5}[m]
                norms = self.norms(c, m, n)
                for k, norm in enumerate(norms):  # the norm of the subdivision operator's power
                    self.assertGreaterEqual(norm ** (1 / (k + 1)), low * (1 - 1e-9))
                # The ratio over the last steps tends to rho; norms grow like n^(d-1) rho^n at most.
                estimate = (norms[-1] / norms[n // 2 - 1]) ** (1 / (n - n // 2))
                self.assertLess(estimate, high * (n / (n // 2)) ** (2 / (n - n // 2)) * 1.1)
                self.assertGreater(estimate, low * 0.75)
        self.assertGreater(seen, 100)

    def test_cycles(self):
        """The spectral radii of the cycles, by PARI: they attain the radius, or they are its lower bound."""
        code, expected = ["default(realprecision, 60);", "rad(A) = vecmax(abs(polroots(charpoly(A))));"], []
        for name, m, mask, d in self.documents:
            jsr = d["jsr"]
            if jsr is None or not jsr["cycles"]:
                continue
            matrices = transition_matrices([Fraction(x) for x in d["remainder"]], m)
            for word in jsr["cycles"]:
                radius = f"rad({pari_matrix(of_word(matrices, word))})^(1/{len(word)})"
                exact = jsr["exact"]
                low, high = jsr["lower"], jsr["upper"]
                if exact is None:
                    code.append(f"r = {radius}; print(r >= {low} && r <= {high} && r <= {low}*(1 + 1e-9))")
                elif isinstance(exact, str):
                    code.append(f"r = {radius}; print(abs(r - ({to_pari(exact)})) < 1e-25*r)")
                else:
                    a, b = exact["interval"]
                    code.append(f"r = {radius}; p = {exact['polynomial']}; print(polisirreducible(p) "
                                f"&& polsturm(p, [{a}, {b}]) == 1 && r >= {a} - 1e-25 && r <= {b} + 1e-25 "
                                "&& vecmin(abs(polroots(p) - vector(poldegree(p), i, r)~)) < 1e-25*r)")
                expected.append((name, word))
        answers = pari("\n".join(code)).splitlines()
        self.assertEqual(len(answers), len(expected))
        for answer, what in zip(answers, expected):
            self.assertEqual(answer, "1", what)
        self.assertGreater(len(expected), 30)

    def test_central_radius(self):
        """Non-negative symbols: the minimum on the circle and the central matrix, by PARI."""
        code, names = ["default(realprecision, 50);", "at(p, a) = subst(p, 'x, a) == 0;"], []
        for name, m, mask, d in self.documents:
            if d["method"] != "nonnegative-symbol":
                continue
            c = [Fraction(x) for x in d["remainder"]]
            h = (len(c) - 1) // 2
            self.assertEqual(c, c[::-1])
            g = lambda k: c[h + k] if abs(k) <= h else Fraction(0)
            size = max(0, (h - 1) // (m - 1)) + 1 if h > 0 else 1
            central = [[g(i - m * j) + (g(i + m * j) if j > 0 else 0) for j in range(size)] for i in range(size)]
            exact = d["jsr"]["exact"]
            if isinstance(exact, str):
                value = to_pari(exact)
            else:
                a, b = exact["interval"]
                value = (f"[t | t <- real(polroots({exact['polynomial']})), "
                         f"t >= {a} - 1e-12 && t <= {b} + 1e-12][1]")
            p = " + ".join([str(g(0))] + [f"2*({g(k)})*polchebyshev({k}, 1, 'x)" for k in range(1, h + 1)])
            # No root of odd multiplicity in (-1, 1): Sturm on the square-free part of odd exponents.
            code.append(f"p = {p}; odd = 1; "
                        "if(poldegree(p) > 0, f = factor(p); for(i = 1, #f~, if(f[i,2] % 2, odd *= f[i,1]))); "
                        "inside = if(poldegree(odd) > 0, polsturm(odd, [-1, 1]) - at(odd, -1) - at(odd, 1), 0); "
                        f"r = vecmax(abs(polroots(charpoly({pari_matrix(central)})))); "
                        f"print([inside, subst(p + 0*'x, 'x, 1) == {m}, abs(r - ({value})) < 1e-10*r])")
            names.append(name)
        answers = pari("\n".join(code)).splitlines()
        self.assertEqual(len(answers), len(names))
        for answer, name in zip(answers, names):
            self.assertEqual(answer, "[0, 1, 1]", name)

    def test_attained(self):
        """Attained or not: norms of the n-th powers, divided by radius^n, stay bounded or grow like n. For an integer
        exponent k these are powers for the mask with S_m divided out k times and radius 1, else those of the
        remainder."""
        seen = {True: 0, False: 0}
        for name, m, mask, d in self.documents:
            if d["attained"] is None:
                continue
            exact = d["hoelder"]["exact"]
            integer = isinstance(exact, str) and exact.isdigit()
            c = [Fraction(x) for x in d["remainder"]]
            radius = float(Fraction(d["jsr"]["lower"]))
            if integer:
                factor = classic_masks.power(classic_masks.mean(m), d["sum_rules"] - int(exact))
                c, radius = classic_masks.convolved(c, factor), 1.0
            n = {2: 14, 3: 9, 4: 7, 5: 6}[m]
            norms = self.norms(numpy.array([float(x) for x in c]), m, n)
            norms = [x / radius ** (k + 1) for k, x in enumerate(norms)]
            with self.subTest(name):
                grows = max(norms) > 1.12 * max(norms[:n // 2 + 1])
                self.assertEqual(grows, not d["attained"], norms)
                seen[d["attained"]] += 1
        self.assertGreater(seen[True], 60)
        self.assertGreater(seen[False], 5)

    def test_differences_of_refined_data(self):
        """Divided differences of order k+1 of the data after n steps grow by m^{k+1-alpha} each step."""
        seen = 0
        for name, m, mask, d in self.documents:
            e = d["hoelder"]
            if e["lower"] is None or e["upper"] is None or float(Fraction(e["lower"])) <= 0:
                continue
            low, high = float(Fraction(e["lower"])), float(Fraction(e["upper"]))
            if low > 3.6 or (high == low and low == int(low)):
                continue  # integer exponents: differences grow like powers of n; large ones: cancellation
            seen += 1
            order = int(low) + 1
            a = numpy.array([float(c) for c in mask])
            data = numpy.zeros(1)
            data[0] = 1
            n = {2: 11, 3: 7, 4: 6, 5: 5}[m]
            sizes = []
            for _ in range(n):
                spread = numpy.zeros((len(data) - 1) * m + 1)
                spread[::m] = data
                data = numpy.convolve(a, spread)
                padded = numpy.concatenate([numpy.zeros(order), data, numpy.zeros(order)])
                sizes.append(numpy.abs(numpy.diff(padded, order)).max())
            with self.subTest(name):
                measured = -numpy.log(sizes[-1] / sizes[-4]) / (3 * numpy.log(m))
                self.assertGreater(measured, low - 0.3)
                self.assertLess(measured, high + 0.3)
        self.assertGreater(seen, 40)

    def test_sobolev(self):
        """The spectral radius of the transfer operator of |c|^2, in floating point."""
        for name, m, mask, d in self.documents:
            if d["jsr"] is None:
                continue
            c = numpy.array([float(Fraction(x)) for x in d["remainder"]])
            g = numpy.convolve(c, c[::-1])
            n0 = len(c) - 1
            size = max(1, 2 * n0 // (m - 1) + 1)
            half = size // 2
            at = lambda k: g[k + n0] if abs(k) <= n0 else 0.0
            transfer = numpy.array([[at(m * i - j) for j in range(-half, half + 1)] for i in range(-half, half + 1)])
            krylov = numpy.zeros(2 * half + 1)
            krylov[half] = 1
            # Growth of the central coefficient: (T^n e_0)_0 up to a constant.
            n, logs = 60, 0.0
            for k in range(2 * n):
                krylov = transfer @ krylov
                scale = numpy.abs(krylov).max()
                krylov /= scale
                if k >= n:
                    logs += numpy.log(scale)
            radius = numpy.exp(logs / n)
            exponent = d["sum_rules"] + 0.5 - 0.5 * numpy.log(radius) / numpy.log(m)
            with self.subTest(name):
                self.assertAlmostEqual(float(Fraction(d["sobolev"]["lower"])), exponent, delta=0.03)

    def test_random_families(self):
        """Matrices: bounds against all products up to a length, in floating point."""
        random = numpy.random.default_rng(7)
        for trial in range(30):
            n, k = 1 + trial % 4, 1 + trial % 3
            family = random.integers(-4, 5, size=(k, n, n))
            file = os.path.join(self.directory, "m.json")
            with open(file, "w", encoding="utf-8") as f:
                json.dump(family.tolist(), f)
            jsr = self.twoscale_json("regularity", "--matrices", file)["jsr"]
            low, high = float(Fraction(jsr["lower"])), float(Fraction(jsr["upper"]))
            products = [numpy.eye(n)]
            for length in range(1, {1: 12, 2: 9, 3: 6}[k] + 1):
                products = [b @ p for p in products for b in family.astype(float)]
                below = max(numpy.abs(numpy.linalg.eigvals(p)).max() for p in products) ** (1 / length)
                above = max(numpy.linalg.norm(p, 2) for p in products) ** (1 / length)
                with self.subTest(family=family.tolist(), length=length):
                    self.assertLessEqual(below, high * (1 + 1e-6) + 1e-6 ** (1 / n))
                    self.assertGreaterEqual(above, low * (1 - 1e-9))


if __name__ == "__main__":
    unittest.main()
