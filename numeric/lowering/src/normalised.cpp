// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/normalised.hpp"

#include "twoscale/symbolic/bspline_function.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale::lowering {

namespace {

void scale(Scheme& scheme, const RationalFunction& factor) {
  for (Stencil& phase : scheme.phases)
    for (auto& block : phase.blocks)
      for (RationalFunction& c : block) c = factor * c;
}

}  // namespace

Normalisation parse_normalisation(std::string_view text) {
  if (text == "arity") return Normalisation::arity;
  if (text == "sum1") return Normalisation::sum1;
  if (text == "sqrt2") return Normalisation::sqrt2;
  if (text == "convolution") return Normalisation::convolution;
  bad_input("unknown normalisation (arity, sum1, sqrt2, convolution)", std::string(text));
}

kernels::MaskTable lower_normalised(const Scheme& scheme, Normalisation normalisation, const Binding& binding,
                                    const LowerOptions& options) {
  if (normalisation == Normalisation::arity) return lower(scheme, binding, options);
  Scheme scaled = scheme;
  Binding values = binding;
  std::string printed;
  const std::string m = std::to_string(scheme.arity);
  if (normalisation == Normalisation::sum1) {
    scale(scaled, RationalFunction(Rational(1, scheme.arity)));
    printed = "a^{[k]}_i/" + m;
  } else if (normalisation == Normalisation::sqrt2) {
    // The square root enters as a constant parameter; its name is none that a scheme can have.
    const std::string name = "1/sqrt(" + m + ")";
    scaled.parameters.push_back({name, Parameter::Scope::constant, std::nullopt});
    values.constants.emplace(name, ExactReal(Rational(1, scheme.arity)).pow(Rational(1, 2)));
    scale(scaled, RationalFunction::variable(name));
    printed = "a^{[k]}_i/sqrt(" + m + ")";
  } else {
    if (!scheme.space || !two_scale_residual(*scheme.space, scheme.arity, symbol(scheme)).is_zero())
      bad_input("the normalisation convolution belongs to exponential B-splines, not to", scheme.id);
    const RationalFunction factor = convolution_factor(*scheme.space, scheme.arity);
    scale(scaled, factor);
    printed = "a^{[k]}_i*(" + factor.to_string() + ")";
  }
  kernels::MaskTable table = lower(scaled, values, options);
  table.printed = printed;
  // What lower() says of the cosets belongs to a_i itself; the sum is that of the printed numbers.
  table.normalisation = table.normalisation.substr(0, table.normalisation.find(';'));
  if (normalisation == Normalisation::sqrt2 && symbol(scheme).at_one() == RationalFunction(scheme.arity))
    table.normalisation = "coefficients sum to sqrt(" + m + ")";
  return table;
}

}  // namespace twoscale::lowering
