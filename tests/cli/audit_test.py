# SPDX-License-Identifier: GPL-3.0-or-later
"""twoscale audit from outside: golden texts (--update writes them), JSON, errata page, --resume, bad input.

    python3 tests/cli/audit_test.py --update      (with TWOSCALE set) rewrites reports/PAPER/audit.txt
"""

import json
import os
import sys
import tempfile
import unittest

from support import ProgramTest

ROOT = os.environ.get("TWOSCALE_SOURCE_DIR") or os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAPERS = ("beccari2007", "hermite2010", "jeong2013", "nuli", "romani2009")
UPDATE = "--update" in sys.argv

ITEM = """[[item]]
equation = "(1)"
statement = "(x + 1)^2 = x^2 + {} x + 1"
decider = "identity"
left = "(x+1)^2"
right = "x^2+{}*x+1"
"""


class Golden(ProgramTest):
    maxDiff = None

    def test_papers(self):
        for paper in PAPERS:
            with self.subTest(paper):
                text = self.twoscale("audit", paper)
                path = os.path.join(ROOT, "reports", paper, "audit.txt")
                if UPDATE:
                    with open(path, "w", encoding="utf-8") as file:
                        file.write(text)
                with open(path, encoding="utf-8") as file:
                    self.assertEqual(text, file.read())


class Outside(ProgramTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = os.path.join(self.folder.name, "mine.toml")

    def write(self, text):
        with open(self.file, "w", encoding="utf-8") as file:
            file.write(text)

    def test_a_coefficient_decides(self):
        for coefficient, verdict in ((2, "holds"), (3, "fails")):
            self.write(ITEM.format(coefficient, coefficient))
            document = json.loads(self.twoscale("audit", self.file, "--format", "json"))
            self.assertEqual(document["format"], "twoscale/audit")
            self.assertEqual(document["version"], 1)
            item = document["items"][0]
            self.assertEqual((item["paper"], item["equation"], item["verdict"]), ("mine", "(1)", verdict))
            self.assertTrue(item["evidence"])

    def test_errata_page(self):
        self.write(ITEM.format(2, 2) + ITEM.format(3, 3) + 'correction = "2 x"\ncorrected = { right = "x^2+2*x+1" }\n')
        page = self.twoscale("audit", self.file, "--format", "md")
        self.assertIn("2 items: 1 hold, 1 corrected", page)
        self.assertIn("Right is: 2 x", page)
        self.assertEqual(page.count("**(1)**"), 1)

    def test_resume_keeps_results_of_unchanged_items(self):
        journal = os.path.join(self.folder.name, "journal")
        self.write(ITEM.format(2, 2) + ITEM.format(3, 3))
        first = self.twoscale("audit", self.file, "--resume", journal, "--threads", 1)
        with open(journal, encoding="utf-8") as file:
            lines = [line for line in file.read().split("\n") if line]
        self.assertEqual(len(lines), 2)
        # A result in the journal is taken from there, a line that is cut short is not.
        with open(journal, "w", encoding="utf-8") as file:
            file.write(lines[0].replace('"holds"', '"fails"') + "\n" + lines[1][:-20])
        second = self.twoscale("audit", self.file, "--resume", journal)
        self.assertIn("2 items: 0 hold, 0 corrected, 2 fail", second)
        self.assertIn("2 items: 1 hold, 0 corrected, 1 fail", first)
        # Another item is decided anew.
        self.write(ITEM.format(4, 4))
        self.assertIn("left - right = -2*x", self.twoscale("audit", self.file, "--resume", journal))

    def test_any_number_of_processes_answers_the_same(self):
        self.write("".join(ITEM.format(i, i) for i in range(40)))
        alone = self.twoscale("audit", self.file, "--threads", 1)
        journal = os.path.join(self.folder.name, "journal")
        for processes in (2, 5, 64):
            self.assertEqual(self.twoscale("audit", self.file, "--threads", processes), alone)
        self.assertEqual(self.twoscale("audit", self.file, "--threads", 3, "--resume", journal), alone)
        with open(journal, encoding="utf-8") as file:
            self.assertEqual(len([line for line in file if line.strip()]), 40)
        self.assertEqual(self.twoscale("audit", self.file, "--threads", 3, "--resume", journal), alone)
        # The first item that cannot be read is named, whichever process meets it.
        broken = [ITEM.format(i, i) for i in range(12)]
        broken[4] = ITEM.format(4, "2**").replace('"(1)"', '"(4)"')
        broken[9] = ITEM.format(9, "2**").replace('"(1)"', '"(9)"')
        self.write("".join(broken))
        for processes in (1, 2, 5):
            self.assertIn("(4)", self.refused("audit", self.file, "--threads", processes))

    def test_bad_input(self):
        self.twoscale("audit", "nothing2001", status=2)
        self.twoscale("audit", os.path.join(self.folder.name, "absent.toml"), status=4)
        self.write(ITEM.format(2, 2).replace("identity", "guess"))
        self.twoscale("audit", self.file, status=2)
        self.write(ITEM.format(2, "2*").replace("2*", "2**"))
        self.twoscale("audit", self.file, status=2)


if __name__ == "__main__":
    unittest.main(argv=[a for a in sys.argv if a != "--update"])
