# SPDX-License-Identifier: GPL-3.0-or-later
"""PyWavelets takes the filter banks that `lifting --format python` writes."""

import unittest

from support import ProgramTest

try:
    import numpy
    import pywt
except ImportError:
    pywt = None

BANKS = (("dd:l=1", "--vanishing", "2"), ("tension4", "--vanishing", "2", "--v0", "3"), ("bspline:n=2", "--vanishing", "3"),
         ("bspline:n=3", "--vanishing", "4"), ("mixed:n=1", "--vanishing", "2", "--t", "1"))


@unittest.skipIf(pywt is None, "not installed: python3-pywt")
class PyWavelets(ProgramTest):
    def module(self, *arguments):
        space = {}
        exec(self.twoscale("lifting", *arguments, "--levels", "2", "--format", "python"), space)  # noqa: S102
        return space

    def test_known_filters(self):
        ours = self.module("dd:l=1", "--vanishing", "2")["pywavelets"](0)
        theirs = pywt.Wavelet("bior2.2").filter_bank
        for a, b in zip(ours, theirs):  # high-pass filters are theirs up to the sign
            numpy.testing.assert_allclose(numpy.abs(a), numpy.abs(b), atol=1e-15)

    def test_reconstruction_and_agreement_with_lifting(self):
        random = numpy.random.default_rng(11)
        for bank in BANKS:
            space = self.module(*bank)
            for k in range(4):
                wavelet = pywt.Wavelet("ours", filter_bank=space["pywavelets"](k))
                x = random.standard_normal(64)
                for mode in ("periodization", "symmetric", "zero"):
                    back = pywt.idwt(*pywt.dwt(x, wavelet, mode), wavelet, mode)
                    numpy.testing.assert_allclose(back, x, atol=1e-13)
                low, high = pywt.dwt(x, wavelet, "periodization")
                s, d = space["analysis"](list(x), k)
                for a, b in ((low, numpy.array(s) * 2 ** 0.5), (high, numpy.array(d) / 2 ** 0.5)):
                    self.assertLess(min(abs(numpy.roll(a, n) - b).max() for n in range(len(a))), 1e-13, bank)


if __name__ == "__main__":
    unittest.main()
