# SPDX-License-Identifier: GPL-3.0-or-later
"""Schemes on knots from outside: `stencil`, `spectrum`, `prove`, `show`, `refine`."""

import os
import tempfile
import unittest

from support import ProgramTest


class Nuli(ProgramTest):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def file(self, name, text):
        path = os.path.join(self.directory, name)
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)
        return path

    def test_stencil(self):
        d = self.twoscale_json("stencil", "nuli4", "--at", "d=[1,1/2,3],lambda=1/3")
        self.assertEqual((d["format"], d["version"], d["scheme"], d["lowest"]), ("twoscale/stencil", 1, "nuli4", -1))
        self.assertEqual(d["coefficients"], ["-1/96", "113/224", "49/96", "-1/224"])
        # Edge parameters 0 and 1 are limits, (1, 0) too; 1/2 where none are given; symbols stay.
        d = self.twoscale_json("stencil", "nuli6", "--at", "d=[1,1/2,3,2,1],lambda=[1,0,1/2]")
        self.assertEqual(d["coefficients"], ["0", "-675/1001", "6/5", "9/14", "-27/110", "1/13"])
        d = self.twoscale_json("stencil", "nuli4", "--at", "d=[1,1,1]")
        self.assertEqual(d["coefficients"], ["-1/16", "9/16", "9/16", "-1/16"])
        d = self.twoscale_json("stencil", "nuli4", "--at", "d=[a,a,a],lambda=0")
        self.assertEqual(d["coefficients"], ["0", "3/8", "3/4", "-1/8"])

    def test_stencil_refusals(self):
        self.refused("stencil", "nuli4", "--at", "d=[1,2]", naming="[1,2]")
        self.refused("stencil", "nuli4", "--at", "d=[1,0,2]", naming="d=0")
        self.refused("stencil", "nuli4", "--at", "d=[1,1,2],lambda=3/2", naming="3/2")
        self.refused("stencil", "nuli4", "--at", "d=[1,1,2],lambda=l", naming="l")
        self.refused("stencil", "nuli4", "--at", "lambda=1/2", naming="d")
        self.refused("stencil", "nuli4", "--at", "d=[1,1,1],colour=1", naming="colour")
        self.refused("stencil", "dd:l=2", "--at", "d=[1,1,1]", naming="dd:l=2")

    def test_spectrum_of_a_junction(self):
        d = self.twoscale_json("spectrum", "nuli4", "--at", "alpha=2,lambda=[1/3,1/2]")
        self.assertEqual(d["lowest"], -3)
        self.assertEqual(d["matrix"][2], ["0", "-1/32", "1/2", "9/16", "-1/32", "0", "0"])
        self.assertIn(["x^2 - 7/24*x + 1/64", 1], d["characteristic_polynomial"]["factors"])
        # Symbolic edge parameters: one answer for each side of 1/2.
        d = self.twoscale_json("spectrum", "nuli4", "--at", "lambda=[l,m]")
        self.assertEqual(len(d["branches"]), 3)
        crease = self.twoscale_json("spectrum", "nuli4", "--at", "alpha=3,lambda=[1,0]")
        halves = [e for e in crease["eigenvalues"] if e["exact"] == "1/2"]
        self.assertEqual([(e["multiplicity"], e["geometric"]) for e in halves], [(2, 2)])
        self.refused("spectrum", "nuli4", "--at", "alpha=-1", naming="-1")
        self.refused("spectrum", "nuli4", "--at", "lambda=[1/2,2]", naming="2")
        self.refused("spectrum", "nuli4", "--at", "lambda=1/2", naming="1/2")

    def test_prove(self):
        certificate = os.path.join(self.directory, "c.json")
        d = self.twoscale_json("prove", "nuli4", "--certificate", certificate)
        self.assertEqual([c["verdict"] for c in d["claims"]], ["proved"] * 4)
        self.assertEqual(len(d["claims"][2]["exceptions"]), 1)
        self.assertIn("valid", self.check(certificate))
        with open(certificate, encoding="utf-8") as f:
            text = f.read()
        self.check(self.file("wrong.json", text.replace('"1/2"', '"1/3"', 1)), status=2)
        self.refused("prove", "nuli4", "--claim", "symmetric", naming="symmetric")
        self.refused("prove", "nuli4", "--claim", "reproduces=1,x,exp(t*x),exp(-t*x)", naming="exp(t*x)")

    def test_rule_of_any_order(self):
        for order, scheme, d in ((3, "nuli4", "1,1/2,3"), (4, "nuli6", "1,1/2,3,2,1/5")):
            a, b = (self.twoscale_json("stencil", s, "--at", f"d=[{d}]") for s in (f"nuli:n={order}", scheme))
            self.assertEqual(a["coefficients"], b["coefficients"])
        a, b = (self.twoscale_json("stencil", s, "--at", at)["coefficients"] for s, at in
                (("nuli:n=3,lambda=1/3", "d=[1,1/2,3]"), ("nuli4", "d=[1,1/2,3],lambda=1/3")))
        self.assertEqual(a, b)
        d = self.twoscale_json("stencil", "nuli:n=5", "--at", "d=[1,1,1,1,1,1,1]")
        self.assertEqual(d["lowest"], -3)
        self.assertEqual(d["coefficients"], d["coefficients"][::-1])
        self.assertEqual(self.twoscale_json("spectrum", "nuli:n=5", "--at", "alpha=2")["lowest"], -7)
        data = self.file("n.csv", "x,y\n0,0\n4,1\n4.2,3\n1,4\n")
        for options in ((), ("--reparametrize",), ("--open=linear",)):
            rows = self.twoscale("refine", "nuli:n=5", "--levels", "2", *options, data).split()[1:]
            self.assertEqual(len(rows), 13 if options and options[0].startswith("--open") else 16)
            self.assertEqual(rows[4], "4,1")
        self.refused("refine", "nuli:n=5", "--levels", "1", "--digits", "20", data, naming="nuli:n=5")
        self.refused("refine", "nuli:n=5", "--levels", "1", "--open=space", data, naming="nuli:n=5")
        for wrong in ("nuli", "nuli:n=2", "nuli:n=65", "nuli:n=4,lambda=1"):
            self.refused("show", wrong, naming=wrong.split("=")[-1] if "=" in wrong else "n")

    def test_rule_of_any_order_at_numbers(self):
        """Edge parameters, 0 and 1 too: the general rule has nuli4 and nuli6 as its members."""
        for order, scheme, at in ((3, "nuli4", "d=[1,1/2,3],lambda=0"), (3, "nuli4", "d=[1,1/2,3],lambda=1"),
                                  (4, "nuli6", "d=[1,1/2,3,2,1/5],lambda=[1,0,1/3]"),
                                  (4, "nuli6", "d=[1,1/2,3,2,1/5],lambda=[1/4,2/3,1]")):
            a, b = (self.twoscale_json("stencil", s, "--at", at)["coefficients"] for s in (f"nuli:n={order}", scheme))
            self.assertEqual(a, b)
        for at in ("alpha=2,lambda=[1,0]", "alpha=1/3,lambda=[1/5,3/4]"):
            a, b = (self.twoscale_json("spectrum", s, "--at", at) for s in ("nuli:n=4", "nuli6"))
            self.assertEqual((a["matrix"], a["eigenvalues"]), (b["matrix"], b["eigenvalues"]))
        # On equal knots order 6 is C^2 as far as eigenvalues go, order 8 does not even converge.
        values = [[abs(float(e["decimal"])) for e in
                   self.twoscale_json("spectrum", f"nuli:n={n}", "--at", "alpha=1")["eigenvalues"]] for n in (6, 8)]
        self.assertLess(sorted(values[0])[-4], 0.25)
        self.assertGreater(max(values[1]), 2)
        text = self.twoscale("show", "nuli:n=7")
        self.assertIn("p_{j-5} .. p_{j+6}", text)
        self.assertIn("not written out", text)
        self.assertEqual(self.twoscale_json("show", "nuli:n=7")["pieces"], [])
        self.assertEqual(self.twoscale_json("show", "nuli:n=3")["pieces"][0]["where"], "all lambda = 1/2")
        data = self.file("e.csv", "x,y,lambda,d\n0,0,0.5,1\n4,1,1,2\n4.2,3,0,0.5\n1,4,0.5,1\n")
        rows = self.twoscale("refine", "nuli:n=6", "--levels", "2", data).split()
        self.assertEqual((rows[0], len(rows)), ("x,y,lambda,d", 17))
        self.assertEqual(rows[1::4], ["0,0,0.5,0.25", "4,1,1,0.5", "4.2,3,0,0.125", "1,4,0.5,0.25"])
        a, b = (self.twoscale("refine", s, "--levels", "2", data).split()[1:] for s in ("nuli:n=4", "nuli6"))
        for x, y in zip(a, b):
            for u, v in zip(x.split(","), y.split(",")):
                self.assertAlmostEqual(float(u), float(v), 12)
        exact = self.twoscale("refine", "nuli:n=6", "--levels", "2", "--digits", "25", data).split()
        self.assertEqual(exact[1::4], rows[1::4])
        self.assertEqual([len(r.split(",")) for r in exact], [4] * 17)
        for x, y in zip(exact[1:], rows[1:]):
            for u, v in zip(x.split(","), y.split(",")):
                self.assertAlmostEqual(float(u), float(v), 10)
        self.refused("refine", "nuli:n=6", "--levels", "1", "--digits", "25", "--parametrization", "chordal", data,
                     naming="nuli:n=6")
        self.refused("stencil", "nuli:n=6", "--at", "d=[1,1,1,a,1,1,1,1,1]", naming="a")
        self.refused("stencil", "nuli:n=6", "--at", "d=[1,1,1,1]", naming="[1,1,1,1]")
        self.refused("stencil", "nuli:n=4", "--at", "d=[1,a,1,1,1],lambda=[0,1,1/2]", naming="a")
        self.refused("spectrum", "nuli:n=6", naming="alpha")
        self.refused("prove", "nuli:n=6", naming="nuli:n=6")
        self.refused("stencil", "nuli:n=6,m=1", "--at", "d=[1]", naming="m")
        wrong = self.file("w.csv", "x,y,lambda\n0,0,0.5\n1,0,2\n1,1,0\n")
        self.refused("refine", "nuli:n=6", "--levels", "1", wrong, naming="row 2")

    def test_show(self):
        self.assertIn("lambda_0", self.twoscale("show", "nuli4"))
        d = self.twoscale_json("show", "nuli6")
        self.assertEqual(d["local_parameters"]["lambda"], {"offsets": [-1, 0, 1], "rest": "1/2"})
        self.assertEqual(len(d["pieces"]), 4)

    def test_plot(self):
        """The picture of a curve on knots is that of its refined points; --parametrization and lambda show."""
        columns = "x,y,lambda\n0,0,{0}\n4,0,0.5\n4,3,0.5\n1,3,0.5\n0,2,0.5\n"
        pictures = set()
        for edge, options in (("0.5", []), ("0.125", []), ("0.5", ["--parametrization", "uniform"]),
                              ("0.5", ["--open=linear"])):
            path = self.file("p.csv", columns.format(edge))
            for kind in ("curve", "comb", "curvature"):
                picture = os.path.join(self.directory, "out.svg")
                self.twoscale("plot", kind, "nuli4", *options, path, "-o", picture)
                with open(picture, encoding="utf-8") as file:
                    pictures.add(file.read())
        self.assertEqual(len(pictures), 12)
        self.twoscale("plot", "curve", "nuli:n=5", path, "-o", picture)
        none = os.path.join(self.directory, "none.svg")
        self.refused("plot", "basic", "nuli4", "-o", none, naming="basic")
        self.refused("plot", "curve", "nuli4", "--v0", "1", path, "-o", none, naming="nuli4")
        self.refused("plot", "curve", "tension4", "--v0", "0", "--reparametrize", path, "-o", none, naming="tension4")
        self.assertFalse(os.path.exists(none))

    def test_refine(self):
        data = self.file("p.csv", "x,y,lambda,d,tag\n0,0,0.5,1,0\n4,1,1,0.5,1\n4.2,3,0,2,1\n1,4,0.5,1,0\n")
        rows = self.twoscale("refine", "nuli4", "--levels", "1", data).split()
        self.assertEqual(rows[0], "x,y,lambda,d,tag")
        self.assertEqual(rows[1::2], ["0,0,0.5,0.5,0", "4,1,1,0.25,1", "4.2,3,0,1,1", "1,4,0.5,0.5,0"])
        self.assertEqual(rows[2], "1.9875,-0.0625,0.5,0.5,0")
        for arguments in (("--open=space",), ("--open=linear",), ("--reparametrize",), ("--parametrization", "chordal"),
                          ("--parametrization", "uniform", "--reparametrize")):
            for scheme in ("nuli4", "nuli6", "lagrange4"):
                rows = self.twoscale("refine", scheme, "--levels", "3", *arguments, data).split()[1:]
                self.assertEqual(len(rows), 25 if arguments[0].startswith("--open") else 32)
                self.assertNotIn("nan", " ".join(rows))
        self.refused("refine", "nuli4", "--levels", "1", "--v0", "2", data, naming="nuli4")
        self.refused("refine", "nuli4", "--levels", "1", "--parametrization", "odd", data, naming="odd")
        self.refused("refine", "nuli4", "--levels", "1", "--open=given", data, naming="6")
        self.refused("refine", "dd:l=2", "--levels", "1", "--reparametrize", data, naming="dd:l=2")
        bad = self.file("b.csv", "x,y,lambda\n0,0,0.5\n1,0,2\n1,1,0\n")
        self.refused("refine", "nuli4", "--levels", "1", bad, naming="row 2")
        plain = self.file("q.csv", "x,y\n0,0\n1,0\n1,1\n")
        self.refused("refine", "nuli4", "--levels", "1", "--parametrization", "given", plain, naming="d")


if __name__ == "__main__":
    unittest.main()
