# SPDX-License-Identifier: GPL-3.0-or-later
"""`spectrum` and `plot spectrum` from outside: the document of the contract, values of parameters, refusals."""

import os
import tempfile
import unittest
from fractions import Fraction

from support import ProgramTest, run


class Spectrum(ProgramTest):
    def document(self, *arguments):
        d = self.twoscale_json("spectrum", *arguments)
        self.assertEqual((d["format"], d["version"]), ("twoscale/spectrum", 1))
        n = len(d["matrix"])
        self.assertTrue(all(len(row) == n for row in d["matrix"]))
        for e in d["eigenvalues"]:
            self.assertLessEqual({"exact", "multiplicity", "geometric", "decimal", "left", "right"}, set(e))
            self.assertEqual({len(e["left"]), len(e["right"])}, {e["geometric"]})
            self.assertEqual({len(v) for v in e["left"] + e["right"]}, {n})
        return d

    def test_the_document_of_the_contract(self):
        d = self.document("dd:l=2")
        self.assertEqual(d["scheme"], "dd:l=2")
        self.assertEqual(d["lowest"], -3)
        self.assertEqual(d["matrix"][0], ["-1/16", "9/16", "9/16", "-1/16", "0", "0", "0"])
        factors = {f: m for f, m in d["characteristic_polynomial"]["factors"]}
        self.assertEqual(factors, {"x - 1": 1, "x - 1/2": 1, "x - 1/4": 2, "x - 1/8": 1, "x + 1/16": 2})
        self.assertEqual([(e["exact"], e["multiplicity"], e["geometric"], e["decimal"]) for e in d["eigenvalues"]],
                         [("1", 1, 1, "1"), ("1/2", 1, 1, "0.5"), ("1/4", 2, 1, "0.25"), ("1/8", 1, 1, "0.125"),
                          ("-1/16", 2, 2, "-0.0625")])
        value, first = d["limit_stencils"][:2]
        self.assertEqual((value["derivative"], value["lowest"], value["coefficients"]), (0, 0, ["1"]))
        self.assertEqual((first["derivative"], first["lowest"], first["coefficients"]),
                         (1, -2, ["1/12", "-2/3", "0", "2/3", "-1/12"]))
        self.assertEqual((d["necessary"]["verdict"], d["necessary"]["continuity"]), ("decided", 1))
        self.assertIn("1/4", d["necessary"]["obstruction"])

    def test_the_eigenvectors_are_eigenvectors(self):
        for scheme in ("dd:l=2", "dd:l=3", "bspline:n=2", "bspline:n=4,arity=3"):
            d = self.document(scheme)
            a = [[Fraction(x) for x in row] for row in d["matrix"]]
            n = len(a)
            for e in d["eigenvalues"]:
                value = Fraction(e["exact"])
                for v in e["right"]:
                    v = [Fraction(x) for x in v]
                    self.assertEqual([sum(a[i][j] * v[j] for j in range(n)) for i in range(n)], [value * x for x in v])
                for v in e["left"]:
                    v = [Fraction(x) for x in v]
                    self.assertEqual([sum(v[i] * a[i][j] for i in range(n)) for j in range(n)], [value * x for x in v])

    def test_algebraic_eigenvalues(self):
        d = self.document('mask:coefficients="1/4,3/4,1,1/2,-1/3,1/7"')
        kinds = [set(e["exact"]) for e in d["eigenvalues"] if isinstance(e["exact"], dict)]
        real, complex_ = {"polynomial", "interval"}, {"polynomial", "real", "imaginary"}
        self.assertEqual(kinds, [real, complex_, complex_, real])
        for e in d["eigenvalues"]:
            if isinstance(e["exact"], dict):
                self.assertEqual(e["modulo"], e["exact"]["polynomial"])
                low, high = map(Fraction, e["exact"].get("interval") or e["exact"]["real"])
                self.assertLess(low, high)
                self.assertLess(high - low, Fraction(1, 10 ** 15))
                decimal = Fraction(e["decimal"].split(" ")[0])
                self.assertLess(abs(decimal - low), Fraction(1, 10 ** 15))

    def test_the_limit_mask_or_values(self):
        limit = self.document("tension4")
        self.assertEqual(limit["matrix"], self.document("dd:l=2")["matrix"])
        self.assertEqual(limit["matrix"], self.document("tension4", "--at", "v=1")["matrix"])
        symbolic = self.document("tension4", "--at", "")
        self.assertIn("v", symbolic["matrix"][0][0])
        self.assertEqual(symbolic["necessary"]["verdict"], "conditional")
        self.assertIsNone(symbolic["eigenvalues"][-1]["decimal"])
        half = self.document("tension4", "--at", "v=0.5")
        self.assertEqual(half["parameters"], {"v": "1/2"})
        self.assertEqual(half["matrix"][0][0], "-1/6")
        self.assertIn("I*sqrt(15)", "".join(e["exact"] for e in half["eigenvalues"]))
        free = self.document('mask:coefficients="-w,0,1/2+w,1,1/2+w,0,-w"')
        self.assertIn("2*w", [e["exact"] for e in free["eigenvalues"]])
        set_ = self.document('mask:coefficients="-w,0,1/2+w,1,1/2+w,0,-w"', "--at", "w=1/16")
        self.assertEqual(set_["eigenvalues"], limit["eigenvalues"])
        two = 'interpolating:space="1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)"'
        text = str(self.document(two, "--at", "v_s=2")["matrix"])
        self.assertIn("v_t", text)
        self.assertNotIn("v_s", text)

    def test_text(self):
        text = self.twoscale("spectrum", "dd:l=3")
        self.assertIn("9/64", text)
        self.assertIn("the conditions for C^2 hold", text)
        self.assertEqual(text, self.twoscale("spectrum", "dd:l=3"))

    def test_refusals(self):
        self.refused("spectrum", "dd:l=2", "--at", "v=1", naming="v")
        self.refused("spectrum", "tension4", "--at", "u=1", naming="u")
        self.refused("spectrum", "tension4", "--at", "v=sqrt(2)", naming="sqrt(2)")
        self.refused("spectrum", "tension4", "--at", "v=w", naming="w")
        self.refused("spectrum", "tension4", "--at", "v=0", naming="v=0")
        self.refused("spectrum", "tension4", "--at", "v=1,v=2", naming="v")
        self.refused("spectrum", "tension4", "--at", "v", naming="v")
        self.refused("spectrum", 'mask:coefficients="1",arity=3,lowest=1', naming="arity")
        self.refused("spectrum", "nonsense", naming="nonsense")
        self.refused("spectrum", naming="scheme")

    def test_plot(self):
        with tempfile.TemporaryDirectory() as directory:
            for suffix, magic in ((".svg", b"<?xml"), (".png", b"\x89PNG"), (".pdf", b"%PDF")):
                file = os.path.join(directory, "s" + suffix)
                self.twoscale("plot", "spectrum", "dd:l=3", "-o", file)
                with open(file, "rb") as f:
                    self.assertTrue(f.read().startswith(magic))
            file = os.path.join(directory, "none.svg")
            self.refused("plot", "spectrum", "tension4", "--at", "", "-o", file, naming="tension4")
            self.refused("plot", "spectrum", "tension4", "--v0", "1", "-o", file, naming="--v0")
            self.assertFalse(os.path.exists(file))
            self.assertEqual(run("twoscale", "plot", "spectrum", "tension4", "--at", "v=2", "-o", file).returncode, 0)


if __name__ == "__main__":
    unittest.main()
