// SPDX-License-Identifier: GPL-3.0-or-later
#include "derivation.hpp"

#include <sstream>

#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale::cli {

using Json = nlohmann::ordered_json;

namespace {

constexpr long decimal_digits = 17;

std::string decimal_of_angle(const Rational& angle) {
  return ExactReal::apply(ExactReal::Function::cos, ExactReal(angle) * ExactReal::pi()).decimal(decimal_digits);
}

Json matrix_json(const std::vector<std::vector<RationalFunction>>& matrix) {
  Json rows = Json::array();
  for (const auto& row : matrix) {
    Json r = Json::array();
    for (const auto& x : row) r.push_back(x.to_string());
    rows.push_back(r);
  }
  return rows;
}

Json list_json(const std::vector<RationalFunction>& list) {
  Json r = Json::array();
  for (const auto& x : list) r.push_back(x.to_string());
  return r;
}

// "  a_-3 = a_3 = -1/(8*v*(v + 1))" for a symmetric mask, one line a coefficient otherwise.
void print_mask(std::ostringstream& out, const std::string& name, const Laurent& a) {
  const auto centre = a.centre_of_symmetry();
  for (long i = a.lowest(); i <= a.highest(); ++i) {
    const long mirror = a.lowest() + a.highest() - i;
    if (centre && mirror < i) break;
    out << "  " << name << "_" << i;
    if (centre && mirror != i) out << " = " << name << "_" << mirror;
    out << " = " << a.coefficient(i).to_string() << "\n";
  }
}

std::string tex(const RationalFunction& f) { return f.to_string(Polynomial::Style::latex); }

std::string tex_matrix(const std::vector<std::vector<RationalFunction>>& matrix) {
  std::string s = "\\begin{pmatrix}\n";
  for (const auto& row : matrix) {
    for (size_t i = 0; i < row.size(); ++i) s += (i == 0 ? "  " : " & ") + tex(row[i]);
    s += " \\\\\n";
  }
  return s + "\\end{pmatrix}";
}

std::string tex_column(const std::vector<RationalFunction>& column) {
  std::vector<std::vector<RationalFunction>> rows;
  for (const auto& x : column) rows.push_back({x});
  return tex_matrix(rows);
}

// Lines "\sigma_{-1} &= ..., \\" of an align environment.
std::string tex_mask(const std::string& name, const Laurent& a) {
  std::string s;
  const auto centre = a.centre_of_symmetry();
  for (long i = a.lowest(); i <= a.highest(); ++i) {
    const long mirror = a.lowest() + a.highest() - i;
    if (centre && mirror < i) break;
    if (a.coefficient(i).is_zero()) continue;
    s += s.empty() ? "" : " \\\\\n";
    s += "  " + name + "_{" + std::to_string(i) + "}";
    if (centre && mirror != i) s += " = " + name + "_{" + std::to_string(mirror) + "}";
    s += " &= " + tex(a.coefficient(i));
  }
  return s;
}

std::string tex_meaning(const LevelVariable& v, int arity) {
  const std::string unit = v.symbol.empty() ? (v.unit == "1"    ? ""
                                               : v.unit == "pi" ? "\\pi"
                                                                : v.unit)
                                            : latex_name(v.symbol);
  const std::string factor =
      v.factor == Rational(1) && !unit.empty() ? "" : RationalFunction(v.factor).to_string(Polynomial::Style::latex);
  return latex_name(v.name) + " = " + latex_name(v.name) + "^{[k+1]} = \\" + (v.trigonometric ? "cos" : "cosh") +
         "\\frac{" + factor + unit + "}{" + std::to_string(arity) + "^{k+1}}";
}

std::string tex_recurrence(const LevelVariable& v, int arity) {
  const std::string name = latex_name(v.name);
  if (arity == 2) return name + "^{[k+1]} = \\sqrt{\\frac{1+" + name + "^{[k]}}{2}}";
  return name + "^{[k]} = T_{" + std::to_string(arity) + "}(" + name + "^{[k+1]})";
}

std::string singular_text(const SingularSet& s) {
  std::string t;
  for (const auto& v : s.values) t += (t.empty() ? "" : ", ") + v.exact() + " (level " + std::to_string(v.level) + ")";
  for (const auto& c : s.conditions) t += (t.empty() ? "" : ", ") + c.pretty() + " = 0";
  return t.empty() ? "none" : t;
}

}  // namespace

Derivation derive(const Space& space, int arity, std::string scheme) {
  Derivation d;
  d.scheme = std::move(scheme);
  d.space = space;
  d.arity = arity;
  d.sigma = bspline_symbol(space, arity);
  if (arity != 2) return d;
  d.singular = singular_set(space);
  if (space.dimension() % 2 == 0) {
    Derivation::Interpolating i;
    i.system = hessenberg_system(space);
    i.folded = folded_system(space);
    i.folded_determinant = folded_determinant(space, i.folded);
    i.zeta = interpolating_symbol(space);
    d.interpolating = std::move(i);
  }
  return d;
}

std::vector<long> impossible_polygons(const SingularSet& singular) {
  std::vector<long> n;
  for (const auto& v : singular.values)
    if (const Rational count = Rational(2) / v.angle; count.is_integer() && (n.empty() || n.back() != count.to_long()))
      n.push_back(count.to_long());
  return n;
}

Json laurent_json(const Laurent& a) {
  Json c = Json::array();
  // A symmetric mask prints each value once.
  const bool symmetric = a.centre_of_symmetry().has_value();
  std::vector<std::string> text(a.coefficients().size());
  for (size_t i = 0; i < text.size(); ++i)
    text[i] = symmetric && 2 * i >= text.size() ? text[text.size() - 1 - i] : a.coefficients()[i].to_string();
  for (auto& t : text) c.push_back(std::move(t));
  return Json::object({{"lowest", a.lowest()}, {"coefficients", std::move(c)}});
}

Json to_json(const Derivation& d) {
  Json j;
  j["format"] = "twoscale/derivation";
  j["version"] = 1;
  j["scheme"] = d.scheme;
  j["arity"] = d.arity;
  j["space"] = d.space.items();
  Json variables = Json::object();
  for (const auto& v : d.space.variables()) variables[v.name] = v.meaning(d.arity);
  j["level_variables"] = variables;
  j["p"] = Scheme::from_symbol("sigma", d.sigma, d.arity, {}).shift.to_string();
  j["sigma"] = laurent_json(d.sigma);
  if (d.interpolating) {
    const auto& i = *d.interpolating;
    j["omega"] = laurent_json(i.system.omega);
    j["zeta"] = laurent_json(i.zeta);
    Json nodes = Json::array();
    for (const auto& g : i.system.nodes) nodes.push_back(g.pretty());
    j["system"] = Json::object({{"basis", "newton"},
                                {"nodes", nodes},
                                {"matrix", matrix_json(i.system.matrix)},
                                {"rhs", list_json(i.system.rhs)},
                                {"solution", list_json(i.system.solution)},
                                {"determinant", i.system.determinant.to_string()},
                                {"hessenberg", true}});
    j["folded"] = Json::object({{"matrix", matrix_json(i.folded.matrix)},
                                {"rhs", list_json(i.folded.rhs)},
                                {"determinant", i.folded_determinant.to_string()},
                                {"hessenberg", i.folded.hessenberg}});
  } else {
    j["omega"] = nullptr;
    j["zeta"] = nullptr;
  }
  if (d.space.variables().size() > 1) {
    Json list = Json::array();
    for (const auto& c : d.singular.conditions)
      list.push_back(
          Json::object({{"condition", c.pretty()}, {"from", d.interpolating ? "determinant" : "normalisation"}}));
    j["singular"] = list;
  } else {
    Json list = Json::array();
    for (const auto& v : d.singular.values)
      list.push_back(Json::object({{"exact", v.exact()}, {"decimal", decimal_of_angle(v.angle)}, {"level", v.level}}));
    j["singular_v0"] = list;
  }
  return j;
}

std::string to_text(const Derivation& d) {
  std::ostringstream out;
  out << "space      {" << d.space.to_string() << "}, dimension " << d.space.dimension() << "\n";
  out << "arity      " << d.arity << "\n";
  for (const auto& v : d.space.variables())
    out << "level      " << v.name << " = " << v.meaning(d.arity) << ", " << recurrence(v.name, d.arity) << "\n";
  const Scheme sigma = Scheme::from_symbol("sigma", d.sigma, d.arity, {});
  out << "\nsigma, approximating, support [" << d.sigma.lowest() << ", " << d.sigma.highest()
      << "], p = " << sigma.shift.to_string() << ", generates the space\n";
  print_mask(out, "sigma", d.sigma);
  if (d.interpolating) {
    const auto& i = *d.interpolating;
    out << "\nomega, from the Hessenberg system H w = w_0 e_l in the Newton basis, det H = "
        << i.system.determinant.to_string() << "\n";
    out << "  nodes ";
    for (const auto& g : i.system.nodes) out << " " << g.pretty();
    out << "\n";
    for (size_t m = 0; m < i.system.solution.size(); ++m)
      out << "  w_" << m << " = " << i.system.solution[m].to_string() << "\n";
    print_mask(out, "omega", i.system.omega);
    out << "\nzeta = sigma*omega, " << d.space.dimension() << "-point interpolating, support [" << i.zeta.lowest()
        << ", " << i.zeta.highest() << "], p = 0, reproduces the space\n";
    print_mask(out, "zeta", i.zeta);
  } else if (d.arity == 2) {
    out << "\nno interpolating 2l-point scheme: the dimension is odd (sigma is dual)\n";
  }
  if (d.arity == 2) {
    if (!d.space.variables().empty())
      out << "\nsingular   " << (d.space.variables().size() > 1 ? "" : "v0 = ") << singular_text(d.singular) << "\n";
    const auto n = impossible_polygons(d.singular);
    if (!n.empty()) {
      out << "           a closed trigonometric curve sampled at 2*pi/N cannot start from N =";
      for (const long k : n) out << " " << k;
      out << " points\n";
    }
  }
  return out.str();
}

std::string to_latex(const Derivation& d) {
  std::string s = "% " + d.scheme + "\n";
  s += "Let $V = \\operatorname{span}\\{" + d.space.to_latex() +
       "\\}$, $\\dim V = " + std::to_string(d.space.dimension()) + "$";
  for (const auto& v : d.space.variables())
    s += ",\n$" + tex_meaning(v, d.arity) + "$ with $" + tex_recurrence(v, d.arity) + "$";
  s += ".\nThe approximating scheme with mask\n\\begin{align*}\n" + tex_mask("\\sigma", d.sigma) +
       "\n\\end{align*}\ngenerates $V$.\n";
  if (d.interpolating) {
    const auto& i = *d.interpolating;
    const size_t l = i.system.nodes.size();
    s += "With $\\gamma = (";
    for (size_t k = 0; k < l; ++k) s += (k == 0 ? "" : ", ") + i.system.nodes[k].pretty(Polynomial::Style::latex);
    s += ")$ and $\\omega(z) = \\sum_{m=0}^{" + std::to_string(l - 1) + "} w_m z^{" + std::to_string(l - 1) +
         "-m}\\prod_{i<m}(z^2-\\gamma_i z+1)$ the linear system reads\n\\[\n" + tex_matrix(i.system.matrix) +
         " w = " + tex_column(i.system.rhs) + ",\n\\qquad \\det = " + tex(i.system.determinant) +
         ",\n\\]\nand is solved by\n\\[\nw = " + tex_column(i.system.solution) + ".\n\\]\nHence\n\\begin{align*}\n" +
         tex_mask("\\omega", i.system.omega) + "\n\\end{align*}\nand $\\zeta(z) = \\sigma(z)\\omega(z)$ is the " +
         std::to_string(d.space.dimension()) + "-point interpolating scheme with $\\zeta_0 = 1$,\n\\begin{align*}\n";
    const Laurent odd = i.zeta - Laurent::monomial(0);
    s += tex_mask("\\zeta", odd) + "\n\\end{align*}\n";
    if (!d.singular.values.empty()) {
      s += "It exists for all $v^0 \\in (-1, \\infty)$ but\n$";
      for (size_t k = 0; k < d.singular.values.size(); ++k) {
        const auto& v = d.singular.values[k];
        std::string exact = v.exact();
        if (exact.starts_with("cos(")) {
          const Rational top(v.angle.numerator());
          exact = "\\cos\\tfrac{" + (top == Rational(1) ? std::string() : top.to_string()) + "\\pi}{" +
                  Rational(v.angle.denominator()).to_string() + "}";
        } else if (exact.ends_with("1/2")) {
          exact = exact.starts_with("-") ? "-\\tfrac12" : "\\tfrac12";
        }
        s += (k == 0 ? "" : ",\\ ") + exact + "\\ (k=" + std::to_string(v.level) + ")";
      }
      s += "$.\n";
    }
    if (!d.singular.conditions.empty()) {
      s += "A step exists where none of these vanishes: $";
      for (size_t k = 0; k < d.singular.conditions.size(); ++k)
        s += (k == 0 ? "" : ",\\ ") + d.singular.conditions[k].pretty(Polynomial::Style::latex);
      s += "$.\n";
    }
  }
  return s;
}

std::string to_markdown(const Derivation& d) {
  std::ostringstream out;
  out << "# " << d.scheme << "\n\n";
  out << "Space: `" << d.space.to_string() << "`, dimension " << d.space.dimension() << ".\n\n";
  for (const auto& v : d.space.variables())
    out << "Level variable: `" << v.name << " = " << v.meaning(d.arity) << "`, `" << recurrence(v.name, d.arity)
        << "`.\n\n";
  const auto table = [&](const std::string& name, const Laurent& a) {
    out << "| i | " << name << "_i |\n|---|---|\n";
    for (long i = a.lowest(); i <= a.highest(); ++i)
      out << "| " << i << " | `" << a.coefficient(i).to_string() << "` |\n";
    out << "\n";
  };
  out << "## Approximating scheme sigma\n\n";
  table("sigma", d.sigma);
  if (d.interpolating) {
    out << "## Hessenberg system (Newton basis)\n\n| row | entries |\n|---|---|\n";
    for (size_t r = 0; r < d.interpolating->system.matrix.size(); ++r) {
      out << "| " << r + 1 << " |";
      for (const auto& x : d.interpolating->system.matrix[r]) out << " `" << x.to_string() << "`";
      out << " |\n";
    }
    out << "\ndet H = `" << d.interpolating->system.determinant.to_string() << "`\n\n";
    out << "## omega\n\n";
    table("omega", d.interpolating->system.omega);
    out << "## Interpolating scheme zeta\n\n";
    table("zeta", d.interpolating->zeta);
  }
  if (d.arity == 2) out << "Singular: " << singular_text(d.singular) << "\n";
  return out.str();
}

}  // namespace twoscale::cli
