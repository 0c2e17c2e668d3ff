// SPDX-License-Identifier: 0BSD
// The header line of CSV points files; not installed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twoscale::kernels::csv {

/// Column names (default_columns when there are none) and the end of the line.
std::string head(const std::vector<std::string>& columns, std::size_t dim);

}  // namespace twoscale::kernels::csv
