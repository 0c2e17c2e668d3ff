// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `nonnegative-symbol`: the joint spectral radius as a spectral radius.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/radius.hpp"
#include "twoscale/check/remainder.hpp"
#include "twoscale/check/transition.hpp"

namespace twoscale::check {
namespace {

/// g_0, ..., g_h for g(z) = c(z) c(1/z), h the degree of c.
std::vector<Integer> autocorrelation(const Coefficients& c, Meter& meter) {
  std::vector<Integer> g(c.list.size());
  for (std::size_t k = 0; k < g.size(); ++k) {
    for (std::size_t i = 0; i + k < g.size(); ++i) g[k] += meter.multiply(c.list[i], c.list[i + k]);
  }
  return g;
}

}  // namespace

Finding check_nonnegative_symbol(const Context& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const long order = fields.take_integer("order", 0, limits::order);
  const std::string& of = fields.take_string("of");
  if (of != "remainder" && of != "autocorrelation") {
    throw Malformed(fields.path("of") + ": \"remainder\" or \"autocorrelation\" is expected");
  }
  Fields object(fields.take("radius"), fields.path("radius"));
  const Radius radius = read_radius(object, meter);
  object.done();

  const bool itself = of == "remainder";
  const Coefficients c = exact_remainder(context, order);
  const std::vector<Integer> g = itself ? centred(c.list) : autocorrelation(c, meter);
  if (itself && zeros_between(odd_part(cosine_sum(g, meter), meter), {-1, 1}, {1, 1}, meter) != 0) {
    throw Refused("the symbol of the remainder changes its sign");  // at z = 1 it is m > 0
  }
  const Integer scale = itself ? c.scale : meter.multiply(c.scale, c.scale);
  const Matrix matrix = transition(g, scale, context.certificate.arity, meter);
  std::vector<Integer> unit(matrix.size);
  unit[0] = 1;
  const Dense mu = minimal_polynomial(matrix, std::move(unit), meter);
  if (!quotient(mu, radius.polynomial, meter)) {
    throw Refused("the polynomial of the radius does not divide the minimal polynomial of e_0");
  }
  if (zeros_from(mu, radius.low, meter) != 1) throw Refused("the radius is not the largest zero");

  const std::string n = std::to_string(order), log = "log_" + std::to_string(context.certificate.arity);
  if (itself) {
    context.radius.list.push_back(radius.high);
    return {"of the remainder of order " + n + ": rho = " + radius.text,
            "the symbol is non-negative, rho the largest zero of a minimal polynomial of degree " +
                std::to_string(mu.size() - 1) + "; Hoelder exponent of the limits >= " + n + " - " + log +
                "(rho) if this is positive, = if the integer shifts are stable",
            {"nonnegative-symbol", "sturm"}};
  }
  return {"of the autocorrelation of the remainder of order " + n + ": rho = " + radius.text,
          "rho is the largest zero of a minimal polynomial of degree " + std::to_string(mu.size() - 1) +
              "; Sobolev exponent of the basic limit function >= " + n + " - " + log + "(rho/" +
              std::to_string(context.certificate.arity) + ")/2, = if its integer shifts are stable",
          {"nonnegative-symbol", "sturm"}};
}

}  // namespace twoscale::check
