// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/reports/derivation.hpp"

#include <sstream>

#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale::reports {

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
  d.singular = singular_set(space, arity);
  if (has_interpolating_scheme(space, arity)) {
    Derivation::Interpolating i;
    i.system = hessenberg_system(space, arity);
    i.folded = folded_system(space, arity);
    i.folded_determinant = folded_determinant(space, i.folded, arity);
    i.zeta = interpolating_symbol(space, arity);
    d.interpolating = std::move(i);
  }
  return d;
}

Derivation derive(const Scheme& scheme) {
  const Laurent mask = symbol(scheme);
  if (!scheme.reproduced) {
    Derivation d = derive(*scheme.space, scheme.arity, scheme.id);
    if (!(mask == d.sigma) && !(d.interpolating && mask == d.interpolating->zeta)) d.mask = mask;
    return d;
  }
  Derivation d;
  d.scheme = scheme.id;
  d.arity = scheme.arity;
  d.quasi = quasi_spline(*scheme.space, *scheme.reproduced);
  d.space = d.quasi->space;
  d.sigma = bspline_symbol(d.space, d.arity);
  d.singular = d.quasi->singular;
  d.mask = mask;
  const auto factor = Laurent::quotient(mask, d.quasi->beta);
  if (factor && !(*factor == d.quasi->q)) d.factor = *factor;
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
  if (d.quasi) {
    const QuasiSpline& s = *d.quasi;
    Json nodes = Json::array();
    for (const auto& g : s.nodes) nodes.push_back(g.pretty());
    j["reproduced"] = s.reproduced.items();
    j["beta"] = laurent_json(s.beta);
    j["system"] = Json::object({{"basis", "newton"},
                                {"nodes", nodes},
                                {"matrix", matrix_json(s.matrix)},
                                {"rhs", list_json(s.rhs)},
                                {"solution", list_json(s.solution)},
                                {"determinant", s.determinant.to_string()}});
    j["q"] = laurent_json(s.q);
    if (d.factor) j["factor"] = laurent_json(*d.factor);
  }
  if (d.mask) j["mask"] = laurent_json(*d.mask);
  if (d.space.variables().size() > 1) {
    Json list = Json::array();
    for (const auto& c : d.singular.conditions)
      list.push_back(Json::object(
          {{"condition", c.pretty()}, {"from", d.interpolating || d.quasi ? "determinant" : "normalisation"}}));
    j["singular"] = list;
  } else {
    Json list = Json::array();
    for (const auto& v : d.singular.values)
      list.push_back(Json::object({{"exact", v.exact()}, {"decimal", decimal_of_angle(v.angle)}, {"level", v.level}}));
    j["singular_v0"] = list;
  }
  return j;
}

namespace {

void print_singular(std::ostringstream& out, const Derivation& d) {
  if (!d.space.variables().empty())
    out << "\nsingular   " << (d.space.variables().size() > 1 ? "" : "v0 = ") << singular_text(d.singular) << "\n";
  // Of a dual scheme v^0 may belong to half the frequency: no polygon is named then.
  const auto n = d.quasi && d.quasi->order() % 2 == 1 ? std::vector<long>() : impossible_polygons(d.singular);
  if (!n.empty()) {
    out << "           a closed trigonometric curve sampled at 2*pi/N cannot start from N =";
    for (const long k : n) out << " " << k;
    out << " points\n";
  }
}

// The equations that the factor of a quasi-spline solves, for people.
std::string quasi_condition(const QuasiSpline& s) {
  return s.order() % 2 == 0 ? "S(x) q(x) = 2, S(x) = beta(z)"
                            : "S(x) q(x) = 2/(z^(1/2) + z^(-1/2)), S(x) = beta(z)/(1 + z)";
}

void print_quasi(std::ostringstream& out, const Derivation& d, const std::string& p) {
  const QuasiSpline& s = *d.quasi;
  out << "reproduced {" << s.reproduced.to_string() << "}, M = " << s.terms() << "\n";
  out << "\nbeta, exponential B-spline of order " << s.order() << " as jeong2013 (3), support [" << s.beta.lowest()
      << ", " << s.beta.highest() << "], p = " << p << ", generates the space\n";
  print_mask(out, "beta", s.beta);
  out << "\nq, from " << quasi_condition(s)
      << ", x = z + 1/z, at the nodes in the Newton basis: H w = F, det H = " << s.determinant.to_string()
      << "\n  nodes ";
  for (const auto& g : s.nodes) out << " " << g.pretty();
  out << "\n";
  for (size_t r = 0; r < s.rhs.size(); ++r) {
    out << "  H row " << r << " =";
    for (size_t m = 0; m <= r; ++m) out << (m == 0 ? " " : ", ") << s.matrix[r][m].to_string();
    out << "; F_" << r << " = " << s.rhs[r].to_string() << "\n";
  }
  for (size_t m = 0; m < s.solution.size(); ++m) out << "  w_" << m << " = " << s.solution[m].to_string() << "\n";
  print_mask(out, "q", s.q);
  if (d.factor) {
    out << "\nfactor of this scheme, another one that solves the equations\n";
    print_mask(out, "f", *d.factor);
  }
  const bool interpolating = !d.factor && s.order() == 2 * s.terms();
  out << "\na = beta*" << (d.factor ? "f" : "q") << ", "
      << (interpolating ? std::to_string(s.order()) + "-point interpolating, " : std::string()) << "support ["
      << d.mask->lowest() << ", " << d.mask->highest() << "], p = " << p << ", reproduces {" << s.reproduced.to_string()
      << "}\n";
  print_mask(out, "a", *d.mask);
  print_singular(out, d);
}

}  // namespace

std::string to_text(const Derivation& d) {
  std::ostringstream out;
  out << "space      {" << d.space.to_string() << "}, dimension " << d.space.dimension() << "\n";
  out << "arity      " << d.arity << "\n";
  for (const auto& v : d.space.variables())
    out << "level      " << v.name << " = " << v.meaning(d.arity) << ", " << recurrence(v.name, d.arity) << "\n";
  const Scheme sigma = Scheme::from_symbol("sigma", d.sigma, d.arity, {});
  if (d.quasi) {
    print_quasi(out, d, sigma.shift.to_string());
    return out.str();
  }
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
  } else {
    out << "\nno interpolating scheme: the dimension is odd" << (d.arity == 2 ? "" : ", the arity even")
        << " (sigma is dual)\n";
  }
  if (d.mask) {
    out << "\na, the mask of the scheme, support [" << d.mask->lowest() << ", " << d.mask->highest() << "]\n";
    print_mask(out, "a", *d.mask);
  }
  print_singular(out, d);
  return out.str();
}

namespace {

std::string tex_singular(const SingularSet& singular) {
  std::string s;
  if (!singular.values.empty()) {
    s += "It exists for all $v^0 \\in (-1, \\infty)$ but\n$";
    for (size_t k = 0; k < singular.values.size(); ++k) {
      const auto& v = singular.values[k];
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
  if (!singular.conditions.empty()) {
    s += "A step exists where none of these vanishes: $";
    for (size_t k = 0; k < singular.conditions.size(); ++k)
      s += (k == 0 ? "" : ",\\ ") + singular.conditions[k].pretty(Polynomial::Style::latex);
    s += "$.\n";
  }
  return s;
}

std::string tex_quasi(const Derivation& d) {
  const QuasiSpline& q = *d.quasi;
  const std::string last = std::to_string(q.terms() - 1);
  const bool even = q.order() % 2 == 0;
  std::string s = "The exponential B-spline with mask\n\\begin{align*}\n" + tex_mask("\\beta", q.beta) +
                  "\n\\end{align*}\ngenerates $V$. To reproduce $\\operatorname{span}\\{" + q.reproduced.to_latex() +
                  "\\}$ it is multiplied by\n$q(z) = \\sum_{m=0}^{" + last +
                  "} w_m \\prod_{i<m}(z+z^{-1}-\\gamma_i)$ with $\\gamma = (";
  for (size_t k = 0; k < q.nodes.size(); ++k) s += (k == 0 ? "" : ", ") + q.nodes[k].pretty(Polynomial::Style::latex);
  s += std::string(")$, the Hermite interpolant at $\\gamma$ of\n$") + (even ? "2/\\beta(z)" : "2z^{1/2}/\\beta(z)") +
       "$ as a function of $z+z^{-1}$:\n\\[\n" + tex_matrix(q.matrix) + " w = " + tex_column(q.rhs) +
       ",\n\\qquad \\det = " + tex(q.determinant) + ",\n\\qquad w = " + tex_column(q.solution) + ".\n\\]\n";
  s += "Hence\n\\begin{align*}\n" + tex_mask("q", q.q) + ",\n\\end{align*}\n";
  if (d.factor)
    s += "and the factor of this scheme,\n\\begin{align*}\n" + tex_mask("f", *d.factor) +
         ",\n\\end{align*}\nsolves the same equations. ";
  s += "The scheme is\n\\begin{align*}\n" + tex_mask("a", *d.mask) + ".\n\\end{align*}\n";
  return s + tex_singular(d.singular);
}

}  // namespace

std::string to_latex(const Derivation& d) {
  std::string s = "% " + d.scheme + "\n";
  s += "Let $V = \\operatorname{span}\\{" + d.space.to_latex() +
       "\\}$, $\\dim V = " + std::to_string(d.space.dimension()) + "$";
  for (const auto& v : d.space.variables())
    s += ",\n$" + tex_meaning(v, d.arity) + "$ with $" + tex_recurrence(v, d.arity) + "$";
  if (d.quasi) return s + ".\n" + tex_quasi(d);
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
    s += tex_singular(d.singular);
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
  if (d.quasi) {
    const QuasiSpline& s = *d.quasi;
    out << "Reproduced: `" << s.reproduced.to_string() << "`, M = " << s.terms() << ".\n\n";
    out << "## Exponential B-spline beta\n\n";
    table("beta", s.beta);
    out << "## System (Newton basis)\n\n`" << quasi_condition(s)
        << "`, x = z + 1/z\n\n| node | row | F | w |\n|---|---|---|---|\n";
    for (size_t r = 0; r < s.nodes.size(); ++r) {
      out << "| `" << s.nodes[r].pretty() << "` |";
      for (size_t m = 0; m <= r; ++m) out << " `" << s.matrix[r][m].to_string() << "`";
      out << " | `" << s.rhs[r].to_string() << "` | `" << s.solution[r].to_string() << "` |\n";
    }
    out << "\ndet = `" << s.determinant.to_string() << "`\n\n## q\n\n";
    table("q", s.q);
    if (d.factor) {
      out << "## Factor of this scheme\n\n";
      table("f", *d.factor);
    }
    out << "## Mask\n\n";
    table("a", *d.mask);
    out << "Singular: " << singular_text(d.singular) << "\n";
    return out.str();
  }
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
  if (d.mask) {
    out << "## Mask of the scheme\n\n";
    table("a", *d.mask);
  }
  out << "Singular: " << singular_text(d.singular) << "\n";
  return out.str();
}

}  // namespace twoscale::reports
