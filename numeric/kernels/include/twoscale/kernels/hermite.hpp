// SPDX-License-Identifier: 0BSD
// The circle-preserving 2-point Hermite scheme of hermite2010 over any number type: angular parameters, derivatives,
// refinement.
//
// Notation
//
//   vertex      f (point), p, r (first and second derivative in t) and the angular parameter sigma, radians. p and r
//   are
//               derivatives in t = (1 + alpha)/2, alpha = tan(sigma/4), and keep that meaning at every level.
//   chart       t has a pole at sigma = 2 pi (mod 4 pi) and period 4 pi. An edge is worked on in a chart: its
//               sigma-interval, shifted by a multiple of 2 pi so that it lies in (-2 pi, 2 pi); with an odd multiple p
//               and r are converted so that the derivatives in sigma stay:
//               f_sigma = p t', f_ss = r t'^2 + p t''/omega, t' = (1+alpha^2)/8, t'' = alpha (1+alpha^2)/16,
//               where omega is w for HermiteRuleTension::c2 (the curve has derivatives w p, w^2 r there), else 1.
//   step        v = tan(sigma_i/8), u = tan(sigma_{i+1}/8); the new vertex is the rational quintic (Definition 4) at
//   the
//               middle in sigma, evaluated as N/D with D = (1+x^2)^2/4, x = 2t - 1: no weight is divided by.
//   tension     printed: u is replaced by v + w (u - v) (§4); the first pole of the data is at w* = min (1-v)/(u-v).
//               c2: the rule of w = 1 between diag(1, 1/w, 1/w^2) and diag(1, w, w^2).
//
// Number types. T needs + - * / and unary -, constructors from int and from nothing, and by argument-dependent lookup
// sqrt(x), sin(x), tan(x), atan2(y, x), and
//   is_less(a, b, what)   whether a < b: every case of the rules below is decided by it. A type that encloses its value
//                         throws HermiteUndecided(what) where it cannot tell (with more precision it can, but for a
//                         tie);
//   estimate(x)           a double near x, for choices that do not matter for the answer;
//   negligible(x, scale)  |x| cannot be told from 0 beside |scale| > 0 in T: where an iteration ends;
//   widened(x, e)         x +- e for a type that encloses, else x.
// double has them here: its decisions are those of rounded numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "twoscale/kernels/error.hpp"

namespace twoscale::kernels {

enum class HermiteRuleTension { printed, c2 };

/// The vertices that measure data: `farthest` from vertex 0, `outermost` from the origin, `apex` the one that spans the
/// largest triangle with vertex 0 and the farthest; the first one where several do. Which of them is taken matters
/// where points are on a circle, or on a line, only nearly.
struct HermiteMeasure {
  std::size_t farthest = 0;
  std::size_t outermost = 0;
  std::size_t apex = 1;
  bool one_point = true;  ///< all vertices are equal
};

/// Component c of vertex j at [j*dim + c], dim = 2 or 3. N needs + - * < and a constructor from int: exact numbers have
/// an exact answer, double that of rounded numbers.
template <class N>
HermiteMeasure hermite_measure(std::span<const N> points, std::size_t dim) {
  const std::size_t n = points.size() / dim;
  const auto side = [&](std::size_t i) {
    std::array<N, 3> d = {N(0), N(0), N(0)};
    for (std::size_t c = 0; c < dim; ++c) d[c] = points[i * dim + c] - points[c];
    return d;
  };
  const auto square = [](const std::array<N, 3>& d) { return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]; };
  HermiteMeasure m;
  N distance(0);
  N norm(0);
  N area(0);
  for (std::size_t i = 0; i < n; ++i) {
    const N own = square(side(i));
    if (distance < own) distance = own, m.farthest = i;
    std::array<N, 3> place = {N(0), N(0), N(0)};
    for (std::size_t c = 0; c < dim; ++c) place[c] = points[i * dim + c];
    const N far = square(place);
    if (norm < far) norm = far, m.outermost = i;
  }
  m.one_point = !(N(0) < distance);
  m.apex = m.farthest == 1 ? 2 : 1;
  if (m.one_point) return m;
  const std::array<N, 3> a = side(m.farthest);
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<N, 3> b = side(i);
    const N own = square({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
    if (area < own) area = own, m.apex = i;
  }
  return m;
}

/// n vertices of `dim` = 2 or 3 components: component c of vertex j at [j*dim + c].
template <class T>
struct HermiteData {
  std::size_t dim = 2;
  std::vector<T> f, p, r;  ///< n*dim each; p and r empty: to be found
  std::vector<T> sigma;    ///< n, or empty: to be found
  bool closed = true;
  std::optional<HermiteMeasure> measure;  ///< of f, found by the caller in exact numbers; else in double

  std::size_t size() const { return dim == 0 ? 0 : f.size() / dim; }
};

/// A case that a number type could not decide; what() completes "cannot decide whether".
struct HermiteUndecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline bool is_less(double a, double b, const char*) { return a < b; }
inline double estimate(double x) { return x; }
inline bool negligible(double x, double scale) { return std::abs(x) <= 1e-17 * std::abs(scale); }
inline double widened(double x, double) { return x; }

namespace hermite_detail {

using std::atan2;
using std::sin;
using std::sqrt;
using std::tan;

constexpr double pi_estimate = 3.141592653589793;

[[noreturn]] inline void refuse(const std::string& message) { throw Error(Error::Kind::bad_input, message); }

/// pi with the precision of `like`.
template <class T>
T pi(const T& like) {
  return atan2(T(0) * (like * like), T(-1));
}

template <class T>
struct Vector {
  std::array<T, 3> c = {T(0), T(0), T(0)};

  friend Vector operator+(const Vector& a, const Vector& b) {
    return {{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2]}};
  }
  friend Vector operator-(const Vector& a, const Vector& b) {
    return {{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
  }
  friend Vector operator*(const T& x, const Vector& a) { return {{x * a.c[0], x * a.c[1], x * a.c[2]}}; }
};

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
}
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {{a.c[1] * b.c[2] - a.c[2] * b.c[1], a.c[2] * b.c[0] - a.c[0] * b.c[2], a.c[0] * b.c[1] - a.c[1] * b.c[0]}};
}
template <class T>
T norm(const Vector<T>& a) {
  return sqrt(dot(a, a));
}
/// 10^-digits.
template <class T>
T tiny(int digits) {
  T x(1);
  for (int i = 0; i < digits; ++i) x = x / T(10);
  return x;
}
/// |a| <= |b|.
template <class T>
bool within(const T& a, const T& b, const char* what) {
  return !is_less(b * b, a * a, what);
}

/// The centre of the circle through three points (S.1); they must not be collinear.
template <class T>
Vector<T> circumcentre(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  const Vector<T> x = cross(a - b, b - c);
  const T bottom = T(2) * dot(x, x);
  const T ab = dot(a - b, a - b);
  const T bc = dot(b - c, b - c);
  const T t1 = bc * dot(a - b, a - c) / bottom;
  const T t3 = ab * dot(c - a, c - b) / bottom;
  return b + t1 * (a - b) + t3 * (c - b);
}

/// Unit eigenvector of the smallest eigenvalue of the symmetric matrix m, by Jacobi rotations. They are exactly
/// orthogonal; what they leave beside the diagonal is added as an error bound where the type encloses. In double: a
/// small multiple of the rounding unit times trace over gap, not bounded here. Refused if the gap is below 1e-12 of the
/// trace.
template <class T>
Vector<T> least_direction(std::array<std::array<T, 3>, 3> m) {
  std::array<std::array<T, 3>, 3> v = {{{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}}};
  const T trace = m[0][0] + m[1][1] + m[2][2];
  for (int sweep = 0; sweep < 64; ++sweep) {
    bool done = true;
    for (std::size_t p = 0; p < 2; ++p)
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (negligible(m[p][q], trace)) continue;
        done = false;
        // Annihilates m[p][q]: tan of the angle is the root of smaller size.
        const T theta = (m[q][q] - m[p][p]) / (T(2) * m[p][q]);
        const T root = sqrt(theta * theta + T(1));
        const T t = estimate(theta) >= 0 ? T(1) / (theta + root) : T(1) / (theta - root);
        const T c = T(1) / sqrt(t * t + T(1));
        const T s = t * c;
        for (std::size_t k = 0; k < 3; ++k) {
          const T kp = m[k][p];
          const T kq = m[k][q];
          m[k][p] = c * kp - s * kq;
          m[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const T pk = m[p][k];
          const T qk = m[q][k];
          m[p][k] = c * pk - s * qk;
          m[q][k] = s * pk + c * qk;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const T kp = v[k][p];
          const T kq = v[k][q];
          v[k][p] = c * kp - s * kq;
          v[k][q] = s * kp + c * kq;
        }
      }
    if (done) break;
  }
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (estimate(m[k][k]) < estimate(m[least][least])) least = k;
  Vector<T> n = {{v[0][least], v[1][least], v[2][least]}};
  n = (T(1) / norm(n)) * n;
  // In the rotated axes m = diag + rest, the diagonal of rest 0, |rest| <= off: the least eigenvalue is not above the
  // least entry, so the component k of its unit eigenvector is at most off over the gap to the entry k, and the vector
  // moves by less than twice the sum of these.
  T square(0);
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t q = 0; q < 3; ++q)
      if (p != q) square = square + m[p][q] * m[p][q];
  T turn(0);
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == least) continue;
    const T gap = m[k][k] - m[least][least];
    if (is_less(gap, tiny<T>(12) * trace, "the points have one plane of least squares"))
      refuse("the points have no plane of least squares: give sigma, p and r");
    turn = turn + T(2) * sqrt(square) / gap;
  }
  for (auto& x : n.c) x = widened(x, turn);
  return n;
}

/// s = tan(sigma/8) (13).
template <class T>
T slope(const T& sigma) {
  return tan(sigma / T(8));
}

/// t' and t'' at an angular parameter.
template <class T>
std::pair<T, T> rates(const T& sigma) {
  const T alpha = tan(sigma / T(4));
  const T square = T(1) + alpha * alpha;
  return {square / T(8), alpha * square / T(16)};
}

}  // namespace hermite_detail

/// What Algorithm 1 finds: sigma ascending; a closed polygon returns to vertex 0 at sigma[0] + period.
template <class T>
struct HermiteAngles {
  std::vector<T> sigma;
  T period = T(0);
  bool circle = false;  ///< the points lie on one circle, and sigma are the angles about its centre
  // The frame: point = centre + X e1 + Y e2 (+ distance from the plane), sigma = atan2(Y, X) + constant where no rule
  // below says otherwise.
  hermite_detail::Vector<T> centre, e1, e2;
};

/// Algorithm 1 (S.1)-(S.5), with these rules where the printed one has no value or an accidental one:
///   orientation  sigma grows along the polygon: the normal is chosen so (the paper asks for counterclockwise data).
///   The
///                axis of sigma = 0 does not depend on the direction: x in the plane, e_y x n (n upwards) in space, x
///                for planes y = const.
///   circle       points on one circle (to 1e-12 of its size): b is its centre, sigma are its angles, however many
///   turns. triples      whose circle is more than 100 times larger than the data count as collinear: q_i = f_i. vertex
///   at b  (closer than 1e-9 of the size): the mean of its neighbours' parameters. same ray     a vertex not beyond the
///   one before goes a turn further: sigma ascends strictly. turns        several turns are mapped to [-pi, pi], an
///   open curve as printed; a closed one so that the closing edge
///                ends at pi.
///   bunches      where a step is less than 1/64 of the mean one, chord lengths mapped to [-pi, pi] take the place of
///                angles.
/// `invariant`: the axis is replaced by the data's own (closed: sigma_0 = -pi; open: the range is centred on 0), so
/// that rigid motions of the points do not change sigma. `measured`: as in HermiteData. Errors: fewer than 3 points,
/// equal neighbours, all points on a line.
template <class T>
HermiteAngles<T> hermite_angles(std::span<const T> points, std::size_t dim, bool closed, bool invariant,
                                const std::optional<HermiteMeasure>& measured = {}) {
  using namespace hermite_detail;
  const std::size_t n = points.size() / dim;
  std::vector<Vector<T>> f(n);
  std::vector<double> estimates;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < dim; ++c) {
      f[i].c[c] = points[i * dim + c];
      if (!measured) estimates.push_back(estimate(f[i].c[c]));
    }
  const auto distance = [](const auto& a, const auto& b) { return norm(a - b); };
  const HermiteMeasure measure = measured ? *measured : hermite_measure<double>(estimates, dim);
  const std::size_t farthest = measure.farthest;
  const std::size_t apex = measure.apex;
  if (n > 1 && measure.one_point) refuse("all points are equal");
  if (n < 3) refuse("a Hermite curve needs at least 3 points, not " + std::to_string(n));
  const T size = distance(f[farthest], f[0]);
  const T far = norm(f[measure.outermost]);
  for (std::size_t i = 0; i + (closed ? 0U : 1U) < n; ++i)
    if (!is_less(tiny<T>(14) * size, distance(f[i], f[(i + 1) % n]), "two points are equal"))
      refuse("points " + std::to_string(i) + " and " + std::to_string((i + 1) % n) + " are equal");
  const T spread = norm(cross(f[farthest] - f[0], f[apex] - f[0]));
  if (!is_less(tiny<T>(12) * size * size, spread, "all points lie on a line")) refuse("all points lie on a line");

  // Centre and plane.
  HermiteAngles<T> out;
  const Vector<T> triple = circumcentre(f[0], f[farthest], f[apex]);
  Vector<T> normal = {{T(0), T(0), T(1)}};
  bool plane = true;
  if (dim == 3) {
    normal = (T(1) / spread) * cross(f[farthest] - f[0], f[apex] - f[0]);
    for (const auto& x : f)
      plane = plane && within(dot(x - f[0], normal), tiny<T>(12) * (size + far), "the points lie in a plane");
  }
  const T radius = distance(f[0], triple);
  out.circle = plane && !is_less(T(10000) * size, radius, "the points lie on a circle");
  for (const auto& x : f)
    out.circle =
        out.circle && within(distance(x, triple) - radius, tiny<T>(12) * (radius + far), "the points lie on a circle");
  if (out.circle) {
    out.centre = triple;
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      const std::size_t after = (i + 1) % n;
      const T area = norm(cross(f[before] - f[i], f[i] - f[after]));
      const T sides = distance(f[before], f[i]) * distance(f[i], f[after]) * distance(f[before], f[after]);
      const char* const what = "three points count as collinear";
      const bool straight =
          !is_less(tiny<T>(14) * size * size, area, what) || !is_less(sides, T(200) * area * size, what);
      out.centre = out.centre + (straight ? f[i] : circumcentre(f[before], f[i], f[after]));
    }
    for (auto& x : out.centre.c) x = x / T(static_cast<int>(n));
    if (!plane) {
      std::array<std::array<T, 3>, 3> moments = {{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, {T(0), T(0), T(0)}}};
      for (const auto& x : f) {
        const Vector<T> d = x - out.centre;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) moments[i][j] = moments[i][j] + d.c[i] * d.c[j];
      }
      normal = least_direction(moments);
    }
  }
  {
    const char* const what = "the plane is vertical";
    const auto flat = [&](std::size_t c) { return within(normal.c[c], tiny<T>(12), what); };
    const std::size_t up = !flat(2) ? 2 : !flat(1) ? 1 : 0;
    if (is_less(normal.c[up], T(0), what)) normal = T(-1) * normal;
    out.e1 = {{T(1), T(0), T(0)}};
    if (dim == 3 && is_less(tiny<T>(24), normal.c[2] * normal.c[2] + normal.c[0] * normal.c[0], what)) {
      out.e1 = {{normal.c[2], T(0), -normal.c[0]}};
      out.e1 = (T(1) / norm(out.e1)) * out.e1;
    } else if (dim == 3) {
      out.e1 = out.e1 - dot(out.e1, normal) * normal;
    }
    out.e2 = cross(normal, out.e1);
  }

  // Angles (S.4), in the direction in which the polygon turns.
  std::vector<bool> central(n);
  std::size_t outside = 0;
  for (std::size_t i = 0; i < n; ++i) {
    central[i] = !is_less(tiny<T>(9) * size, distance(f[i], out.centre), "a vertex lies at the centre");
    if (!central[i]) ++outside;
  }
  if (outside < 2) refuse("the points lie at the centre of their circles");
  const T half = pi(points[0]);
  const T turn = T(2) * half;
  // The angle in (-pi, pi], on the negative axis either end of it.
  struct Angle {
    T value;
    bool axis;  // on the negative axis
  };
  const auto angle = [&](std::size_t i) {
    const T x = dot(f[i] - out.centre, out.e1);
    const T y = dot(f[i] - out.centre, out.e2);
    if (estimate(x) >= 0) return Angle{atan2(y, x), false};
    if (within(y, tiny<T>(13) * x, "a vertex lies on the axis of sigma")) return Angle{atan2(-y, -x) - half, true};
    const bool above = is_less(T(0), y, "a vertex lies on the axis of sigma");
    return Angle{atan2(-y, -x) + (above ? half : -half), false};
  };
  {
    // What the steps add up to when all of them go forwards, in either direction; then the area, then the first step.
    const char* const what = "the polygon turns left or right";
    T forwards(0);
    T backwards(0);
    T area(0);
    int first_step = 0;
    std::size_t last = n;
    T last_angle(0);
    for (std::size_t k = 0; k < n + (closed ? 1U : 0U); ++k) {
      const std::size_t i = k % n;
      if (central[i]) continue;
      const T now = angle(i).value;
      if (last < n && last != i) {
        T gap = now - last_angle;
        gap = gap - T(static_cast<int>(std::lround(estimate(gap) / (2 * pi_estimate)))) * turn;
        int sign = 0;
        if (!within(gap, tiny<T>(9), what)) sign = is_less(T(0), gap, what) ? 1 : -1;
        if (sign == 0) gap = T(0);
        forwards = forwards + (sign > 0 ? gap : gap + turn);
        backwards = backwards + (sign < 0 ? -gap : turn - gap);
        area = area + norm(f[last] - out.centre) * norm(f[i] - out.centre) * sin(gap);
        if (first_step == 0) first_step = sign;
      }
      last = i;
      last_angle = now;
    }
    const T difference = backwards - forwards;
    const bool reversed = !within(difference, tiny<T>(6), what)           ? is_less(difference, T(0), what)
                          : !within(area, tiny<T>(6) * size * size, what) ? is_less(area, T(0), what)
                                                                          : first_step < 0;
    if (reversed) out.e2 = T(-1) * out.e2;
  }
  out.sigma.assign(n, T(0));
  const char* const one_ray = "two vertices lie on one ray";
  std::size_t before = n;
  int turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (central[i]) continue;
    // On the negative axis: pi, at vertex 0 -pi.
    const Angle a = angle(i);
    const T s = a.axis && i > 0 ? a.value + turn : a.value;
    while (before < n && !is_less(out.sigma[before] + tiny<T>(9), s + T(turns) * turn, one_ray)) ++turns;
    out.sigma[i] = s + T(turns) * turn;
    before = i;
  }
  const auto ascent = [&](std::size_t from, std::size_t to) { return out.sigma[to] - out.sigma[from]; };
  std::size_t first = 0;
  while (central[first]) ++first;
  int windings = 1;
  while (!is_less(out.sigma[before] + tiny<T>(9), out.sigma[first] + T(windings) * turn, one_ray)) ++windings;
  out.period = T(windings) * turn;
  for (std::size_t i = 0; i < n; ++i) {
    if (!central[i]) continue;
    const std::size_t left = (i + n - 1) % n;
    const std::size_t right = (i + 1) % n;
    if (i > 0 && !central[left] && i + 1 < n && !central[right])
      out.sigma[i] = (out.sigma[left] + out.sigma[right]) / T(2);
    else if (closed && i == 0)
      out.sigma[i] = (out.sigma[n - 1] - out.period + out.sigma[1]) / T(2);
    else if (closed)
      out.sigma[i] = (out.sigma[left] + out.sigma[right] + out.period) / T(2);
    else if (i == 0)
      out.sigma[i] = T(2) * out.sigma[1] - out.sigma[2];
    else
      out.sigma[i] = T(2) * out.sigma[i - 1] - out.sigma[i - 2];
  }

  // Several turns (S.5), bunches, axis.
  if (!out.circle && closed && windings > 1) {
    const T origin = out.sigma[0];
    for (auto& s : out.sigma) s = (s - origin) / T(windings) - half;
    out.period = turn;
  } else if (!out.circle && !closed &&
             (invariant ? is_less(turn + tiny<T>(9), ascent(0, n - 1), "the polygon makes more than a turn")
                        : turns > 1)) {
    const T origin = out.sigma[0];
    const T range = out.sigma[n - 1] - origin;
    for (auto& s : out.sigma) s = (s - origin) * turn / range - half;
  } else if ((closed ? windings == 1 : turns <= 1) &&
             !is_less(out.sigma[n - 1], turn - tiny<T>(9), "sigma passes 2 pi")) {
    for (auto& s : out.sigma) s = s - turn;
  }
  T least = closed ? out.period - ascent(0, n - 1) : ascent(0, 1);
  for (std::size_t i = 0; i + 1 < n; ++i)
    if (estimate(ascent(i, i + 1)) < estimate(least)) least = ascent(i, i + 1);
  const T total = closed ? out.period : ascent(0, n - 1);
  const std::size_t edges = closed ? n : n - 1;
  if (!out.circle &&
      is_less(T(64) * T(static_cast<int>(edges)) * least, total, "a step is smaller than 1/64 of the mean step")) {
    std::vector<T> length = {T(0)};
    for (std::size_t i = 0; i < edges; ++i) length.push_back(length[i] + norm(f[(i + 1) % n] - f[i]));
    for (std::size_t i = 0; i < n; ++i) out.sigma[i] = turn * length[i] / length[edges] - half;
    out.period = turn;
  }
  if (invariant) {
    const T origin = closed ? out.sigma[0] + half : (out.sigma[0] + out.sigma[n - 1]) / T(2);
    for (auto& s : out.sigma) s = s - origin;
  }
  return out;
}

/// f - f_0, p, r somewhere on a segment, from f_1 - f_0, p_0, p_1, r_0, r_1 (constants are kept exactly).
template <class T>
using HermiteStep = std::array<std::array<T, 5>, 3>;

namespace hermite_detail {

/// The rational quintic with ends v, u at x = a + tau (b-a) = b - rest (b-a), a = 2v/(1-v^2), b = 2u/(1-u^2).
template <class T>
HermiteStep<T> segment(const T& v, const T& u, const T& x, const T& tau, const T& rest) {
  const T one(1);
  const T va = one - v * v;
  const T ua = one - u * u;
  const T a = T(2) * v / va;
  const T b = T(2) * u / ua;
  const T h = T(2) * (u - v) * (one + u * v) / (va * ua);
  const T aa = a * a;
  const T bb = b * b;
  const T ab = a * b;
  // Weights (3).
  const T m0 = (aa + one) * (aa + one) / T(4);
  const T m1 = (aa + one) * (aa + T(4) * ab + T(5)) / T(20);
  const T m3 = (aa * (T(3) * bb + one) + T(2) * ab * (bb + T(3)) + T(3) * bb + T(5)) / T(20);
  const T m4 = (bb + one) * (bb + T(4) * ab + T(5)) / T(20);
  const T m5 = (bb + one) * (bb + one) / T(4);
  // mu_k (Q_k - f_0) of (5), by columns.
  const T zero(0);
  const T first = h / T(20);
  const T second = h * h / T(80);
  const std::array<std::array<T, 6>, 5> columns = {
      {{zero, zero, zero, m3, m4, m5},
       {zero, T(2) * first * m0, first * (T(5) * m1 - m0), zero, zero, zero},
       {zero, zero, zero, first * (m5 - T(5) * m4), -(T(2) * first * m5), zero},
       {zero, zero, second * m0, zero, zero, zero},
       {zero, zero, zero, second * m5, zero, zero}}};
  const T d = (one + x * x) * (one + x * x) / T(4);
  const T d1 = T(2) * x * (one + x * x) / d;
  const T d2 = T(4) * (one + T(3) * x * x) / d;
  const T rate = T(2) / h;
  HermiteStep<T> out;
  for (std::size_t j = 0; j < 5; ++j) {
    std::array<T, 6> c = columns[j];
    for (std::size_t n = 5; n > 2; --n)
      for (std::size_t k = 0; k < n; ++k) c[k] = rest * c[k] + tau * c[k + 1];
    // Three points are left: the last two steps with their differences are value and derivatives.
    const T n2 = T(20) * rate * rate * (c[2] - T(2) * c[1] + c[0]) / d;
    const T left = rest * c[0] + tau * c[1];
    const T right = rest * c[1] + tau * c[2];
    const T n1 = T(5) * rate * (right - left) / d;
    out[0][j] = (rest * left + tau * right) / d;
    out[1][j] = n1 - d1 * out[0][j];
    out[2][j] = n2 - T(2) * d1 * out[1][j] - d2 * out[0][j];
  }
  return out;
}

}  // namespace hermite_detail

/// c - f_0, c', c'' (in t) of Definition 4 at the angular parameter sigma, without a division by a weight. Required: v
/// < u in
/// (-1, 1), sigma in (-2 pi, 2 pi).
template <class T>
HermiteStep<T> hermite_segment(const T& v, const T& u, const T& sigma) {
  using namespace hermite_detail;
  const T x = tan(sigma / T(4));
  const T a = T(2) * v / (T(1) - v * v);
  const T b = T(2) * u / (T(1) - u * u);
  return segment(v, u, x, (x - a) / (b - a), (b - x) / (b - a));
}

/// The rule of one step. Required: v < u, both in (-1, 1), w > 0, and w < (1-v)/(u-v) for the printed tension.
template <class T>
HermiteStep<T> hermite_step(const T& v, const T& u_given, const T& w, HermiteRuleTension tension) {
  const T u = tension == HermiteRuleTension::printed ? v + w * (u_given - v) : u_given;
  const T one(1);
  const T minus = one - u * v;
  const T both = T(2) * minus * (one + u * v);
  HermiteStep<T> out = hermite_detail::segment(v, u, (u + v) / minus, (one + v * v) * (one - u * u) / both,
                                               (one + u * u) * (one - v * v) / both);
  if (tension == HermiteRuleTension::c2) {
    const std::array<T, 5> powers = {one, w, w, w * w, w * w};
    for (std::size_t j = 0; j < 5; ++j) {
      out[0][j] = out[0][j] * powers[j];
      out[1][j] = out[1][j] * powers[j] / w;
      out[2][j] = out[2][j] * powers[j] / (w * w);
    }
  }
  return out;
}

/// Everything that is decided before the first step, and the refinement itself.
template <class T>
class HermiteCurve {
 public:
  /// Finds what `data` leaves open: sigma by Algorithm 1 (with the data's own axis when p and r are to be found too); p
  /// and r from the circle the points lie on, else from the circle through the vertex and its two neighbours (at the
  /// end of an open curve, the next two): its tangent and curvature, and for |f_sigma| the harmonic mean of chord/(2
  /// sin(step/2)) of the two edges (chord/step beyond 5.5), exact on circles; 0 where the neighbours are one point.
  /// Errors: unusable points (hermite_angles); sigma given and not ascending; p, r given at a pole of t; edges longer
  /// than a chart; w <= 0, and w >= w* with the printed tension; HermiteUndecided.
  HermiteCurve(HermiteData<T> data, const T& w, HermiteRuleTension tension)
      : data_(std::move(data)), w_(w), tension_(tension), omega_(tension == HermiteRuleTension::c2 ? w : T(1)) {
    using namespace hermite_detail;
    if (!is_less(T(0), w_, "the tension w is positive")) refuse("the tension w must be positive");
    const std::size_t n = data_.size();
    const std::size_t dim = data_.dim;
    const bool given = !data_.p.empty();
    HermiteAngles<T> angles;
    const bool found = data_.sigma.empty();
    if (found) {
      angles = hermite_angles<T>(data_.f, dim, data_.closed, !given, data_.measure);
    } else {
      (void)hermite_angles<T>(data_.f, dim, data_.closed, false, data_.measure);  // refuses unusable points
      angles.sigma = data_.sigma;
      for (std::size_t i = 0; i + 1 < n; ++i)
        if (!is_less(angles.sigma[i] + tiny<T>(30), angles.sigma[i + 1], "sigma ascends"))
          refuse("sigma must ascend, but does not after point " + std::to_string(i));
      int turns = 1;
      const T turn = T(2) * pi(data_.f[0]);
      while (!is_less(angles.sigma[n - 1] + tiny<T>(12), angles.sigma[0] + T(turns) * turn, "sigma makes a full turn"))
        ++turns;
      angles.period = T(turns) * turn;
    }
    data_.sigma = angles.sigma;
    for (auto& s : data_.sigma) s = s - T(2 * own_shift(s, given)) * pi(s);
    if (given)
      for (std::size_t i = 0; i < n; ++i) {
        const T turn = T(2) * pi(data_.f[0]);
        const T off = data_.sigma[i] - turn;
        const int periods = static_cast<int>(std::lround(estimate(off) / (4 * pi_estimate)));
        if (within(off - T(2 * periods) * turn, tiny<T>(9), "sigma is 2 pi"))
          refuse("p and r have no meaning at point " + std::to_string(i) + ", where sigma is 2*pi");
      }
    else
      derive(angles);
    const std::size_t edges = data_.closed ? n : n - 1;
    bool below = true;
    for (std::size_t i = 0; i < edges; ++i) {
      Edge edge;
      edge.sigma[0] = angles.sigma[i];
      edge.sigma[1] = i + 1 < n ? angles.sigma[i + 1] : angles.sigma[0] + angles.period;
      const double middle = (estimate(edge.sigma[0]) + estimate(edge.sigma[1])) / 2;
      const auto inside = [&] {
        const T limit = T(2) * pi(edge.sigma[0]) - tiny<T>(6);
        const char* const what = "an edge lies within 2 pi of sigma = 0";
        return is_less(-limit, edge.sigma[0], what) && is_less(edge.sigma[1], limit, what);
      };
      if (!inside()) {
        const T shift = T(2 * static_cast<int>(std::lround(middle / (2 * pi_estimate)))) * pi(edge.sigma[0]);
        for (auto& s : edge.sigma) s = s - shift;
      }
      if (!inside()) refuse("the edge after point " + std::to_string(i) + " turns too far in sigma");
      const T v = slope(edge.sigma[0]);
      const T u = slope(edge.sigma[1]);
      const T pole = (T(1) - v) / (u - v);
      first_pole_ = std::min(first_pole_, estimate(pole));
      below = below && (tension_ != HermiteRuleTension::printed || is_less(w_, pole, "w is below the first pole"));
      edges_.push_back(std::move(edge));
    }
    if (!below)
      refuse("the tension w = " + std::to_string(estimate(w_)) +
             " is not below the first pole of these data, w* = " + std::to_string(first_pole_));
  }

  /// w*: below it no step of the printed tension meets a pole (an estimate in double).
  double first_pole() const { return first_pole_; }
  /// The data with all that was found; sigma in the chart in which p and r are meant.
  const HermiteData<T>& data() const { return data_; }

  /// The vertices after `levels` steps, from vertex 0 on: n 2^levels of a closed curve, (n-1) 2^levels + 1 of an open
  /// one. New vertices have p, r and sigma of the chart of their edge; old ones keep their bits.
  HermiteData<T> refined(unsigned levels) const {
    const std::size_t dim = data_.dim;
    const std::size_t n = data_.size();
    const std::size_t pieces = std::size_t{1} << levels;
    HermiteData<T> out;
    out.dim = dim;
    out.closed = data_.closed;
    for (auto* list : {&out.f, &out.p, &out.r}) list->reserve((edges_.size() * pieces + 1) * dim);
    std::vector<T> sigma(pieces + 1, T(0));
    std::vector<T> s(pieces + 1, T(0));
    std::vector<std::array<T, 9>> row(pieces + 1);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for (std::size_t end = 0; end < 2; ++end) {
        const std::size_t at = end * pieces;
        sigma[at] = edges_[i].sigma[end];
        s[at] = hermite_detail::slope(sigma[at]);
        row[at] = in_chart((i + end) % n, sigma[at]);
      }
      for (std::size_t step = pieces; step > 1; step /= 2)
        for (std::size_t k = 0; k < pieces; k += step) insert(sigma, s, row, k, k + step / 2, k + step);
      append(out, data_, i);
      for (std::size_t k = 1; k < pieces; ++k) {
        for (std::size_t c = 0; c < dim; ++c) {
          out.f.push_back(row[k][c]);
          out.p.push_back(row[k][3 + c]);
          out.r.push_back(row[k][6 + c]);
        }
        out.sigma.push_back(sigma[k]);
      }
    }
    if (!data_.closed) append(out, data_, n - 1);
    return out;
  }

 private:
  struct Edge {
    std::array<T, 2> sigma = {T(0), T(0)};
  };

  // Multiple of 2 pi between the parameter of a vertex and the chart of its p and r: a given p is in t(sigma) itself.
  static int own_shift(const T& sigma, bool given) {
    using namespace hermite_detail;
    if (given || !is_less(T(2) * pi(sigma) - tiny<T>(6), estimate(sigma) < 0 ? -sigma : sigma, "sigma passes 2 pi"))
      return 0;
    return static_cast<int>(std::lround(estimate(sigma) / (2 * pi_estimate)));
  }

  static void append(HermiteData<T>& out, const HermiteData<T>& from, std::size_t i) {
    const auto copy = [&](std::vector<T>& to, const std::vector<T>& values) {
      for (std::size_t c = 0; c < from.dim; ++c) to.push_back(values[i * from.dim + c]);
    };
    copy(out.f, from.f);
    copy(out.p, from.p);
    copy(out.r, from.r);
    out.sigma.push_back(from.sigma[i]);
  }

  // p and r from f_sigma and f_ss.
  void derive(const HermiteAngles<T>& angles) {
    using namespace hermite_detail;
    const std::size_t n = data_.size();
    const std::size_t dim = data_.dim;
    for (std::size_t i = 0; i < n; ++i) {
      const auto [rate, rate2] = rates(data_.sigma[i]);
      std::array<T, 3> first = {T(0), T(0), T(0)};
      std::array<T, 3> second = {T(0), T(0), T(0)};
      if (angles.circle) {
        Vector<T> d;
        for (std::size_t c = 0; c < dim; ++c) d.c[c] = data_.f[i * dim + c] - angles.centre.c[c];
        const Vector<T> tangent = dot(d, angles.e1) * angles.e2 - dot(d, angles.e2) * angles.e1;
        for (std::size_t c = 0; c < dim; ++c) {
          first[c] = tangent.c[c];
          second[c] = -d.c[c];
        }
      } else {
        const auto relative = [&](long k) {  // vertex k from i: position and sigma
          const auto count = static_cast<long>(n);
          const long round = k < 0 ? -1 : k >= count ? 1 : 0;
          const auto index = static_cast<std::size_t>(k - round * count);
          std::pair<Vector<T>, T> other;
          for (std::size_t c = 0; c < dim; ++c) other.first.c[c] = data_.f[index * dim + c] - data_.f[i * dim + c];
          other.second = angles.sigma[index] + T(static_cast<int>(round)) * angles.period - angles.sigma[i];
          return other;
        };
        const long at = static_cast<long>(i);
        const bool start = !data_.closed && i == 0;
        const bool end = !data_.closed && i + 1 == n;
        const auto one = relative(start ? 1 : end ? at - 2 : at - 1);
        const auto two = relative(start ? 2 : end ? at - 1 : at + 1);
        // Inversion about the vertex maps the circle through the three to a line: its direction is the tangent, half of
        // the curvature vector its nearest point.
        const Vector<T> a = (T(1) / dot(one.first, one.first)) * one.first;
        const Vector<T> b = (T(1) / dot(two.first, two.first)) * two.first;
        const Vector<T> d = start || end ? a - b : b - a;
        // |f_sigma| is the radius of the circle with this chord over this range of sigma; of two the harmonic mean.
        const auto radius = [&](const std::pair<Vector<T>, T>& other) {
          const T gap = estimate(other.second) < 0 ? -other.second : other.second;
          return norm(other.first) /
                 (is_less(T(11) / T(2), gap, "an edge is wider than 5.5 in sigma") ? gap : T(2) * sin(gap / T(2)));
        };
        const T square = dot(d, d);
        if (is_less(tiny<T>(18) * (dot(a, a) + dot(b, b)), square, "a vertex has equal neighbours")) {
          T speed(0);
          if (start || end) {
            speed = radius(start ? one : two);
          } else {
            const T left = radius(one);
            const T right = radius(two);
            speed = T(2) * left * right / (left + right);
          }
          const Vector<T> tangent = (speed / sqrt(square)) * d;
          const Vector<T> bend = (T(2) * speed * speed) * (a - (dot(a, d) / square) * d);
          for (std::size_t c = 0; c < dim; ++c) {
            first[c] = tangent.c[c];
            second[c] = bend.c[c];
          }
        }
      }
      for (std::size_t c = 0; c < dim; ++c) {
        const T p = first[c] / rate;
        data_.p.push_back(p);
        data_.r.push_back((second[c] - p * rate2) / (rate * rate));
      }
    }
  }

  // f, p, r (three components each) of vertex i in the chart where its parameter is sigma.
  std::array<T, 9> in_chart(std::size_t i, const T& sigma) const {
    const std::size_t dim = data_.dim;
    std::array<T, 9> out;
    for (auto& x : out) x = T(0);
    const double turns = (estimate(sigma) - estimate(data_.sigma[i])) / (2 * hermite_detail::pi_estimate);
    const bool same = std::lround(turns) % 2 == 0;
    const auto own = hermite_detail::rates(data_.sigma[i]);
    const auto now = hermite_detail::rates(sigma);
    for (std::size_t c = 0; c < dim; ++c) {
      const T& p = data_.p[i * dim + c];
      const T& r = data_.r[i * dim + c];
      out[c] = data_.f[i * dim + c];
      out[3 + c] = p;
      out[6 + c] = r;
      if (same) continue;
      const T q = p * own.first / now.first;
      out[3 + c] = q;
      out[6 + c] = (r * own.first * own.first + (p * own.second - q * now.second) / omega_) / (now.first * now.first);
    }
    return out;
  }

  void insert(std::vector<T>& sigma, std::vector<T>& s, std::vector<std::array<T, 9>>& row, std::size_t left,
              std::size_t middle, std::size_t right) const {
    const HermiteStep<T> rule = hermite_step(s[left], s[right], w_, tension_);
    sigma[middle] = (sigma[left] + sigma[right]) / T(2);
    s[middle] = hermite_detail::slope(sigma[middle]);
    const auto& a = row[left];
    const auto& b = row[right];
    for (std::size_t c = 0; c < data_.dim; ++c) {
      const T d = b[c] - a[c];
      for (std::size_t k = 0; k < 3; ++k) {
        const T sum = rule[k][0] * d + rule[k][1] * a[3 + c] + rule[k][2] * b[3 + c] + rule[k][3] * a[6 + c] +
                      rule[k][4] * b[6 + c];
        row[middle][3 * k + c] = k == 0 ? a[c] + sum : sum;
      }
    }
  }

  HermiteData<T> data_;
  T w_;
  HermiteRuleTension tension_;
  T omega_;
  std::vector<Edge> edges_;
  double first_pole_ = std::numeric_limits<double>::infinity();
};

}  // namespace twoscale::kernels
