# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs start and say who they are."""

import os
import re
import unittest

from support import ProgramTest


class Version(ProgramTest):
    def test_version(self):
        with open(os.path.join(os.environ["TWOSCALE_SOURCE_DIR"], "CMakeLists.txt"), encoding="utf-8") as file:
            version = re.search(r"project\(twoscale VERSION ([0-9.]+)", file.read()).group(1)
        self.assertIn(version, self.twoscale("--version"))

    def test_help(self):
        self.assertIn("Usage", self.twoscale("--help"))


if __name__ == "__main__":
    unittest.main()
