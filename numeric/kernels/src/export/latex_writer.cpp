// SPDX-License-Identifier: 0BSD
// Mask tables as a LaTeX table that needs no packages.
#include "source.hpp"

namespace twoscale::kernels {
namespace {

// Text that LaTeX prints as it stands.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : comment_text(text)) {
    switch (c) {
      case '\\': out += "\\textbackslash{}"; break;
      case '^': out += "\\^{}"; break;
      case '~': out += "\\~{}"; break;
      case '{':
      case '}':
      case '_':
      case '&':
      case '%':
      case '#':
      case '$':
        out += '\\';
        out += c;
        break;
      case '<': out += "$<$"; break;
      case '>': out += "$>$"; break;
      case '"': out += "{\\char34}"; break;
      default: out += c;
    }
  }
  return out;
}

// "-1.5e-7" as $-1.5 \cdot 10^{-7}$; long digits may break after every tenth.
std::string number(const std::string& text) {
  constexpr std::size_t unbroken = 40, group = 10;
  const std::size_t exponent = text.find_first_of("eE");
  std::string digits = text.substr(0, exponent);
  if (digits.size() > unbroken) {
    std::string broken;
    for (std::size_t at = 0; at < digits.size(); at += group)
      broken += (at == 0 ? "" : "\\allowbreak ") + digits.substr(at, group);
    digits = broken;
  }
  if (exponent != std::string::npos) {
    std::string power = text.substr(exponent + 1);
    if (power[0] == '+') power.erase(0, 1);
    digits += " \\cdot 10^{" + power + "}";
  }
  return "$" + digits + "$";
}

class LatexWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "latex"; }
  std::string_view suffix() const override { return "tex"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const std::string m = std::to_string(table.arity);
    bool wide = false;
    const auto widen = [&](const MaskRow& row) {
      for (const std::string& text : row.text) wide = wide || text.size() > 40;
    };
    for (const MaskRow& row : table.levels) widen(row);
    widen(table.limit);
    std::string out = source::comment_lines(table, "% ");
    out += "\\begin{table}\n  \\centering\n  \\caption{Masks of \\texttt{" + escaped(table.scheme) + "}";
    for (const auto& [key, value] : table.parameters)
      out += ", \\texttt{" + escaped(key) + " = " + escaped(value) + "}";
    out += ": $f^{k+1}_i = \\sum_j a^{[k]}_{i-" + m + "j} f^k_j$, $p = " + source::shift_ratio(table) +
           "$, point $j$ of level $k$ at $(j+p)/" + m + "^k$.";
    if (!table.normalisation.empty()) out += " Normalisation: " + escaped(table.normalisation) + ".";
    out += " " +
           (table.digits > 0 ? std::to_string(table.digits) + " significant digits"
                             : std::string("Correctly rounded doubles")) +
           ".}\n  \\label{tab:" + identifier(options.prefix, table.scheme) + "}\n";
    out += std::string("  \\begin{tabular}{rr") + (wide ? "p{0.8\\linewidth}" : "l") +
           "}\n    \\hline\n    $k$ & $i$ & $a^{[k]}_i$ \\\\\n";
    const auto rows = [&](const std::string& k, const MaskRow& row) {
      out += "    \\hline\n";
      for (std::size_t s = 0; s < row.text.size(); ++s)
        out += "    " + k + " & $" + std::to_string(row.lowest + static_cast<long>(s)) + "$ & " + number(row.text[s]) +
               " \\\\\n";
    };
    for (std::size_t k = 0; k < table.levels.size(); ++k) rows(std::to_string(k), table.levels[k]);
    rows("$\\infty$", table.limit);
    return out + "    \\hline\n  \\end{tabular}\n\\end{table}\n";
  }
};

}  // namespace

const TableWriter& latex_table_writer() {
  static const LatexWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
