// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale report hermite2010 -o DIR.
#pragma once

#include "session.hpp"
#include "twoscale/reports/checker.hpp"

namespace twoscale::cli {

// Exit status 1 if a certificate is not accepted by the checker.
int report_hermite2010(const Common& common, const reports::Checker& checker);

}  // namespace twoscale::cli
