# SPDX-License-Identifier: GPL-3.0-or-later
"""twoscale-check loads no computer algebra."""

import os
import subprocess
import unittest

ALGEBRA = ("ginac", "cln", "flint", "arb", "gmp", "mpfr")


class Links(unittest.TestCase):
    def test_check_loads_no_algebra(self):
        listing = subprocess.run(["ldd", os.environ["TWOSCALE_CHECK"]], text=True, capture_output=True, check=True).stdout
        loaded = [os.path.basename(line.split()[0]) for line in listing.splitlines() if line.split()]
        self.assertTrue(loaded, listing)
        self.assertEqual([l for l in loaded if any(l.startswith("lib" + a) for a in ALGEBRA)], [])


if __name__ == "__main__":
    unittest.main()
