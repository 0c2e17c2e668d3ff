// SPDX-License-Identifier: GPL-3.0-or-later
// The complex roots of an irreducible polynomial over Q, in isolating balls (Arb), and exact comparison of their
// moduli.
#pragma once

#include <acb.h>

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "twoscale/symbolic/rational.hpp"

namespace twoscale::analysis {

// Disjoint balls, one for each root of a squarefree polynomial over Z.
class Balls {
 public:
  explicit Balls(std::size_t n) : n_(n), balls_(_acb_vec_init(static_cast<slong>(n))) {}
  Balls(const Balls& o) : Balls(o.n_) { _acb_vec_set(balls_, o.balls_, static_cast<slong>(n_)); }
  Balls(Balls&& o) noexcept : n_(o.n_), balls_(o.balls_) {
    o.n_ = 0;
    o.balls_ = nullptr;
  }
  Balls& operator=(Balls o) noexcept {
    std::swap(n_, o.n_);
    std::swap(balls_, o.balls_);
    return *this;
  }
  ~Balls() { _acb_vec_clear(balls_, static_cast<slong>(n_)); }
  std::size_t size() const { return n_; }
  acb_ptr operator[](std::size_t i) { return balls_ + i; }
  acb_srcptr operator[](std::size_t i) const { return balls_ + i; }

 private:
  std::size_t n_;
  acb_ptr balls_;
};

class Roots {
 public:
  // Ascending coefficients, monic, irreducible, degree >= 1.
  explicit Roots(std::vector<Rational> polynomial);

  const std::vector<Rational>& polynomial() const { return polynomial_; }
  std::size_t size() const { return polynomial_.size() - 1; }
  bool is_real(std::size_t i) const;
  // Root i keeps its number at every precision. Real ones have imaginary part 0 exactly, come first and ascend;
  // a real part that is 0 is so exactly.
  const Balls& enclose(long bits) const;

  // Correctly rounded; "a + b*I" with both parts so.
  std::string decimal(std::size_t i, long digits) const;
  // Decimals around the real and the imaginary part; the rectangle contains no other root.
  struct Box {
    std::array<Rational, 2> real, imaginary;
  };
  Box isolate(std::size_t i) const;

  // |root|^2 if it is known to be rational (degree 1 and non-real roots of degree 2).
  std::optional<Rational> rational_modulus(std::size_t i) const;
  // A polynomial over Q, monic, with |root|^2 among its roots: of the squares for a real one, of the products of two
  // roots for the others.
  const std::vector<Rational>& modulus_polynomial(std::size_t i) const;

 private:
  std::vector<Rational> polynomial_;
  std::vector<bool> imaginary_;          // real part exactly 0
  mutable std::map<long, Balls> known_;  // by bits
  mutable std::vector<Rational> squares_, products_;
};

struct RootOf {
  const Roots* roots;
  std::size_t index;
};
// |a| against |b|: balls of growing precision, and for equality a common root of the polynomials of |a|^2 and |b|^2.
// nullopt if these have too large a degree.
std::optional<std::strong_ordering> compare_moduli(const RootOf& a, const RootOf& b);
// |a| against r >= 0.
std::optional<std::strong_ordering> compare_modulus(const RootOf& a, const Rational& r);

}  // namespace twoscale::analysis
