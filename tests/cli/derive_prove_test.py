# SPDX-License-Identifier: GPL-3.0-or-later
"""`list`, `show`, `derive`, `prove`, `check` from outside: documents, exit statuses, refusals."""

import json
import os
import tempfile
import unittest

from support import ProgramTest, run

TWO = "1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)"


class List(ProgramTest):
    def test_every_id_of_the_contract_that_exists_has_its_keys(self):
        document = self.twoscale_json("list")
        entries = {e["id"]: {k["name"] for k in e["keys"]} for e in document["entries"]}
        self.assertLessEqual({"space", "family", "l"}, entries["interpolating"])
        self.assertLessEqual({"coefficients", "lowest", "arity"}, entries["mask"])
        self.assertLessEqual({"bspline", "exponential-bspline", "mixed", "harmonic", "resonant", "dd", "tension4"}, set(entries))
        for entry in document["entries"]:
            for example in entry["examples"]:
                self.assertEqual(self.twoscale_json("show", example)["format"], "twoscale/scheme")


class Show(ProgramTest):
    def test_dubuc_deslauriers(self):
        document = self.twoscale_json("show", "dd:l=2")
        self.assertEqual(document["symbol"], {"lowest": -3, "coefficients": ["-1/16", "0", "9/16", "1", "9/16", "0", "-1/16"]})
        self.assertEqual(document["support"], [-3, 3])
        self.assertEqual(document["p"], "0")
        self.assertEqual(document["factorisation"]["smoothing_factors"], 4)

    def test_a_dual_mask_says_its_shift(self):
        self.assertEqual(self.twoscale_json("show", "bspline:n=2")["p"], "1/2")
        self.assertIn("p = 1/2", self.twoscale("show", "bspline:n=2"))

    def test_names_with_and_without_quotes_are_the_same(self):
        plain = self.twoscale("show", "exponential-bspline:space=1,x,exp(t*x),exp(-t*x)")
        self.assertEqual(plain, self.twoscale("show", 'exponential-bspline:space="1,x,exp(t*x),exp(-t*x)"'))
        self.assertEqual(plain, self.twoscale("show", 'exponential-bspline:arity=2,space="exp(-t*x),x,1,exp(t*x)"'))


class Derive(ProgramTest):
    def test_the_document_of_the_contract(self):
        d = self.twoscale_json("derive", "--space", "1,x,exp(t*x),exp(-t*x)")
        self.assertEqual((d["format"], d["version"]), ("twoscale/derivation", 1))
        self.assertEqual(d["space"], ["1", "x", "exp(t*x)", "exp(-t*x)"])
        self.assertEqual(d["level_variables"], {"v": "cosh(t/2^(k+1))"})
        self.assertEqual(d["sigma"]["lowest"], -2)
        self.assertEqual(d["omega"]["lowest"], -1)
        self.assertEqual(d["zeta"]["lowest"], -3)
        self.assertEqual(d["system"]["basis"], "newton")
        self.assertEqual(d["system"]["nodes"], ["2", "2*v"])
        self.assertIs(d["system"]["hessenberg"], True)
        self.assertEqual(d["singular_v0"], [])

    def test_singular_values_ascend_with_their_levels(self):
        d = self.twoscale_json("derive", "interpolating:family=harmonic,l=4")
        values = [float(s["decimal"]) for s in d["singular_v0"]]
        self.assertEqual(values, sorted(values))
        self.assertIn({"exact": "cos(4*pi/5)", "decimal": "-0.80901699437494742", "level": 1}, d["singular_v0"])
        self.assertIs(d["folded"]["hessenberg"], False)

    def test_the_lacunary_space_of_the_astroid(self):
        space = "1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)"
        d = self.twoscale_json("derive", "--space", space)
        self.assertEqual([(s["exact"], s["level"]) for s in d["singular_v0"]], [("-1/2", 0), ("-1/2", 1), ("0", 0), ("1/2", 0)])
        self.assertIn("cannot start from N = 3 4 6 points", self.twoscale("derive", "--space", space))
        self.assertIn("cannot start from N = 3 4 5 6 points", self.twoscale("derive", "interpolating:family=harmonic,l=4"))

    def test_several_frequencies(self):
        d = self.twoscale_json("derive", "--space", TWO)
        self.assertEqual(d["level_variables"], {"v_s": "cosh(s/2^(k+1))", "v_t": "cosh(t/2^(k+1))"})
        self.assertEqual(d["singular"], [])
        d = self.twoscale_json("derive", "--space", "1,x,cosh(s*x),sinh(s*x),cos(t*x),sin(t*x),cos(2*t*x),sin(2*t*x)")
        self.assertEqual(d["level_variables"]["v_t"], "cos(t/2^(k+1))")
        self.assertIn("v_s + 2*v_t^2 - 1", [s["condition"] for s in d["singular"]])

    def test_rational_multiples_share_the_greatest_common_frequency(self):
        d = self.twoscale_json("derive", "--space", "exp(t*x/2),exp(-t*x/2),exp(t*x/3),exp(-t*x/3)")
        self.assertEqual(d["level_variables"], {"v": "cosh(t/6/2^(k+1))"})

    def test_odd_order_is_dual_and_has_no_interpolating_scheme(self):
        d = self.twoscale_json("derive", "--space", "1,x,x^2,exp(t*x),exp(-t*x)")
        self.assertEqual(d["p"], "1/2")
        self.assertIsNone(d["zeta"])

    def test_the_order_of_the_items_does_not_matter(self):
        a = self.twoscale("derive", "--space", "exp(-t*x),x,exp(t*x),1", "--format", "json")
        self.assertEqual(a, self.twoscale("derive", "--space", "1,x,exp(t*x),exp(-t*x)", "--format", "json"))
        self.assertEqual(a, self.twoscale("derive", "--space", "1,x,exp(t*x),exp(-t*x)", "--format", "json"))

    def test_latex_and_markdown(self):
        latex = self.twoscale("derive", "interpolating:family=harmonic,l=3", "--format", "latex")
        self.assertIn(r"\begin{align*}", latex)
        self.assertEqual(latex.count("{"), latex.count("}"))
        self.assertIn("| 5 |", self.twoscale("derive", "interpolating:family=harmonic,l=3", "--format", "md"))

    def test_a_file_and_standard_output_hold_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "d.json")
            self.assertEqual(self.twoscale("derive", "tension4", "--format", "json", "-o", file), "")
            with open(file, encoding="utf-8") as f:
                self.assertEqual(f.read(), self.twoscale("derive", "tension4", "--format", "json", "-o", "-"))
            self.assertEqual(os.listdir(directory), ["d.json"])

    def test_refusals_name_the_piece(self):
        self.refused("derive", "--space", "1,x,exp(t*x)", naming="exp(-t*x)")
        self.refused("derive", "--space", "1,x,x*exp(t*x),x*exp(-t*x)", naming="exp(t*x)")
        self.refused("derive", "--space", "1,x^2", naming="x")
        self.refused("derive", "--space", "1,x,cos(t*x)", naming="sin(t*x)")
        self.refused("derive", "--space", "1,x,x", naming="x")
        self.refused("derive", "--space", "1,x,exp(x^2)", naming="exp(x^2)")
        self.refused("derive", "--space", "1,x,exp(t*x", naming="exp(t*x")
        self.refused("derive", "--space", "", naming="space")
        self.refused("derive", "--space", "1,x,exp(9^9^9*x),exp(-9^9^9*x)", naming="9^9^9")
        self.refused("derive", "nonsense:l=3", naming="nonsense")
        self.refused("derive", "dd:l=three", naming="three")
        self.refused("derive", "dd:k=3", naming="k")
        self.refused("derive", "dd", naming="l")
        self.refused("derive", "dd:l=2", "--format", "yaml", naming="yaml")
        self.refused("derive", naming="scheme")
        self.refused("derive", "mask:coefficients=1,2,1", naming="mask")
        self.refused("derive", "interpolating:space=\"1,x,x^2\"", naming="even dimension")
        self.refused("frobnicate")

    def test_an_unwritable_output_is_status_4(self):
        done = run("twoscale", "derive", "dd:l=2", "-o", "/nonexistent/directory/file.txt")
        self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (4, "", 1))


class Prove(ProgramTest):
    def prove(self, *arguments, status=0):
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "c.json")
            document = self.twoscale_json("prove", *arguments, "--certificate", file, status=status)
            self.assertEqual(document["certificate"], file if os.path.exists(file) else None)
            if os.path.exists(file):
                self.assertIn("valid", self.check(file))
                self.assertIn("valid", self.twoscale("check", file))
            return {c["claim"]: c for c in document["claims"]}

    def test_two_level_variables(self):
        claims = self.prove(f'interpolating:space="{TWO}"')
        self.assertEqual({c["verdict"] for c in claims.values()}, {"proved"})
        self.assertLessEqual({"interpolatory", "symmetric", "generates", "reproduces", "maximal", "sum-rules", "well-defined"}, set(claims))

    def test_all_three_families(self):
        for family in ("mixed", "harmonic", "resonant"):
            for l in (2, 3, 5, 8):
                claims = self.prove(f"interpolating:family={family},l={l}")
                self.assertEqual({c["verdict"] for c in claims.values()}, {"proved"})

    def test_a_refutation_is_status_1_with_a_counterexample(self):
        claims = self.prove("bspline:n=3", "--claim", "reproduces=1,x,x^2", status=1)
        self.assertEqual(claims["reproduces"]["verdict"], "refuted")
        self.assertIn("x^2", claims["reproduces"]["witness"])

    def test_the_first_of_refuted_undecided_proved_counts(self):
        self.prove("dd:l=2", "--claim", "symmetric", "--claim", "sum-rules=9", status=1)
        # One number as frequency: that the identity fails in v does not settle it.
        self.prove("dd:l=2", "--claim", "symmetric", "--claim", "reproduces=cos(pi*x/3),sin(pi*x/3)", status=3)
        self.prove("dd:l=2", "--claim", "reproduces=cos(pi*x/3),sin(pi*x/3)", "--claim", "interpolatory", "--claim",
                   "sum-rules=9", status=1)

    def test_refusals(self):
        self.refused("prove", "dd:l=2", "--claim", "smooth", naming="smooth")
        self.refused("prove", "dd:l=2", "--claim", "reproduces=1,exp(t*x)", naming="exp(-t*x)")
        self.refused("prove", "dd:l=2", "--claim", "sum-rules=-1", naming="-1")
        self.refused("prove")


class Check(ProgramTest):
    def test_statuses(self):
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "c.json")
            self.twoscale("prove", "tension4", "--certificate", file)
            with open(file, encoding="utf-8") as f:
                text = f.read()
            self.check(file)
            other = os.path.join(directory, "m.json")
            for old, new, statuses in (('"lowest": -3', '"lowest": -2', {1, 2}), ("proved", "refuted", {1, 2}), ("{", "", {2}), ("\n", "", {2})):
                with open(other, "w", encoding="utf-8") as f:
                    f.write(text.replace(old, new, 1))
                for command in (("twoscale-check", other), ("twoscale", "check", other)):
                    done = run(*command)
                    self.assertIn(done.returncode, statuses, done.stdout + done.stderr)
                    if done.returncode == 2:
                        self.assertEqual(len(done.stderr.splitlines()), 1)
            self.assertEqual(run("twoscale-check", os.path.join(directory, "absent.json")).returncode, 4)
            self.assertEqual(run("twoscale", "check", os.path.join(directory, "absent.json")).returncode, 4)
            self.assertEqual(json.loads(self.twoscale("check", file, "--format", "json"))["status"], "valid")


if __name__ == "__main__":
    unittest.main()
