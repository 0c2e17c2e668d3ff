// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/filter_table.hpp"

#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

kernels::MaskTable lower_filters(const Scheme& scheme, const FilterBank& bank, const Binding& binding,
                                 const LowerOptions& options) {
  if (scheme.arity != 2) bad_input("a two-channel filter bank needs arity 2", scheme.id);
  kernels::MaskTable table = lower(scheme, binding, options);
  // sqrt(2) is a constant like any other; its name is none that a scheme can have.
  Scheme extended = scheme;
  Binding values = binding;
  const std::string root = "sqrt(2)";
  extended.parameters.push_back({root, Parameter::Scope::constant, std::nullopt});
  values.constants.emplace(root, ExactReal(2).pow(Rational(1, 2)));
  const OrthonormalLayout layout = orthonormal_layout(bank);
  const RationalFunction up = RationalFunction::variable(root);
  const RationalFunction down = up * RationalFunction(Rational(1, 2));
  const std::array<Laurent, 4> scaled = {up * layout.dec_lo, down * layout.dec_hi, down * layout.rec_lo,
                                         up * layout.rec_hi};
  table.filters.resize(table.levels.size() + 1);
  const size_t length = static_cast<size_t>(layout.length);
  double error = kernels::parse_double(table.precision_error).value_or(0);
  for (size_t f = 0; f < 4; ++f) {
    const kernels::MaskTable filter = lower(extended, scaled[f], values, options);
    const auto put = [&](kernels::FilterRow& to, const kernels::MaskRow& from) {
      to.text[f].assign(length, "0");
      to.value[f].assign(length, 0.0);
      std::copy(from.text.begin(), from.text.end(), to.text[f].begin() + from.lowest);
      std::copy(from.value.begin(), from.value.end(), to.value[f].begin() + from.lowest);
    };
    for (size_t k = 0; k < filter.levels.size(); ++k) put(table.filters[k], filter.levels[k]);
    put(table.filters.back(), filter.limit);
    if (const auto e = kernels::parse_double(filter.precision_error); e && *e > error) {
      error = *e;
      table.precision_error = filter.precision_error;
    }
  }
  return table;
}

}  // namespace twoscale::lowering
