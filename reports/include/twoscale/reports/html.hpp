// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a static page: escaped text, typeset formulas, embedded pictures. All output is well-formed XML.
#pragma once

#include <string>
#include <string_view>

namespace twoscale::reports {

// & < > " replaced by entities; control characters by blanks.
std::string escaped(std::string_view text);

// A MathML element for an expression of the contract (§2): sums, products, quotients, powers, names, integers, calls
// such as cos(2*pi/5). Names v_s get a subscript, pi and theta their letters. Throws Error(bad_input) naming what
// cannot be read.
std::string mathml(std::string_view expression);

// The same inside <math>...</math>, after a left side that is MathML already (may be empty).
std::string formula(const std::string& left_mathml, std::string_view expression);

// data:image/svg+xml;base64,... of any bytes.
std::string data_uri(std::string_view bytes, const std::string& type = "image/svg+xml");

}  // namespace twoscale::reports
