// SPDX-License-Identifier: 0BSD
// Mask tables as a structured NumPy array, one row a level; level -1 is the limit.
#include <cstdint>

#include "npy.hpp"
#include "twoscale/kernels/export/table_writer.hpp"

namespace twoscale::kernels {
namespace {

class NpyWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "npy"; }
  std::string_view suffix() const override { return "npy"; }
  bool binary() const override { return true; }

  std::string write(const MaskTable& table, const TableOptions&) const override {
    validate(table);
    const TableGrid grid = common_grid(table);
    const std::size_t count = static_cast<std::size_t>(grid.highest - grid.lowest + 1);
    std::string comment;
    for (const std::string& line : header_lines(table)) comment += (comment.empty() ? "" : " | ") + line;
    if (comment.size() > 8000) comment.resize(8000);  // NumPy refuses headers beyond 10000 bytes
    std::string descr = "[('level', '<i4'), ('lowest', '<i4'), ('coefficients', '<f8', (";
    descr += std::to_string(count);
    descr += ",))]";
    std::string shape = "(";
    shape += std::to_string(grid.value.size());
    shape += ",)";
    std::string out = npy::preamble(descr, shape, comment);
    for (std::size_t k = 0; k < grid.value.size(); ++k) {
      npy::append(out, k < table.levels.size() ? static_cast<std::int32_t>(k) : std::int32_t{-1});
      npy::append(out, static_cast<std::int32_t>(grid.lowest));
      for (const double value : grid.value[k]) npy::append(out, value);
    }
    return out;
  }
};

}  // namespace

const TableWriter& npy_table_writer() {
  static const NpyWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
