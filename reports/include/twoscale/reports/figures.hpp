// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of papers as data: curves in closed form, where they are sampled, polygons, schemes and values of v^0.
// Nothing is drawn by hand, and every picture comes with a measured number.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace twoscale::reports {

// What is to be expected of one run.
enum class Expect {
  exact,       // the limit is the curve
  different,   // it is not
  impossible,  // the scheme does not exist at this v^0
  shape,       // there is no true curve: a polygon is interpolated
};

// A curve s -> (x, y[, z]).
struct Curve {
  std::string formula;  // "x = cos s, y = sin s"
  std::size_t dim;
  void (*at)(double s, double* point);
};

// The samples s = first + j*spacing, j = 0..count-1, of a curve; both numbers are exact expressions. Open: samples
// beyond both ends are taken from the same formula, as many as the scheme needs.
struct Samples {
  Curve curve;
  std::string first;
  std::string spacing;
  int count;
  bool closed;
};

// Vertices x, y of a polygon; an open one ends by the rule p_{-h} = 2 p_0 - p_h.
struct Polygon {
  std::vector<double> vertices;
  bool closed = true;
};

// A scheme as the catalogue spells it, and what a page calls it.
struct NamedScheme {
  std::string name;
  std::string label;
};

struct Trial {
  NamedScheme scheme;
  std::string v0;  // an exact expression; empty for a stationary scheme
  Expect expect;
};

// One picture: the same start, one or more runs.
struct Panel {
  std::string id;  // "5a"
  std::string title;
  std::variant<Samples, Polygon> start;
  std::vector<Trial> trials;
  std::string note;         // what the paper leaves open, or has otherwise
  bool show_curve = false;  // draw the true curve too
};

struct Figure {
  int number;
  std::string title;
  std::string text;
  std::vector<Panel> panels;
};

// What came out of one run.
struct Measured {
  bool ran = false;
  std::string refusal;          // the reason when it did not run
  std::size_t points = 0;       // refined points compared
  double deviation = 0;         // samples: from the true curve, over the diagonal of its box
  double polygon_distance = 0;  // over the diagonal of the polygon's box
  double turning = 0;           // polygons: total turning of the curve in full turns
  std::vector<double> curve;    // points for drawing
};

// Starting points of a panel for a trial: `given` points beyond the ends of an open curve included. Row-major.
struct StartPoints {
  std::vector<double> values;
  std::size_t dim = 2;
  bool closed = true;
  std::size_t beyond = 0;  // points beyond each end
};
StartPoints start_points(const Panel& panel, const Trial& trial);

// Refines `levels` times in double precision and compares every point; the curve for drawing has drawn_levels.
inline constexpr int measured_levels = 8;
inline constexpr int drawn_levels = 6;
Measured measure(const Panel& panel, const Trial& trial, int levels = measured_levels);

}  // namespace twoscale::reports
