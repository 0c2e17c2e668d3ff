// SPDX-License-Identifier: GPL-3.0-or-later
// Small mask tables for the tests of the kernels.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "twoscale/kernels/mask_table.hpp"
#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels::testing {

inline MaskRow row(long lowest, std::vector<double> value, std::vector<double> extension = {}) {
  MaskRow out;
  out.lowest = lowest;
  for (const double v : value) out.text.push_back(shortest(v));
  out.value = std::move(value);
  out.extension = std::move(extension);
  return out;
}

inline MaskTable stationary(int arity, long lowest, std::vector<double> value, std::string shift = "0",
                            std::vector<double> extension = {}) {
  MaskTable table;
  table.scheme = "mask";
  table.arity = arity;
  table.shift = std::move(shift);
  table.limit = row(lowest, std::move(value), std::move(extension));
  table.tail_bound = "0";
  return table;
}

/// Dubuc-Deslauriers 4-point; the extension is exact on cubic polynomials.
inline MaskTable four_point() {
  return stationary(2, -3, {-1. / 16, 0, 9. / 16, 1, 9. / 16, 0, -1. / 16}, "0", {4, -6, 4, -1});
}

inline MaskTable cubic_spline() { return stationary(2, -2, {1. / 8, 4. / 8, 6. / 8, 4. / 8, 1. / 8}); }

/// Quadratic B-spline (dual).
inline MaskTable chaikin() { return stationary(2, -1, {.25, .75, .75, .25}, "1/2"); }

/// The 4-point rule that reproduces 1, x, cos(s x), sin(s x): levels 0..levels-1.
inline MaskTable tension(double v0, int levels) {
  MaskTable table = four_point();
  table.scheme = "tension4";
  table.parameters = {{"v0", shortest(v0)}};
  table.level_variables = {{"v", "cosh(t/2^(k+1))"}};
  table.recurrence = "v^{k+1} = sqrt((1+v^k)/2)";
  table.normalisation = "coefficients sum to 2";
  double v = v0;
  for (int k = 0; k < levels; ++k) {
    const double coarse = v;
    v = std::sqrt((1 + v) / 2);
    const double w = 1 / (8 * v * (v + 1));
    // p_{-1} from p_0..p_3: the annihilator (1-z)^2 (1 - 2 c z + z^2), c the coarse level variable.
    table.levels.push_back(
        row(-3, {-w, 0, .5 + w, 1, .5 + w, 0, -w}, {2 + 2 * coarse, -2 - 4 * coarse, 2 + 2 * coarse, -1}));
  }
  table.tail_from = levels;
  table.tail_bound = "1";
  table.precision_error = "1.2e-16";
  return table;
}

}  // namespace twoscale::kernels::testing
