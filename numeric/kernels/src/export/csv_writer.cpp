// SPDX-License-Identifier: 0BSD
// Mask tables as CSV: comment lines (#), then k,index,value with k = limit for the limit row.
#include "twoscale/kernels/export/table_writer.hpp"

namespace twoscale::kernels {
namespace {

class CsvWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "csv"; }
  std::string_view suffix() const override { return "csv"; }

  std::string write(const MaskTable& table, const TableOptions&) const override {
    validate(table);
    std::string out;
    for (const std::string& line : header_lines(table)) out += "# " + line + "\n";
    out += "k,index,value\n";
    const auto add = [&](const std::string& k, const MaskRow& row) {
      for (std::size_t s = 0; s < row.text.size(); ++s) {
        out += k + "," + std::to_string(row.lowest + static_cast<long>(s)) + "," + row.text[s] + "\n";
      }
    };
    for (std::size_t k = 0; k < table.levels.size(); ++k) add(std::to_string(k), table.levels[k]);
    add("limit", table.limit);
    return out;
  }
};

}  // namespace

const TableWriter& csv_table_writer() {
  static const CsvWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
