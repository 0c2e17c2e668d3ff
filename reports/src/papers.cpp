// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/reports/papers.hpp"

#include "twoscale/reports/beccari2007.hpp"
#include "twoscale/reports/hermite2010.hpp"
#include "twoscale/reports/jeong2013.hpp"
#include "twoscale/reports/nuli.hpp"
#include "twoscale/reports/romani2009.hpp"

namespace twoscale::reports {

const std::vector<Paper>& papers() {
  static const std::vector<Paper> list = {
      {"beccari2007",
       "C. Beccari, G. Casciola, L. Romani: A non-stationary uniform tension controlled interpolating 4-point scheme "
       "reproducing conics",
       "curve", beccari2007::write_report},
      {"hermite2010", "L. Romani: A circle-preserving C² Hermite interpolatory subdivision scheme with tension control",
       "circle", hermite2010::write_report},
      {"jeong2013",
       "B. Jeong, Y. J. Lee, J. Yoon: A family of non-stationary subdivision schemes reproducing exponential "
       "polynomials",
       "surface", jeong2013::write_report},
      {"nuli",
       "C. V. Beccari, G. Casciola, L. Romani: Non-uniform interpolatory curve subdivision with edge parameters built "
       "upon compactly supported fundamental splines",
       "polynomial", nuli::write_report},
      {"romani2009",
       "L. Romani: From approximating subdivision schemes for exponential splines to high-performance interpolating "
       "algorithms",
       "curve", romani2009::write_report}};
  return list;
}

const Paper* find_paper(const std::string& name) {
  for (const Paper& p : papers())
    if (p.name == name) return &p;
  return nullptr;
}

}  // namespace twoscale::reports
