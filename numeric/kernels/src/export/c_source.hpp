// SPDX-License-Identifier: 0BSD
// Shared by the writers of C and C++; not installed.
#pragma once

#include <string>
#include <string_view>

#include "twoscale/kernels/export/table_writer.hpp"

namespace twoscale::kernels::c_source {

/// The header comment as one block.
std::string comment_block(const MaskTable& table);

/// A double literal: hexadecimal, or the text as printed when fewer than 17 digits were asked for, else the shortest
/// decimal that a compiler rounds to `value`.
std::string literal(const MaskTable& table, const TableOptions& options, double value, const std::string& text);

/// A long double literal with all printed digits.
std::string long_literal(const std::string& text);

/// True when the texts hold more than a double does.
bool has_long_digits(const MaskTable& table);

/// p as a constant expression: "0.0", "(1.0/2.0)".
std::string shift_expression(const MaskTable& table);

/// The rows between braces, one a line or more, each followed by its level as a comment.
std::string rows(const MaskTable& table, const TableOptions& options, bool long_digits, std::string_view open,
                 std::string_view close);

/// Multiplications and additions of one step for each coarse point (and component), as a sentence.
std::string operation_count(const MaskTable& table);

/// `text` with every "@" replaced by `lower` and every "$" by `upper`.
std::string substituted(std::string_view text, const std::string& lower, const std::string& upper);

std::string upper_case(std::string text);

}  // namespace twoscale::kernels::c_source
