// SPDX-License-Identifier: 0BSD
// Literals, comments and rows of generated source text.
#include "source.hpp"

#include <algorithm>

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels::source {
namespace {

constexpr int double_digits = 17;

// A decimal made a floating literal ("1" -> "1.0"); C has no sign or leading zeros problem in floating literals.
std::string floating(std::string text) {
  if (text.find_first_of(".eE") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

std::string comment_block(const MaskTable& table) {
  std::string out = "/*\n";
  for (const std::string& line : header_lines(table)) out += " * " + line + "\n";
  return out + " */\n";
}

std::string comment_lines(const MaskTable& table, std::string_view mark, const std::vector<std::string>& more) {
  std::string out;
  const auto add = [&](const std::string& line) { out += std::string(mark) + line + "\n"; };
  for (const std::string& line : header_lines(table)) add(line);
  for (const std::string& line : more) add(line);
  return out;
}

std::string decimal(double value) { return floating(shortest(value)); }

std::string shift_ratio(const MaskTable& table) {
  const Shift p = parse_shift(table.shift);
  return std::to_string(p.num) + (p.den == 1 ? "" : "/" + std::to_string(p.den));
}

std::string literal(const MaskTable& table, const TableOptions& options, double value, const std::string& text) {
  if (options.hex_float) return hex_float(value);
  const bool short_text = table.digits > 0 && table.digits < double_digits;
  return floating(short_text ? text : shortest(value));
}

std::string long_literal(const std::string& text) { return floating(text) + "L"; }

bool has_long_digits(const MaskTable& table) { return table.digits > double_digits; }

std::string shift_expression(const MaskTable& table) {
  const Shift p = parse_shift(table.shift);
  const std::string num = std::to_string(p.num) + ".0";
  if (p.den != 1) return std::string("(") + num + "/" + std::to_string(p.den) + ".0)";
  return p.num < 0 ? std::string("(") + num + ")" : num;
}

std::string rows(std::size_t levels, std::size_t count, const RowStyle& style,
                 const std::function<std::string(std::size_t row, std::size_t column)>& item) {
  constexpr std::size_t width = 100;
  std::string out;
  for (std::size_t k = 0; k <= levels; ++k) {
    const bool limit = k == levels;
    out += "    " + std::string(style.comment_open) + (limit ? "limit" : "k = " + std::to_string(k)) +
           std::string(style.comment_close) + "\n";
    std::string line = "    " + std::string(style.open);
    for (std::size_t s = 0; s < count; ++s) {
      const std::string text = item(k, s) + (s + 1 < count ? "," : "");
      if (s > 0 && line.size() + 1 + text.size() > width) {
        out += line + "\n";
        line = "     " + text;
      } else {
        line += (s > 0 ? " " : "") + text;
      }
    }
    out += line + std::string(style.close) + (limit ? "" : std::string(style.between)) + "\n";
  }
  return out;
}

std::string rows(const MaskTable& table, const TableOptions& options, bool long_digits, const RowStyle& style) {
  const TableGrid grid = common_grid(table);
  return rows(table.levels.size(), grid.value[0].size(), style, [&](std::size_t k, std::size_t s) {
    return long_digits ? long_literal(grid.text[k][s]) : literal(table, options, grid.value[k][s], grid.text[k][s]);
  });
}

std::string operation_count(const MaskTable& table) {
  const TableGrid grid = common_grid(table);
  std::size_t terms = 0;  // coefficients that are nonzero at some level
  for (std::size_t s = 0; s < grid.value[0].size(); ++s) {
    const bool used = std::any_of(grid.value.begin(), grid.value.end(), [&](const auto& row) { return row[s] != 0; });
    if (used) ++terms;
  }
  return "At most " + std::to_string(terms) + " multiplications and as many additions for each old point.";
}

std::string substituted(std::string_view text, const std::string& lower, const std::string& upper) {
  std::string out;
  for (const char c : text) {
    if (c == '@')
      out += lower;
    else if (c == '$')
      out += upper;
    else
      out += c;
  }
  return out;
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

}  // namespace twoscale::kernels::source
