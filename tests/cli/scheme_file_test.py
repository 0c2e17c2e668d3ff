# SPDX-License-Identifier: GPL-3.0-or-later
"""Scheme files from outside: the whole life of a scheme that no paper of the catalogue has, and what is refused."""

import json
import os
import re
import tempfile
import unittest
import xml.etree.ElementTree

import support

DOCS = os.path.join(os.environ["TWOSCALE_SOURCE_DIR"], "docs", "scheme-files.md")


def documentation():
    with open(DOCS, encoding="utf-8") as file:
        return file.read()


class SchemeFileTest(support.ProgramTest):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def path(self, name):
        return os.path.join(self.directory, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def example(self):
        return self.write("example.toml", re.search(r"```toml\n(.*?)```", documentation(), re.S).group(1))


class Life(SchemeFileTest):
    """The ternary 3-point scheme of the documentation."""

    def test_show(self):
        j = self.twoscale_json("show", self.example())
        self.assertEqual(j["scheme"], "ternary-example")
        self.assertEqual(j["symbol"], {"lowest": -4, "coefficients": ["b", "0", "(3*b + 1)/3", "-2*(3*b - 1)/3", "1",
                                                                      "-2*(3*b - 1)/3", "(3*b + 1)/3", "0", "b"]})
        self.assertEqual(j["parameter_details"]["b"], {"domain": "(-1/9, 0)", "default": "-1/18"})
        self.assertIn("-1/18 by default", self.twoscale("show", self.example()))

    def test_prove_and_check(self):
        j = self.twoscale_json("prove", self.example(), "--certificate", self.path("proof.json"))
        self.assertEqual([(c["claim"], c["verdict"]) for c in j["claims"]], [("reproduces", "proved")])
        self.assertIn("valid: 1 claim(s)", self.check(self.path("proof.json")))
        self.twoscale("prove", self.example(), "--claim", "reproduces=1,x,x^2", status=1)
        self.twoscale("prove", self.example(), "--claim", "continuity=1", status=3)
        self.twoscale("prove", self.example() + ":b=-1/18", "--claim", "continuity=1", "--certificate",
                      self.path("smooth.json"))
        self.check(self.path("smooth.json"))

    def test_regularity(self):
        j = self.twoscale_json("regularity", self.example(), "--certificate", self.path("r.json"))
        self.assertEqual((j["scheme"], j["continuity"]), ("ternary-example at b=-1/18", 1))
        self.check(self.path("r.json"))
        named = self.twoscale_json("regularity", self.example() + ":b=-1/18")
        self.assertEqual(named["hoelder"], j["hoelder"])
        at = self.twoscale_json("regularity", self.example(), "--at", "b=-1/12")
        self.assertNotEqual(at["hoelder"], j["hoelder"])
        self.refused("regularity", self.example(), "--at", "b=0", naming="(-1/9, 0)")

    def test_table_and_refine(self):
        j = self.twoscale_json("table", self.example(), "--levels", "1")
        self.assertEqual(j["parameters"], {"b": "-1/18"})
        j = self.twoscale_json("table", self.example(), "--at", "b=-sqrt(2)/20", "--levels", "1", "--digits", "30")
        self.assertEqual(j["limit"]["coefficients"][0][:17], "-0.0707106781186547524400844362105"[:17])
        self.refused("table", self.example(), "--at", "b=1/3", "--levels", "1", naming="(-1/9, 0)")
        self.refused("table", self.example(), "--at", "c=1/3", "--levels", "1", naming="c")
        points = self.write("points.csv", "x,y\n0,0\n1,0\n1,1\n0,2\n")
        out = self.twoscale("refine", self.example(), "--levels", "2", points).splitlines()
        self.assertEqual(len(out), 1 + 9 * 4)
        self.assertEqual(out[1::9], ["0,0", "1,0", "1,1", "0,2"])  # interpolatory

    def test_report(self):
        out = self.twoscale("report", self.example(), "-o", self.path("page"))
        self.assertIn("certificates valid", out)
        page = self.read("page/index.html")
        for part in ("definition", "parameters", "claims", "smoothness", "spectrum", "masks", "pictures"):
            self.assertIn(f'<section id="{part}">', page)
        self.assertNotRegex(page, r'(src|href)="https?:')
        xml.etree.ElementTree.fromstring(page.replace("<!DOCTYPE html>\n", ""))
        j = json.loads(self.read("page/report.json"))
        self.assertEqual(j["smoothness"]["continuity"], 1)
        for name in os.listdir(self.path("page/certificates")):
            self.check(self.path("page/certificates/" + name))
        self.assertIn("sweep-curve.svg", os.listdir(self.path("page/figures")))
        before = page
        self.twoscale("report", self.example(), "-o", self.path("page"))
        self.assertEqual(self.read("page/index.html"), before)


class New(SchemeFileTest):
    def test_template_works_as_it_stands(self):
        file = self.path("mine.toml")
        self.assertEqual(self.twoscale("new", "mine", "-o", file), "")
        self.assertEqual(self.read("mine.toml"), self.twoscale("new", "mine"))
        self.twoscale("prove", file, "--certificate", self.path("p.json"))
        self.check(self.path("p.json"))
        self.assertIn("C^1", self.twoscale("regularity", file))
        self.twoscale("table", file, "--levels", "1")
        self.twoscale("refine", file, "--levels", "1", self.write("p.csv", "0,0\n1,0\n0,1\n"))

    def test_never_overwrites(self):
        file = self.write("there.toml", "precious")
        self.refused("new", "mine", "-o", file, naming="there.toml")
        self.assertEqual(self.read("there.toml"), "precious")
        self.refused("new", "no name", naming="no name")

    def test_documentation_has_the_keys_of_the_template(self):
        rows = re.findall(r"^\| (?:`\S+` )?\| `(\w+)` \| ([^|]+) \| (required)?", documentation(), re.M)
        documented = [(key, kind.strip(), bool(required)) for key, kind, required in rows]
        comments = re.findall(r"^# (\w+): (.*?)(?:, (required))?\. ", self.twoscale("new", "mine"), re.M)
        self.assertEqual(sorted(documented), sorted((k, kind, bool(r)) for k, kind, r in comments))


class Levels(SchemeFileTest):
    """Level parameters: a frequency in disguise, and another recurrence."""

    CIRCLE = ('[scheme]\nname = "circle"\n[parameters.g]\nscope = "level"\nrelation = "g^2 - 2"\n'
              '[[phase]]\nresidue = 0\nstencil = {"0" = 1}\n'
              '[[phase]]\nresidue = 1\nstencil = {"-1" = "-1/(2*g*(g+2))", "0" = "(g+1)^2/(2*g*(g+2))",'
              ' "1" = "(g+1)^2/(2*g*(g+2))", "2" = "-1/(2*g*(g+2))"}\n'
              '[[claim]]\nclaim = "reproduces"\nsubject = "1, x, exp(t*x), exp(-t*x)"\n')
    # w^k = w^2 + 3w tends to 0 like 3^-k; the four-point scheme with the tension 1/16 + w.
    TENSION = ('[scheme]\nname = "fading"\n[parameters.w]\nscope = "level"\nrelation = "w^2 + 3*w"\ndomain = "(-5/4, 1]"\n'
               'default = "1/2"\n[[phase]]\nresidue = 0\nstencil = {"0" = 1}\n'
               '[[phase]]\nresidue = 1\nstencil = {"-1" = "-1/16 - w", "0" = "9/16 + w", "1" = "9/16 + w", "2" = "-1/16 - w"}\n'
               '[[claim]]\nclaim = "reproduces"\nsubject = "1, x"\n')

    def test_frequency_in_disguise_is_the_scheme_of_the_catalogue(self):
        file = self.write("circle.toml", self.CIRCLE)
        self.twoscale("prove", file, "--certificate", self.path("c.json"))
        self.check(self.path("c.json"))
        mine = self.twoscale_json("table", file, "--at", "g=-4/5", "--levels", "3", "--digits", "40")
        theirs = self.twoscale_json("table", "tension4", "--v0=-2/5", "--levels", "3", "--digits", "40")
        self.assertEqual(mine["levels"], theirs["levels"])
        self.assertEqual(mine["limit"], theirs["limit"])
        self.assertEqual(mine, {**self.twoscale_json("table", file, "--v0=-2/5", "--levels", "3", "--digits", "40"),
                                "parameters": {"g": "-4/5"}})
        self.refused("table", file, "--at", "g=-2", "--levels", "3", naming="(-2, inf)")
        self.refused("table", file, "--levels", "3", naming="t")
        r = self.twoscale_json("regularity", file, "--certificate", self.path("r.json"))
        self.assertTrue(r["applies_to_all_levels"])
        self.check(self.path("r.json"))
        out = self.twoscale("refine", file, "--at", "g=0", "--levels", "2", self.write("p.csv", "1,0\n0,1\n-1,0\n0,-1\n"))
        for line in out.splitlines()[1:] if not out[0].isdigit() else out.splitlines():
            x, y = map(float, line.split(","))
            self.assertAlmostEqual(x * x + y * y, 1, delta=1e-14)

    def test_another_recurrence(self):
        import mpmath
        file = self.write("fading.toml", self.TENSION)
        self.assertIn("r(x) = ", self.twoscale("show", file))
        j = self.twoscale_json("prove", file, "--certificate", self.path("c.json"))
        self.assertIn("whatever the values of v", j["claims"][0]["domain"])
        self.check(self.path("c.json"))
        mpmath.mp.dps = 60
        for start in ("1/2", "1", "-1", "-6/5", "1/1000000"):
            t = self.twoscale_json("table", file, "--at", "w=" + start, "--levels", "12", "--digits", "40")
            w = mpmath.mpf(start.split("/")[0]) / mpmath.mpf((start + "/1").split("/")[1])
            for row in t["levels"]:
                w = (mpmath.sqrt(9 + 4 * w) - 3) / 2
                exact = -mpmath.mpf(1) / 16 - w
                self.assertLess(abs(mpmath.mpf(row["coefficients"][0]) - exact), abs(exact) * mpmath.mpf(10) ** -39)
            self.assertEqual(t["limit"]["coefficients"][0], "-0.0625")
            self.assertGreaterEqual(mpmath.mpf(t["tail"]["bound"]), (3 - mpmath.sqrt(9 + 4 * w)) / -2)
        self.refused("table", file, "--at", "w=-5/4", "--levels", "1", naming="(-5/4, 1]")
        self.refused("table", file, "--t", "1", "--levels", "1", naming="no frequency")

    def test_exponent_of_another_recurrence(self):
        # Two functions are generated for all w, the limit has four sum rules: undecided for the scheme itself.
        file = self.write("fading.toml", self.TENSION)
        r = self.twoscale_json("regularity", file, "--certificate", self.path("r.json"))
        self.assertFalse(r["applies_to_all_levels"])
        self.check(self.path("r.json"))
        # With the limit 1/32 they are as many.
        file = self.write("two.toml", self.TENSION.replace("1/16", "1/32").replace("9/16", "17/32"))
        r = self.twoscale_json("regularity", file, "--certificate", self.path("r.json"))
        self.assertTrue(r["applies_to_all_levels"])
        self.assertEqual(r["continuity"], 1)
        self.assertIn("sum", self.check(self.path("r.json")))
        self.assertIn("w^0 in (-5/4, 1]", self.twoscale("regularity", file))
        self.twoscale("prove", file, "--claim", "continuity=1", "--certificate", self.path("c.json"))
        self.check(self.path("c.json"))
        # The same certificate about a constant is refused: nothing then tends to 1.
        text = self.read("c.json").replace('"sequence"', '"constant"')
        digest = 14695981039346656037
        blank = re.sub(r'"fnv1a64:[0-9a-f]{16}"', '""', text)
        for byte in blank.encode():
            digest = ((digest ^ byte) * 1099511628211) % 2**64
        self.write("constant.json", re.sub(r'"digest": ""', f'"digest": "fnv1a64:{digest:016x}"', blank))
        self.check(self.path("constant.json"), status=1)


class Refused(SchemeFileTest):
    def test_place_and_text_are_named_and_nothing_is_written(self):
        file = self.write("bad.toml", '[scheme]\nname = "a"\nsymbol = "1 + q*z"\n')
        out = self.path("out.json")
        text = self.refused("prove", file, "--certificate", out, naming="bad.toml:3:15: ")
        self.assertIn("q", text)
        self.assertFalse(os.path.exists(out))

    def test_unreadable(self):
        for path in (self.path("none.toml"), self.directory + "/"):
            done = support.run("twoscale", "show", path)
            self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (4, "", 1), done.stderr)

    def test_consumers_refuse_what_they_cannot_use(self):
        block = self.write("h.toml", '[scheme]\nname = "h"\nblock = 2\n'
                           '[[phase]]\nresidue = 0\nstencil = {"0" = [[1, 0], [0, "1/2"]]}\n'
                           '[[phase]]\nresidue = 1\nstencil = {"0" = [["1/2", "1/8"], ["-3/4", "-1/8"]]}\n'
                           '[[claim]]\nclaim = "interpolatory"\n')
        local = self.write("l.toml", '[scheme]\nname = "l"\nshift = 0\n[parameters.d]\nscope = "local"\noffsets = [0, 1]\n'
                           '[[phase]]\nresidue = 0\nstencil = {"0" = 1}\n'
                           '[[phase]]\nresidue = 1\nstencil = {"0" = "d_0/(d_0+d_1)", "1" = "d_1/(d_0+d_1)"}\n')
        points = self.write("p.csv", "0,0\n1,0\n0,1\n")
        for file, word in ((block, "blocks"), (local, "local")):
            self.assertIn("rule", self.twoscale("show", file))
            self.twoscale_json("show", file)
            for command in (["prove", file, "--claim", "sum-rules=2"], ["table", file, "--levels", "1"]):
                self.refused(*command, naming=word)
        self.refused("report", local, "-o", self.path("page"), naming="local")
        self.refused("regularity", local, naming="local")
        self.assertIn("undecided", self.twoscale("regularity", block, status=3))
        self.assertEqual(self.twoscale_json("prove", block)["claims"][0]["verdict"], "proved")
        self.refused("spectrum", local, naming="local")
        self.refused("refine", local, "--levels", "1", points, naming="local")
        self.refused("refine", block, "--levels", "1", points, naming="derivatives")
        # Blocks are read as a value and its derivatives.
        self.assertFalse(self.twoscale_json("spectrum", block)["hermite"]["consistent"])


class Catalogue(SchemeFileTest):
    def test_list_shows_parameters(self):
        text = self.twoscale("list")
        self.assertRegex(text, r"four-point  .*\[Dyn, Gregory and Levin 1987\]\n    w=  .*1/16 by default")

    def test_a_file_may_be_copied_from_the_catalogue(self):
        source = os.path.join(os.environ["TWOSCALE_SOURCE_DIR"], "symbolic", "schemes", "six-point.toml")
        self.assertEqual(self.twoscale("show", source), self.twoscale("show", "six-point"))

    def test_published_ranges(self):
        # Hassan and Dodgson: C^1 for -1/9 < b < 0. Hassan, Ivrissimtzis, Dodgson, Sabin: C^2 for 1/15 < mu < 1/9.
        for scheme, name, interval, l, ends in (("ternary-three-point", "b", "[-1/5,1/10]", 1, ("-1/9", "0")),
                                                ("ternary-four-point", "mu", "[1/20,3/25]", 2, ("1/15", "1/9"))):
            j = self.twoscale_json("regularity", scheme, "--over", f"{name}={interval}", "--certificate",
                                   self.path("o.json"))
            proved = next(c for c in j["continuity"] if c["l"] == l)["proved"]
            self.assertEqual([(p["from"], p["to"]) for p in proved], [ends], scheme)
            self.check(self.path("o.json"))


if __name__ == "__main__":
    unittest.main()
