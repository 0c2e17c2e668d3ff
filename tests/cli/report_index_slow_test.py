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
            for (paper, command), done in zip(runs, pool.map(self.shell, runs)):
                self.assertEqual(done.returncode, 0, f"{paper}: {command}\n{done.stderr}")
                words = shlex.split(command)
                if "-o" not in words:  # it computes the numbers of the figure
                    self.assertTrue(done.stdout, command)
                    continue
                output = os.path.join(self.path("all"), paper, words[words.index("-o") + 1])
                self.assertTrue(os.path.getsize(output), command)
                if output.endswith(".svg"):
                    with open(output, encoding="utf-8") as file:
                        self.assertTrue("</svg>" in file.read(), command)

    @staticmethod
    def is_paper(value):
        return isinstance(value, list) and value and "figure" in value[0]

    def shell(self, run):
        paper, command = run
        words = shlex.split(command)
        self.assertEqual(words[0], "twoscale")
        return subprocess.run([program("twoscale"), *words[1:]], cwd=self.path("all/" + paper), text=True,
                              capture_output=True, check=False, timeout=300)


if __name__ == "__main__":
    unittest.main()
