// SPDX-License-Identifier: 0BSD
// Mask tables as JSON: {"format": "twoscale/mask-table", "version": 1, ...}.
#include <nlohmann/json.hpp>

#include "twoscale/kernels/export/table_writer.hpp"
#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels {
namespace {

using Json = nlohmann::ordered_json;

Json object(const std::vector<std::pair<std::string, std::string>>& items) {
  Json out = Json::object();
  for (const auto& [name, text] : items) out[name] = text;
  return out;
}

void fill_row(Json& out, const MaskRow& row, bool doubles) {
  out["lowest"] = row.lowest;
  out["coefficients"] = row.text;
  if (doubles) {
    Json hex = Json::array();
    for (const double value : row.value) hex.push_back(hex_float(value));
    out["hex"] = std::move(hex);
  }
}

class JsonWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "json"; }
  std::string_view suffix() const override { return "json"; }

  std::string write(const MaskTable& table, const TableOptions&) const override {
    validate(table);
    const bool doubles = table.digits == 0;
    Json out;
    out["format"] = "twoscale/mask-table";
    out["version"] = 1;
    out["generator"] = "twoscale";
    out["licence"] = "0BSD: this output is free for any use";
    out["scheme"] = table.scheme;
    out["arity"] = table.arity;
    out["p"] = table.shift;
    out["rule"] = "f^{k+1}_i = sum_j a^{[k]}_{i-" + std::to_string(table.arity) + "*j} f^k_j";
    out["parameters"] = object(table.parameters);
    out["level_variables"] = object(table.level_variables);
    if (!table.recurrence.empty()) out["recurrence"] = table.recurrence;
    if (!table.printed.empty()) out["printed"] = table.printed;
    if (!table.normalisation.empty()) out["normalisation"] = table.normalisation;
    Json precision = Json::object();
    precision["digits"] = doubles ? 17 : table.digits;
    if (doubles) precision["double"] = true;  // correctly rounded doubles, shortest decimals that read back
    precision["error"] = table.precision_error;
    out["precision"] = std::move(precision);
    Json levels = Json::array();
    for (std::size_t k = 0; k < table.levels.size(); ++k) {
      Json level;
      level["k"] = k;
      fill_row(level, table.levels[k], doubles);
      levels.push_back(std::move(level));
    }
    out["levels"] = std::move(levels);
    Json limit;
    fill_row(limit, table.limit, doubles);
    out["limit"] = std::move(limit);
    out["tail"]["from"] = table.tail_from;
    out["tail"]["bound"] = table.tail_bound;
    return out.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
  }
};

}  // namespace

const TableWriter& json_table_writer() {
  static const JsonWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
