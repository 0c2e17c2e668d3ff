# SPDX-License-Identifier: GPL-3.0-or-later
"""Quasi-splines of random Lambda and Lambda° against PARI/GP, exactly.

The independent construction is the linear system of the definitions for all coefficients of the mask, without symmetry,
without beta, without x = z + 1/z: with Y = exp(theta/2^{k+2}) an indeterminate for each name of a frequency and z = Y^{-2n},
  sum_i i^r a_i (-z)^i = 0            for every function x^r e^{n theta x} of Lambda,
  sum_i (i - p)^r a_i z^{i-p} = 2 [r = 0]   for every one of Lambda°, p = 0 or 1/2.
The mask that `derive` prints must satisfy it, identically in Y for one name and at rational points for two, and the system
must have full rank: no other mask of this support does.
"""

import random
import re
import unittest

from support import ProgramTest, pari, to_pari


POINTS = [("3/2", "7/5"), ("2", "-5/3"), ("1/3", "4"), ("9/7", "11/2")]


def items(order, exponentials):
    """order powers of x, {(name, n): multiplicity}."""
    power = lambda r: "1" if r == 0 else f"x^{r}"
    listed = [power(r) for r in range(order)]
    listed += [f"{power(r)}*exp({sign}{n}*{name}*x)" for (name, n), many in sorted(exponentials.items())
               for r in range(many) for sign in ("", "-")]
    return ", ".join(listed)


def functions(order, exponentials):
    """(name, n, r), n with its sign; name "" for powers of x."""
    return ([("", 0, r) for r in range(order)] +
            [(name, sign * n, r) for (name, n), many in sorted(exponentials.items()) for r in range(many)
             for sign in (1, -1)])


def random_case(rng):
    while True:
        order = rng.randint(0, 5)
        exponentials = {}
        for _ in range(rng.randint(0, 3)):
            exponentials[(rng.choice("st"), rng.randint(1, 3))] = rng.choice((1, 1, 2, 3))
        dimension = order + 2 * sum(exponentials.values())
        part = {key: rng.randint(0, many) for key, many in exponentials.items()}
        part = {key: many for key, many in part.items() if many > 0}
        low = rng.randint(0, order)
        if low % 2 == 1 and low < order:
            low += 1  # x^{2r+1} comes with x^{2r}
        conditions = (low + 1) // 2 + sum(part.values())
        if 1 <= dimension <= 9 and 1 <= conditions <= 4:
            return order, exponentials, low, part


class QuasiSplines(ProgramTest):
    def code(self, order, exponentials, low, part, error="0"):
        """PARI's verdict on the mask, its first coefficient changed by `error`."""
        document = self.twoscale_json("derive", f'quasi-spline:space="{items(order, exponentials)}",'
                                                f'reproduce="{items(low, part)}"')
        mask, lowest = document["mask"]["coefficients"], document["mask"]["lowest"]
        dimension = order + 2 * sum(exponentials.values())
        terms = (low + 1) // 2 + sum(part.values())
        twice_p = dimension % 2
        self.assertEqual(document["p"], "1/2" if twice_p else "0")
        # The support that beta and M allow, whether or not its ends vanish.
        first = -(dimension // 2) - (terms - 1)
        length = dimension + 1 + 2 * (terms - 1)
        padded = ["0"] * (lowest - first) + mask
        padded[0] += f"+({error})"
        padded += ["0"] * (length - len(padded))
        self.assertEqual(len(padded), length)
        level = {}
        for variable, meaning in document["level_variables"].items():
            text = re.fullmatch(r"cosh\((.*)/2\^\(k\+1\)\)", meaning).group(1)
            name = re.search("[st]", text).group(0)
            twice = f"(2*({text.replace(name, '1')}))"
            level[variable] = f"(Y{name}^{twice} + Y{name}^-{twice})/2"
        rows, rhs = [], []
        power = lambda name, n, twice: f"Y{name}^({-n * twice})" if name else "1"  # z^{twice/2}
        for name, n, r in functions(order, exponentials):
            rows.append([f"{(1 if i % 2 == 0 else -1) * i ** r}*{power(name, n, 2 * i)}" for i in range(first, first + length)])
            rhs.append("0")
        for name, n, r in functions(low, part):
            rows.append([f"({2 * i - twice_p}/2)^{r}*{power(name, n, 2 * i - twice_p)}" if r > 0 or 2 * i != twice_p
                         else power(name, n, 0) for i in range(first, first + length)])
            rhs.append("2" if r == 0 else "0")
        system = "[" + "; ".join(", ".join(row) for row in rows) + "]"
        values = "; ".join(f"{variable} = {value}" for variable, value in level.items())
        names = {name for name, _ in exponentials}
        at = POINTS if len(names) == 2 else [(f"'Y{name}", f"'Y{name}") for name in names or "s"]
        return (f"test(Ys, Yt) = my(v, v_s, v_t); {values}; {system}*[{', '.join(map(to_pari, padded))}]~ == "
                f"[{', '.join(rhs)}]~\nrank(Ys, Yt) = matrank({system})\n"
                f"print({' && '.join(f'test({a}, {b})' for a, b in at)}, \" \", rank(3/2, 7/5) == {length})")

    def test_random_spaces(self):
        rng = random.Random(2013)
        cases = []
        while len(cases) < 48:
            case = random_case(rng)
            if case not in cases:
                cases.append(case)
        self.assertTrue(any(len({n for n, _ in e}) == 2 for _, e, _, _ in cases))  # several frequencies
        self.assertTrue(any(max(p.values(), default=0) > 1 for *_, p in cases))  # confluent
        self.assertTrue(any((o + 2 * sum(e.values())) % 2 == 1 and p for o, e, _, p in cases))  # dual, in half the frequency
        printed = pari("\n".join(self.code(*case) for case in cases), timeout=280).splitlines()
        answers = [line for line in printed if "->" not in line]  # gp echoes the definition of a function
        self.assertEqual(len(answers), len(cases))
        for case, answer in zip(cases, answers):
            self.assertEqual(answer, "1 1", case)
        printed = pari("\n".join(self.code(*case, error="1/10^30") for case in cases[:4])).splitlines()
        self.assertEqual([line for line in printed if "->" not in line], ["0 1"] * 4)


if __name__ == "__main__":
    unittest.main()
