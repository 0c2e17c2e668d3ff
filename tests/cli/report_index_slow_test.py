# SPDX-License-Identifier: GPL-3.0-or-later
"""The front page of the reports: thumbnails that are there, commands that draw or compute them."""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import unittest

from support import FilesTest, program


class Index(FilesTest):
    def test_every_figure_has_a_thumbnail_and_a_command(self):
        self.twoscale("report", "index", "-o", self.path("all"), "--quiet", timeout=900)
        with open(self.path("all/index.html"), encoding="utf-8") as file:
            page = file.read()
        for link in re.findall(r'(?:src|href)="([^"#]+)', page):
            self.assertTrue(os.path.isfile(self.path("all/" + link)), link)
        with open(self.path("all/report.json"), encoding="utf-8") as file:
            papers = {name: figures for name, figures in json.load(file).items() if self.is_paper(figures)}
        self.assertGreaterEqual(len(papers), 3)
        runs = {(paper, f["command"]) for paper, figures in papers.items() for f in figures if f["command"]}
        self.assertGreater(len(runs), 70)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            problems = [p for p in pool.map(self.problem, runs) if p]
        self.assertEqual(problems, [])

    def problem(self, run):
        """What is wrong with a command of a paper's page; None: nothing."""
        paper, command = run
        words = shlex.split(command)
        done = subprocess.run([program("twoscale"), *words[1:]], cwd=self.path("all/" + paper), text=True,
                              capture_output=True, check=False, timeout=300)
        allowed = (0, 1) if words[1] == "prove" else (0,)  # a refuted claim is an answer
        if words[0] != "twoscale" or done.returncode not in allowed:
            return f"{paper}: {command}: {done.returncode} {done.stderr}"
        if "-o" not in words:  # it computes the numbers of the figure
            return None if done.stdout else f"{paper}: {command}: prints nothing"
        with open(os.path.join(self.path("all"), paper, words[words.index("-o") + 1]), encoding="utf-8") as file:
            text = file.read()
        whole = "</svg>" in text if words[-1].endswith(".svg") else text
        return None if whole else f"{paper}: {command}: writes nothing"

    @staticmethod
    def is_paper(value):
        return isinstance(value, list) and value and "figure" in value[0]


if __name__ == "__main__":
    unittest.main()
