// SPDX-License-Identifier: 0BSD
// The formulas on knots for double and float: compiled once, here, with all optimisations, and without fused products.
#include "twoscale/kernels/nonuniform.hpp"

namespace twoscale::kernels::detail {

void run_strip(KnotStrip<double>& strip, long from, long to, KnotPolygon<double>& out, std::size_t row) {
  strip.run(from, to, out, row);
}
void run_strip(KnotStrip<float>& strip, long from, long to, KnotPolygon<float>& out, std::size_t row) {
  strip.run(from, to, out, row);
}

}  // namespace twoscale::kernels::detail
