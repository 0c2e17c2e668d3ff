# SPDX-License-Identifier: GPL-3.0-or-later
"""The status matrix of README is what the provers say.

    python3 tests/cli/status_test.py --update      (with TWOSCALE set) rewrites it
"""

import os
import sys
import unittest

from support import ProgramTest, run

ROOT = os.environ.get("TWOSCALE_SOURCE_DIR") or os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
README = os.path.join(ROOT, "README.md")
BEGIN = "<!-- status: made by `twoscale report index --format md` (tests/cli/status_test.py --update) -->\n"
END = "<!-- end of status -->"


def parts():
    """README before the matrix, the matrix, and README after it."""
    with open(README, encoding="utf-8") as file:
        before, rest = file.read().split(BEGIN)
    matrix, after = rest.split(END)
    return before, matrix, after


class Status(ProgramTest):
    def test_readme_says_what_the_provers_say(self):
        matrix = self.twoscale("report", "index", "--format", "md")
        self.assertEqual(parts()[1], matrix, "python3 tests/cli/status_test.py --update")
        # Known answers, so that a matrix in which all is one word is seen.
        rows = {line.split("|")[1].strip(" `"): [c.strip() for c in line.split("|")[2:-1]] for line in matrix.splitlines()}
        self.assertEqual(rows["mixed:n=1"][0], "refuted")
        self.assertEqual(rows["tension4"][0], "proved")
        self.assertEqual(rows["tension4"][-1], "proved: C^1")
        self.assertEqual(rows["nuli4"][1], "–")
        for entry in self.twoscale_json("list")["entries"]:
            self.assertIn(entry["examples"][0], rows)

    def test_refusals(self):
        self.refused("report", "index", "--format", "latex", naming="latex")
        self.refused("report", "index", naming="-o DIR")
        self.refused("report", "romani2009", "--format", "md", naming="md")
        self.refused("report", "four-point", "--format", "latex", naming="four-point")
        self.refused("report", "tension4", "--format", "md", "--v0", "2", naming="tension4")

    def test_text_forms(self):
        text = self.twoscale("report", "tension4", "--format", "md")
        self.assertIn("## Interpolating scheme zeta", text)
        self.assertIn("| reproduces | 1, x, exp(t*x), exp(-t*x) | proved |", text)
        self.assertIn("| -3 | `-w` |", self.twoscale("report", "four-point", "--format", "md"))
        self.assertEqual(self.twoscale("report", "tension4", "--format", "latex"),
                         self.twoscale("derive", "tension4", "--format", "latex"))


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        head, _, tail = parts()
        made = run("twoscale", "report", "index", "--format", "md")
        if made.returncode != 0:
            sys.exit(made.stderr)
        with open(README, "w", encoding="utf-8") as out:
            out.write(head + BEGIN + made.stdout + END + tail)
    else:
        unittest.main()
