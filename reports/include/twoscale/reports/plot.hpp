// SPDX-License-Identifier: GPL-3.0-or-later
// Room: reports. Pictures as plain data, drawn by the gnuplot program.
//
// gnuplot runs as a child process without a display; it reads a script that holds all data and writes the image to its
// standard output, so that no path ever stands in a script. The same picture gives the same SVG.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twoscale::reports {

// n points of `dim` (2 or 3) finite numbers, row-major, joined by a line.
struct Line {
  enum class Style {
    curve,      // solid
    reference,  // thin, red: the true curve
    polygon,    // dashed, with its vertices
    segments,   // points 2i and 2i+1 joined, nothing else
    points,     // not joined
  };
  std::vector<double> values;
  std::size_t dim = 2;
  Style style = Style::curve;
  bool closed = false;
  std::string title;  // in the legend; empty: not there
  int colour = 0;     // of a fixed palette, modulo its size (curve, segments, points)
};

struct Picture {
  std::vector<Line> lines;  // all of the same dim; drawn in this order
  std::string title;
  std::string x_label;
  std::string y_label;
  bool equal_axes = true;      // one unit of x is as long as one of y; in space always (a parallel projection)
  bool logarithmic_x = false;  // in the plane only, not with equal_axes
  bool logarithmic_y = false;
  int width = 460;  // pixels (SVG, PNG at twice that), 1/72 inch (PDF)
  int height = 380;
};

enum class ImageFormat { svg, pdf, png };

// By the suffix of the path (any case); "-" is SVG. Throws Error(bad_input) naming the path.
ImageFormat image_format(const std::string& path);

// The gnuplot script. Throws Error(bad_input) for an empty picture, mixed dimensions, numbers that are not finite.
std::string gnuplot_script(const Picture& picture, ImageFormat format);

// The bytes of the image. Throws Error(io) if gnuplot cannot be started or fails, with its first line of complaint.
std::string render(const Picture& picture, ImageFormat format);

// render by the suffix of `path`, then an atomic write ("-": standard output).
void draw(const Picture& picture, const std::string& path);

}  // namespace twoscale::reports
