// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws.hpp"

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace twoscale {

static void showValue(const Rational& q, std::ostream& out) { out << q.to_string(); }
static void showValue(const Polynomial& p, std::ostream& out) { out << p.to_string(); }
static void showValue(const RationalFunction& f, std::ostream& out) { out << f.to_string(); }
static void showValue(const Laurent& a, std::ostream& out) {
  for (long i = a.lowest(); i <= a.highest(); ++i) out << "(" << a.coefficient(i).to_string() << ")*z^" << i << " + ";
  out << "0";
}
static void showValue(const Space& s, std::ostream& out) { out << "{" << s.to_string() << "}"; }

void PrintTo(const Laurent& a, std::ostream* out) { showValue(a, *out); }

}  // namespace twoscale

namespace rc {

/// Integers of [low, high) with equal chances, whatever RapidCheck's current size (which starts at 0 and would keep
/// them small).
template <class T>
Gen<T> uniform(T low, T high) {
  return gen::resize(kNominalSize, gen::inRange<T>(low, high));
}

/// Up to `most` elements.
template <class T>
Gen<std::vector<T>> up_to(size_t most, Gen<T> element) {
  return gen::mapcat(uniform<size_t>(0, most + 1),
                     [element](size_t n) { return gen::container<std::vector<T>>(n, element); });
}

template <>
struct Arbitrary<twoscale::Rational> {
  static Gen<twoscale::Rational> arbitrary() {
    // Small, zero and beyond one machine word.
    return gen::map(gen::tuple(uniform(-12L, 13L), uniform(1L, 13L), uniform(0, 8)),
                    [](const std::tuple<long, long, int>& t) {
                      twoscale::Rational q(std::get<0>(t), std::get<1>(t));
                      if (std::get<2>(t) == 0) q = q * twoscale::Rational(10).pow(40) + twoscale::Rational(1, 7);
                      return q;
                    });
  }
};

template <>
struct Arbitrary<twoscale::Polynomial> {
  static Gen<twoscale::Polynomial> arbitrary() {
    // Up to five terms in none to three of u, v, w; exponents up to 3. A term is {coefficient, e_u, e_v, e_w}.
    const auto term = gen::tuple(uniform(-6L, 7L), uniform(0U, 4U), uniform(0U, 4U), uniform(0U, 4U));
    return gen::mapcat(uniform(0U, 8U), [term](unsigned used) {
      return gen::map(up_to<std::tuple<long, unsigned, unsigned, unsigned>>(5, term),
                      [used](const std::vector<std::tuple<long, unsigned, unsigned, unsigned>>& terms) {
                        using twoscale::Polynomial;
                        Polynomial p;
                        for (const auto& [c, a, b, d] : terms) {
                          Polynomial t = c;
                          if ((used & 1U) != 0) t *= Polynomial::variable("u").pow(a);
                          if ((used & 2U) != 0) t *= Polynomial::variable("v").pow(b);
                          if ((used & 4U) != 0) t *= Polynomial::variable("w").pow(d);
                          p += t;
                        }
                        return p;
                      });
    });
  }
};

template <>
struct Arbitrary<twoscale::RationalFunction> {
  static Gen<twoscale::RationalFunction> arbitrary() {
    return gen::map(gen::pair(gen::arbitrary<twoscale::Polynomial>(), gen::arbitrary<twoscale::Polynomial>()),
                    [](const std::pair<twoscale::Polynomial, twoscale::Polynomial>& p) {
                      return twoscale::RationalFunction::fraction(
                          p.first, p.second.is_zero() ? twoscale::Polynomial(3) : p.second);
                    });
  }
};

/// Up to six coefficients in one variable, lowest index -4..4.
template <>
struct Arbitrary<twoscale::Laurent> {
  static Gen<twoscale::Laurent> arbitrary() {
    const auto coefficient = gen::map(
        gen::tuple(uniform(-5L, 6L), uniform(-3L, 4L), uniform(0L, 3L)), [](const std::tuple<long, long, long>& t) {
          using twoscale::Polynomial;
          const Polynomial v = Polynomial::variable("v");
          return twoscale::RationalFunction::fraction(Polynomial(std::get<0>(t)) + Polynomial(std::get<1>(t)) * v,
                                                      v + Polynomial(std::get<2>(t)));
        });
    return gen::map(gen::pair(uniform(-4L, 5L), up_to<twoscale::RationalFunction>(6, coefficient)),
                    [](const std::pair<long, std::vector<twoscale::RationalFunction>>& p) {
                      return twoscale::Laurent(p.first, p.second);
                    });
  }
};

/// Spaces with up to two named frequencies, multiples 1..4 (lacunary ones too), orders 1..2 and 0..4 powers of x;
/// dimension 1..10.
template <>
struct Arbitrary<twoscale::Space> {
  static Gen<twoscale::Space> arbitrary() {
    const auto exponential = gen::tuple(gen::element<std::string>("s", "t"), uniform(1, 5), uniform(1U, 3U));
    return gen::suchThat(
        gen::map(gen::pair(uniform(0U, 5U), up_to<std::tuple<std::string, int, unsigned>>(4, exponential)),
                 [](const std::pair<unsigned, std::vector<std::tuple<std::string, int, unsigned>>>& p) {
                   std::string text;
                   const auto add = [&](const std::string& item) { text += (text.empty() ? "" : ", ") + item; };
                   for (unsigned r = 0; r < p.first; ++r) add("x^" + std::to_string(r));
                   std::vector<std::pair<std::string, int>> seen;
                   unsigned dimension = p.first;
                   for (const auto& [name, multiple, order] : p.second) {
                     if (std::find(seen.begin(), seen.end(), std::pair(name, multiple)) != seen.end()) continue;
                     if (dimension + 2 * order > 10) continue;
                     seen.emplace_back(name, multiple);
                     dimension += 2 * order;
                     for (unsigned r = 0; r < order; ++r)
                       for (const char* sign : {"", "-"})
                         add("x^" + std::to_string(r) + "*exp(" + sign + std::to_string(multiple) + "*" + name + "*x)");
                   }
                   return text.empty() ? twoscale::Space() : twoscale::Space::parse(text);
                 }),
        [](const twoscale::Space& s) { return s.dimension() > 0; });
  }
};

}  // namespace rc

namespace twoscale {

template <>
Rational draw<Rational>() {
  return *rc::gen::arbitrary<Rational>();
}
template <>
Polynomial draw<Polynomial>() {
  return *rc::gen::arbitrary<Polynomial>();
}
template <>
RationalFunction draw<RationalFunction>() {
  return *rc::gen::arbitrary<RationalFunction>();
}
template <>
Laurent draw<Laurent>() {
  return *rc::gen::arbitrary<Laurent>();
}
template <>
Space draw<Space>() {
  return *rc::gen::arbitrary<Space>();
}

namespace laws {

namespace {

[[noreturn]] void end_round(rc::detail::CaseResult::Type type, const char* text, const char* file, int line) {
  throw rc::detail::CaseResult(type, std::string(file) + ":" + std::to_string(line) + ": " + text);
}

}  // namespace

long uniform(long low, long high) { return *rc::uniform(low, high); }

void run(const std::function<void()>& law) { rc::detail::checkGTest(law); }

void require(bool holds, const char* text, const char* file, int line) {
  if (!holds) end_round(rc::detail::CaseResult::Type::Failure, text, file, line);
}

void given(bool holds, const char* text, const char* file, int line) {
  if (!holds) end_round(rc::detail::CaseResult::Type::Discard, text, file, line);
}

void tag(const std::string& text) { RC_TAG(text); }

}  // namespace laws

}  // namespace twoscale
