// SPDX-License-Identifier: GPL-3.0-or-later
// A picture as a gnuplot script. The plot area is placed in pixels, and ranges are widened to its proportions: axes are
// equal without empty strips, and all pictures of one size line up.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "gnuplot.hpp"
#include "projection.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/reports/plot.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

// Distinct for most eyes and dark enough for thin lines on white.
constexpr std::array<const char*, 7> palette = {"#0b5394", "#c2410c", "#15803d", "#7e22ce",
                                                "#a16207", "#0e7490", "#be185d"};

constexpr int frame_colour = -1;

struct Range {
  double low = 0;
  double high = 0;
  double length() const { return high - low; }
  double middle() const { return low + (high - low) / 2; }
};

Range range_of(const Picture& picture, std::size_t coordinate) {
  Range r;
  bool first = true;
  for (const Line& l : picture.lines)
    for (std::size_t j = coordinate; j < l.values.size(); j += l.dim) {
      r.low = first ? l.values[j] : std::min(r.low, l.values[j]);
      r.high = first ? l.values[j] : std::max(r.high, l.values[j]);
      first = false;
    }
  return r;
}

void check(const Picture& picture) {
  if (picture.lines.empty()) bad_input("picture: nothing to draw");
  for (const Line& l : picture.lines) {
    if (l.dim != picture.lines[0].dim || (l.dim != 2 && l.dim != 3))
      bad_input("picture: curves must all have two or all have three coordinates, not", std::to_string(l.dim));
    if (l.values.size() < l.dim || l.values.size() % l.dim != 0) bad_input("picture: a curve without points");
    for (double x : l.values)
      if (!std::isfinite(x) || std::abs(x) > 1e100)
        bad_input("picture: a point is too far away to be drawn", kernels::shortest(x));
  }
}

// Characters of UTF-8 text.
std::size_t letters(const std::string& s) {
  return static_cast<std::size_t>(
      std::count_if(s.begin(), s.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

// The title on one line: a long one (the name of a scheme with its spaces) in smaller letters, then cut.
std::string title_line(const Picture& p, ImageFormat format) {
  const auto fitting = static_cast<std::size_t>(p.width / 7);  // at the font's own size
  const std::size_t length = letters(p.title);
  if (length <= fitting) return gnuplot_string(p.title);
  const double size = format == ImageFormat::pdf ? 9 : 12;
  const double scale = std::max(0.5, static_cast<double>(fitting) / static_cast<double>(length));
  const std::string text = length <= 2 * fitting ? p.title : p.title.substr(0, 2 * fitting - 3) + "...";
  return gnuplot_string(text) + fmt::format(" font 'sans-serif,{:.1f}'", size * scale);
}

// The legend below the axes: entries a row, and rows.
struct Legend {
  int columns = 0;
  int rows = 0;
};

Legend legend(const Picture& p) {
  int entries = 0;
  std::size_t longest = 0;
  for (const Line& l : p.lines) {
    if (l.title.empty()) continue;
    ++entries;
    longest = std::max(longest, letters(l.title));
  }
  if (entries == 0) return {};
  const int width = 62 + 8 * static_cast<int>(longest);
  const int columns = std::clamp((p.width - 70) / width, 1, entries);
  const int rows = (entries + columns - 1) / columns;
  return {(entries + rows - 1) / rows, rows};
}

std::string data(const Line& l) {
  std::string s;
  const std::size_t n = l.values.size() / l.dim;
  const std::size_t last = l.closed ? n + 1 : n;
  for (std::size_t j = 0; j < last; ++j) {
    for (std::size_t c = 0; c < l.dim; ++c) s += fmt::format("{:.9g} ", l.values[(j % n) * l.dim + c]);
    s += '\n';
    if (l.style == Line::Style::segments && j % 2 == 1) s += '\n';
  }
  return s;
}

std::string look(const Line& l) {
  const char* colour =
      l.colour == frame_colour ? "#cbd5e1" : palette[static_cast<std::size_t>(l.colour) % palette.size()];
  switch (l.style) {
    case Line::Style::curve: return fmt::format("with lines lw 2 lc rgb '{}'", colour);
    case Line::Style::reference: return "with lines lw 1.2 lc rgb '#dc2626'";
    case Line::Style::polygon: return "with linespoints lw 1.2 dt (7,5) pt 7 ps 0.45 lc rgb '#6b7280'";
    case Line::Style::segments: return fmt::format("with lines lw 0.7 lc rgb '{}'", colour);
    case Line::Style::points: return fmt::format("with points pt 7 ps 0.5 lc rgb '{}'", colour);
  }
  return {};
}

std::string axis(const char* name, Range r, bool logarithmic) {
  if (logarithmic)
    return fmt::format("set {0}range [{1:.9g}:{2:.9g}]\nset logscale {0} 10\nset format {0} '%g'\n", name, r.low,
                       r.high);
  return fmt::format("set {}range [{:.9g}:{:.9g}]\n", name, r.low, r.high);
}

Range widened(Range r, double length) { return {r.middle() - length / 2, r.middle() + length / 2}; }

Range padded(Range r, bool logarithmic) {
  if (logarithmic) return {r.low / 1.1, r.high * 1.1};
  // A length that the nine digits of an axis cannot show is the rounding of a constant: the curvature of a circle.
  const double size = std::max(std::abs(r.low), std::abs(r.high));
  const double length = r.length() > 1e-7 * size ? r.length() : std::max(1.0, size);
  return widened(r, 1.12 * length);
}

std::string plane(const Picture& p, int left, int right, int top, int bottom) {
  Range x = padded(range_of(p, 0), p.logarithmic_x);
  Range y = padded(range_of(p, 1), p.logarithmic_y);
  if (p.equal_axes) {
    const double unit = std::max(x.length() / (p.width - left - right), y.length() / (p.height - top - bottom));
    x = widened(x, unit * (p.width - left - right));
    y = widened(y, unit * (p.height - top - bottom));
  }
  return axis("x", x, p.logarithmic_x) + axis("y", y, p.logarithmic_y) + "set grid lc rgb '#e5e7eb' lt 1 lw 0.6\n";
}

std::string labels_of(const Frame& f) {
  std::string s = "unset border\nunset tics\nunset grid\n";
  for (const auto& l : f.labels)
    s += fmt::format("set label {} at {:.9g},{:.9g} {} offset 0,{} textcolor rgb '#4b5563'\n", gnuplot_string(l.text),
                     l.x, l.y, l.side, l.text[0] == 'z' ? "0.7" : "-0.9");
  return s;
}

}  // namespace

std::string terminal(ImageFormat format, int width, int height) {
  switch (format) {
    case ImageFormat::svg:
      return fmt::format("svg noenhanced size {},{} font 'sans-serif,12' background '#ffffff'", width, height);
    case ImageFormat::pdf:
      return fmt::format("pdfcairo noenhanced size {:.4f}in,{:.4f}in font 'sans-serif,9'", width / 72.0, height / 72.0);
    case ImageFormat::png:
      return fmt::format(
          "pngcairo noenhanced size {},{} font 'sans-serif,12' fontscale 1.5 linewidth 2 pointscale 2 dashlength 1.6",
          2 * width, 2 * height);
  }
  return {};
}

std::string gnuplot_string(const std::string& text) {
  std::string s = "'";
  for (char c : text) {
    if (c == '\'') s += '\'';
    s += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  }
  return s + "'";
}

std::string gnuplot_script(const Picture& picture, ImageFormat format) {
  check(picture);
  Picture p = picture;
  const bool space = p.lines[0].dim == 3;
  Frame frame;
  if (space) {
    frame = project(p.lines);
    Line box;
    box.style = Line::Style::segments;
    box.colour = frame_colour;
    box.values = frame.edges;
    p.lines.insert(p.lines.begin(), std::move(box));
    p.equal_axes = true;
    p.logarithmic_x = p.logarithmic_y = false;
  }
  if ((p.logarithmic_x && range_of(p, 0).low <= 0) || (p.logarithmic_y && range_of(p, 1).low <= 0))
    bad_input("picture: a logarithmic axis needs positive numbers");
  const Legend key = legend(p);
  const int left = space ? 14 : 52 + (p.y_label.empty() ? 0 : 22);
  const int right = p.logarithmic_x ? 24 : 14;
  const int top = p.title.empty() ? 14 : 34;
  const int bottom = (space ? 22 : 32) + (p.x_label.empty() ? 0 : 24) + 18 * key.rows;
  std::string s = "set terminal " + terminal(format, p.width, p.height) + "\nset encoding utf8\n";
  s += fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\nset bmargin at screen "
      "{:.6f}\n",
      double(left) / p.width, 1 - double(right) / p.width, 1 - double(top) / p.height, double(bottom) / p.height);
  s += "set border lc rgb '#9ca3af' lw 0.8\nset tics scale 0.5 textcolor rgb '#374151'\nset xtics nomirror\nset ytics "
       "nomirror\n";
  s += plane(p, left, right, top, bottom);
  if (space) s += labels_of(frame);
  if (!p.title.empty()) s += "set title " + title_line(p, format) + "\n";
  if (!p.x_label.empty()) s += "set xlabel " + gnuplot_string(p.x_label) + " offset 0,0.4\n";
  if (!p.y_label.empty()) s += "set ylabel " + gnuplot_string(p.y_label) + "\n";
  if (key.rows == 0)
    s += "unset key\n";
  else
    s += fmt::format(
        "set key at screen 0.5, screen {:.6f} center bottom horizontal Left reverse maxcols {} samplen 2 spacing 1.1 "
        "width 1\n",
        2.0 / p.height, key.columns);
  for (std::size_t i = 0; i < p.lines.size(); ++i) s += fmt::format("$line{} << END\n{}END\n", i, data(p.lines[i]));
  s += "plot";
  for (std::size_t i = 0; i < p.lines.size(); ++i) {
    const Line& l = p.lines[i];
    s += fmt::format("{} $line{} {} {}", i == 0 ? "" : ",", i, look(l),
                     l.title.empty() ? "notitle" : "title " + gnuplot_string(l.title));
  }
  return s + "\n";
}

}  // namespace twoscale::reports
