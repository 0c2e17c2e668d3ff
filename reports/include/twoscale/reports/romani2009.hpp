// SPDX-License-Identifier: GPL-3.0-or-later
// The paper romani2009 run again: its three 6-point schemes (section 4) derived and proved, its figures 1-12 computed.
//
// The figures are a table of data (src/romani2009/figures.cpp): curves in closed form, where they are sampled, schemes
// and values of v^0. Nothing is drawn by hand, and every picture comes with a measured number.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "twoscale/reports/checker.hpp"

namespace twoscale::reports::romani2009 {

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

// Vertices x, y of a closed polygon.
struct Polygon {
  std::vector<double> vertices;
};

struct Trial {
  std::string scheme;
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

const std::vector<Figure>& figures();

// What came out of one run.
struct Measured {
  bool ran = false;
  std::string refusal;          // the reason when it did not run
  std::size_t points = 0;       // refined points compared
  double deviation = 0;         // samples: from the true curve, over the diagonal of its box
  double polygon_distance = 0;  // over the diagonal of the polygon's box
  double turning = 0;           // plane polygons: total turning of the curve in full turns
  std::vector<double> curve;    // points for drawing
};

// Starting points of a panel for a trial: `given` points beyond the ends included when open. Row-major.
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

struct Options {
  Checker checker;                                   // empty: certificates are written, not checked
  std::function<void(const std::string&)> progress;  // empty: silent
};

struct Summary {
  int pictures = 0;
  int exact_runs = 0;
  double largest_exact_deviation = 0;
  bool all_certificates_valid = true;
  std::string index;  // path of the page
};

// Writes directory/index.html (self-contained: pictures are embedded), and beside it certificates/, figures/ (SVG),
// data/ (starting points as CSV) and measurements.json. Makes the directory. Throws Error(io).
Summary write_report(const std::string& directory, const Options& options);

}  // namespace twoscale::reports::romani2009
