// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/reductions.hpp"

#include "runtime/text/table.hpp"

namespace kanec {

std::string reductions_text(const std::string& scene, const std::vector<Reduction>& reductions) {
  if (reductions.empty()) return scene + ": nothing to reduce\n";
  std::vector<TextRow> rows = {{"reduction", "operations saved", "what"}};
  for (const Reduction& reduction : reductions)
    rows.push_back({reduction.name, std::to_string(reduction.operations_saved), reduction.what});
  return scene + "\n\n" + text_table(rows, "lrl");
}

Json reductions_json(const std::string& scene, const std::vector<Reduction>& reductions) {
  Json list = Json::array();
  for (const Reduction& reduction : reductions)
    list.push_back(
        {{"name", reduction.name}, {"what", reduction.what}, {"operations_saved", reduction.operations_saved}});
  return {{"model", scene}, {"reductions", std::move(list)}};
}

}  // namespace kanec
