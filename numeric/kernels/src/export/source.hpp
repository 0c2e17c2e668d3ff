// SPDX-License-Identifier: 0BSD
// Shared by the writers of source text; not installed.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/kernels/export/table_writer.hpp"

namespace twoscale::kernels::source {

/// The header comment as one block.
std::string comment_block(const MaskTable& table);

/// The same line by line, each after `mark`; with further lines.
std::string comment_lines(const MaskTable& table, std::string_view mark, const std::vector<std::string>& more = {});

/// A double literal: hexadecimal, or the text as printed when fewer than 17 digits were asked for, else the shortest
/// decimal that a compiler rounds to `value`.
std::string literal(const MaskTable& table, const TableOptions& options, double value, const std::string& text);

/// A long double literal with all printed digits.
std::string long_literal(const std::string& text);

/// True when the texts hold more than a double does.
bool has_long_digits(const MaskTable& table);

/// p as a constant expression: "0.0", "(1.0/2.0)".
std::string shift_expression(const MaskTable& table);

/// How a list of rows is spelled: what stands around a row, what between rows, and a comment before each.
struct RowStyle {
  std::string_view open, close;
  std::string_view between = ",";
  std::string_view comment_open = "// ", comment_close = "";
};

/// `count` items a row, levels 0..levels-1 and the limit, one line a row or more, each row after its level as a
/// comment.
std::string rows(std::size_t levels, std::size_t count, const RowStyle& style,
                 const std::function<std::string(std::size_t row, std::size_t column)>& item);

/// The same with the doubles of the table, padded to the common support: as `literal` spells them, or, when
/// long_digits, as long_literal does.
std::string rows(const MaskTable& table, const TableOptions& options, bool long_digits, const RowStyle& style);

/// A double as a decimal that reads back, with a point or an exponent: "1.0".
std::string decimal(double value);

/// p as an expression of integers: "0", "1/2".
std::string shift_ratio(const MaskTable& table);

/// Multiplications and additions of one step for each coarse point (and component), as a sentence.
std::string operation_count(const MaskTable& table);

/// `text` with every "@" replaced by `lower` and every "$" by `upper`.
std::string substituted(std::string_view text, const std::string& lower, const std::string& upper);

std::string upper_case(std::string text);

}  // namespace twoscale::kernels::source
