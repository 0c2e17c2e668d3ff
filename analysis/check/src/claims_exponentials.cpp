// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claims about exponential polynomials: generates, reproduces.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/exceptions.hpp"
#include "twoscale/check/point.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace twoscale::check {
namespace {

std::string name_of(const Exponential& part, const Certificate& certificate, long power) {
  return "frequency " + text_of(Space{{part.frequency, 1}}, certificate) + ", power " + std::to_string(power);
}

/// cosh(h phi) for v = cosh(phi), as a polynomial in v (h = twice/2 an integer), or cosh(h phi)/cosh(phi/2) (h half an
/// odd integer); cosh(phi/2) > 0 on the domain. Both families satisfy T_{h+1} = 2 v T_h - T_{h-1}.
class Chebyshev {
 public:
  Chebyshev(bool half, Meter& meter) : meter_(meter) {
    list_.push_back({Integer(1)});
    list_.push_back(half ? Dense{Integer(-1), Integer(2)} : Dense{Integer(0), Integer(1)});
  }
  const Dense& at(std::size_t h) {
    while (list_.size() <= h) {
      const Dense& now = list_.back();
      const Dense& before = list_[list_.size() - 2];
      Dense next(now.size() + 1);
      for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] = now[i] << 1;
      for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
      for (const Integer& c : next) meter_.hold(sizeof(Integer) + 8 * words(c)), meter_.spend(20 + words(c));
      list_.push_back(std::move(next));
    }
    return list_[h];
  }

 private:
  Meter& meter_;
  std::vector<Dense> list_;
};

/// z^{-c} times the sum of the numerators times z^i, a polynomial in the level variables (apart from a factor that does
/// not vanish), for a mask symmetric about c = (lowest + highest)/2 and z = E_j^{-n}.
Polynomial symmetric_symbol(const Certificate& certificate, std::size_t j, long n, Meter& meter) {
  const Mask& mask = certificate.mask;
  const long twice = mask.lowest + mask.highest();
  const bool half = (n * twice) % 2 != 0;
  Chebyshev chebyshev(half, meter);
  const std::size_t variable = certificate.level[j];
  Polynomial sum;
  for (long i = mask.lowest; i <= mask.highest(); ++i) {
    const Polynomial& numerator = mask.numerators[static_cast<std::size_t>(i - mask.lowest)];
    if (numerator.empty()) continue;
    const long h = std::labs(n * (2 * i - twice)) / 2;  // half: (2h+1)/2 stands for h
    const Dense& t = chebyshev.at(static_cast<std::size_t>(h));
    for (std::size_t d = 0; d < t.size(); ++d) {
      Monomial shift{};
      shift[variable] = static_cast<int>(d);
      add_scaled(sum, numerator, t[d], shift, meter);
    }
  }
  return sum;
}

/// Shows that a(z) does not vanish on the domain for any frequency of the space, apart from the exceptions.
void require_symbol_nonzero(const Context& context, const Space& space, Exceptions& exceptions) {
  const Certificate& certificate = context.certificate;
  std::set<std::pair<std::size_t, long>> done;  // a(z) = a(1/z) up to a factor for a symmetric mask
  bool denominator_done = false;
  for (const Exponential& part : space) {
    const std::string what = "a(z) for the frequency " + text_of(Space{{part.frequency, 1}}, certificate);
    const auto& n = part.frequency;
    const auto first = std::find_if(n.begin(), n.end(), [](long x) { return x != 0; });
    if (first == n.end()) {
      Polynomial sum;
      for (const Polynomial& numerator : certificate.mask.numerators) add_scaled(sum, numerator, 1, {}, context.meter);
      exceptions.require_no_other_zero(sum, what);
    } else if (context.identities.reproduced(n, 0)) {  // a(z) = m z^e: no zero where the mask is defined
      if (!denominator_done) exceptions.require_no_other_zero(certificate.mask.denominator, "the denominator");
      denominator_done = true;
    } else if (certificate.symmetric && std::all_of(first + 1, n.end(), [](long x) { return x == 0; })) {
      const auto j = static_cast<std::size_t>(first - n.begin());
      if (done.insert({j, std::labs(*first)}).second) {
        exceptions.require_no_other_zero(symmetric_symbol(certificate, j, *first, context.meter), what);
      }
    } else {
      throw Refused(what + ": that it does not vanish cannot be decided (it is no polynomial in the level variables)");
    }
  }
  exceptions.mark_zeros(certificate.mask.denominator);
  exceptions.require_all_used("a(z) or of the denominator");
}

}  // namespace

Finding check_generates(const Context& context, Fields& fields, bool proved) {
  const Certificate& certificate = context.certificate;
  const Space space = read_space(fields.take("space"), certificate, fields.path("space"), false);
  const std::string subject = text_of(space, certificate);
  if (proved) {
    Exceptions exceptions(fields.take("exceptions"), certificate, fields.path("exceptions"), context.meter);
    for (const Exponential& part : space) {
      for (long r = 0; r < part.order; ++r) {
        if (!context.identities.generated(part.frequency, r)) {
          throw Refused("the identity fails: " + name_of(part, certificate, r));
        }
      }
    }
    require_symbol_nonzero(context, space, exceptions);
    return {subject,
            "identity verified; a(z) != 0 wherever the mask is finite, " + exceptions.text(),
            {"generation-stepwise",
             certificate.names.empty() || certificate.single_level() ? "sturm" : "positive-coefficients"}};
  }
  Fields witness(fields.take("witness"), fields.path("witness"));
  Point point(witness.take("at"), certificate, witness.path("at"), context.meter);
  const auto frequency = read_frequency(witness.take("frequency"), certificate, witness.path("frequency"));
  const long power = witness.take_integer("power", 0, limits::order);
  const std::vector<Value>& residues = witness.take_array("residues");
  const std::vector<Value>& values = witness.take_array("values");
  witness.done();
  if (power >= order_in(space, frequency))
    throw Refused("frequency and power of the witness do not occur in the space");
  check_two_sums(context, point, frequency, power, residues, values, fields.path("witness"));
  return {subject,
          "the identity fails at " + point.text() + ", " + name_of({frequency, 1}, certificate, power),
          {"generation-stepwise"}};
}

Finding check_reproduces(const Context& context, Fields& fields, bool proved) {
  const Certificate& certificate = context.certificate;
  const Space space = read_space(fields.take("space"), certificate, fields.path("space"), false);
  const std::string subject = text_of(space, certificate);
  if (proved) {
    const long confluent = fields.take_integer("confluent", 0, limits::order);
    for (const Exponential& part : space) {
      for (long r = 0; r < part.order; ++r) {
        if (!context.identities.reproduced(part.frequency, r)) {
          throw Refused("the identity fails: " + name_of(part, certificate, r));
        }
      }
    }
    if (confluent > 0 && context.identities.limit_mask().denominator.empty()) {
      throw Refused("the denominator vanishes where all level variables are 1");
    }
    for (long r = 0; r < confluent; ++r) {
      if (!context.identities.limit_reproduced(r))
        throw Refused("the limit mask does not reproduce x^" + std::to_string(r));
    }
    std::string evidence = "identity verified";
    if (confluent > 0) {
      evidence += "; the limit mask reproduces polynomials of degree < " + std::to_string(confluent);
    }
    return {subject, evidence, {"reproduction-stepwise"}};
  }
  Fields witness(fields.take("witness"), fields.path("witness"));
  Point point(witness.take("at"), certificate, witness.path("at"), context.meter);
  const auto frequency = read_frequency(witness.take("frequency"), certificate, witness.path("frequency"));
  const long power = witness.take_integer("power", 0, limits::order);
  const long residue = witness.take_integer("residue", 0, certificate.arity - 1);
  const Fraction value = parse_fraction(witness.take_string("value"), witness.path("value"), context.meter);
  witness.done();
  if (power >= order_in(space, frequency))
    throw Refused("frequency and power of the witness do not occur in the space");
  if (!point.sum_is(frequency, power, residue, true, value)) {
    throw Refused("the witness value is not the sum over the residue class " + std::to_string(residue));
  }
  if (value.denominator == 1 && value.numerator == (power == 0 ? 1 : 0)) {
    throw Refused("the witness value is the one of a reproducing mask");
  }
  return {subject,
          "the identity fails at " + point.text() + ", " + name_of({frequency, 1}, certificate, power),
          {"reproduction-stepwise"}};
}

}  // namespace twoscale::check
