# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python tests share: running the two programs, SymPy and PARI/GP readers of the project's expressions.

The programs come from the environment (TWOSCALE, TWOSCALE_CHECK, TWOSCALE_GP), as ctest sets it; a test of a program
that is not there is an error, not a skip.
"""

import json
import os
import re
import subprocess
import tempfile
import unittest


def program(name):
    """Path of `twoscale`, `twoscale-check` or `gp`."""
    variable = {"twoscale": "TWOSCALE", "twoscale-check": "TWOSCALE_CHECK", "gp": "TWOSCALE_GP"}[name]
    path = os.environ.get(variable)
    if not path:
        raise RuntimeError(f"{variable} is not set: run this test through ctest")
    return path


def run(name, *arguments, stdin="", timeout=300, cwd=None):
    """Runs a program; returns a CompletedProcess with text stdout and stderr."""
    return subprocess.run([program(name), *map(str, arguments)], input=stdin, text=True, capture_output=True,
                          timeout=timeout, cwd=cwd, check=False)


def pari(code, timeout=120):
    """Evaluates PARI/GP code, returns what it prints."""
    done = subprocess.run([program("gp"), "-q", "-f", "--default", "parisizemax=1000000000"], input=code + "\n", text=True,
                          capture_output=True, timeout=timeout, check=True)
    if "***" in done.stderr or "***" in done.stdout:
        raise RuntimeError("gp: " + done.stderr + done.stdout)
    return done.stdout.strip()


def to_pari(expression):
    """An expression of the project as PARI/GP text."""
    return re.sub(r"\bpi\b", "Pi", expression)


def to_sympy(expression):
    """An expression of the project as a SymPy expression, numbers kept exact."""
    import sympy
    text = re.sub(r"\d+\.\d+", lambda m: f"Rational('{m.group(0)}')", expression.replace("^", "**"))
    return sympy.sympify(text, rational=True)


class ProgramTest(unittest.TestCase):
    """Assertions on what a program did."""

    def twoscale(self, *arguments, status=0, **options):
        """Runs `twoscale`, expects the exit status, returns stdout."""
        return self._expect("twoscale", arguments, status, options)

    def check(self, *arguments, status=0, **options):
        """Runs `twoscale-check`, expects the exit status, returns stdout."""
        return self._expect("twoscale-check", arguments, status, options)

    def twoscale_json(self, *arguments, status=0, **options):
        """As twoscale, with --format json, parsed."""
        return json.loads(self.twoscale(*arguments, "--format", "json", status=status, **options))

    def refused(self, *arguments, naming="", **options):
        """Exit 2, one line on stderr that names the offending piece, nothing on stdout."""
        done = run("twoscale", *arguments, **options)
        shown = f"twoscale {' '.join(map(str, arguments))}\nstdout: {done.stdout}\nstderr: {done.stderr}"
        self.assertEqual(done.returncode, 2, shown)
        self.assertEqual(done.stdout, "", shown)
        self.assertEqual(len(done.stderr.splitlines()), 1, shown)
        self.assertIn(naming, done.stderr, shown)
        return done.stderr

    def _expect(self, name, arguments, status, options):
        done = run(name, *arguments, **options)
        self.assertEqual(done.returncode, status,
                         f"{name} {' '.join(map(str, arguments))}\nstdout: {done.stdout}\nstderr: {done.stderr}")
        return done.stdout


class FilesTest(ProgramTest):
    """With a directory of its own."""

    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)

    def path(self, name, text=None):
        """The path of a file there, written first if there is a text."""
        path = os.path.join(self.directory.name, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path
