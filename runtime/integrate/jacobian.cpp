// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/jacobian.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace kanec::integrate {
namespace {

using Place = std::pair<std::int64_t, std::int64_t>;  // column, row

template <class Blocks>
std::string joined(const Blocks& blocks, const std::string& by) {
  std::string text;
  for (const auto& block : blocks) text += (text.empty() ? "" : by) + block.name;
  return text;
}

}  // namespace

std::vector<Jacobian::Block> Jacobian::rate_blocks(int nx, int ny, bool has_work) {
  std::vector<Block> blocks = {
      {"kinematics_x", 0, 0}, {"kinematics_y", 0, nx}, {"accelerations_x", nx, 0}, {"accelerations_y", nx, nx}};
  if (has_work) blocks.push_back({"power_x", nx + ny, 0});
  if (has_work) blocks.push_back({"power_y", nx + ny, nx});
  return blocks;
}

std::vector<Jacobian::Block> Jacobian::residual_blocks(int nx, int ny, bool has_work) {
  std::vector<Block> blocks = {{"kinematics_x", 0, 0, -1.0},
                               {"kinematics_y", 0, nx, -1.0},
                               {"residual_x", nx, 0},
                               {"residual_y", nx, nx},
                               {"residual_ydot", nx, nx, 1.0, true}};
  if (has_work) blocks.push_back({"power_x", nx + ny, 0, -1.0});
  if (has_work) blocks.push_back({"power_y", nx + ny, nx, -1.0});
  return blocks;
}

std::string Jacobian::request_of_rates(bool has_work) { return joined(rate_blocks(0, 0, has_work), "+"); }
std::string Jacobian::request_of_residual(bool has_work) { return joined(residual_blocks(0, 0, has_work), "+"); }

std::optional<Jacobian> Jacobian::of_rates(const System& system) {
  return made_of(system, rate_blocks(system.nx(), system.ny(), system.has_work()), {});
}

std::optional<Jacobian> Jacobian::of_residual(const System& system) {
  std::vector<int> diagonal;  // where F holds ẋ and the rate of the work themselves
  for (int i = 0; i < system.size(); ++i)
    if (i < system.nx() || i >= system.nx() + system.ny()) diagonal.push_back(i);
  return made_of(system, residual_blocks(system.nx(), system.ny(), system.has_work()), std::move(diagonal));
}

std::optional<Jacobian> Jacobian::made_of(const System& system, const std::vector<Block>& blocks,
                                          std::vector<int> diagonal) {
  Jacobian result;
  result.system_ = &system;
  result.function_ = system.solver().find(joined(blocks, "_and_"));
  if (!result.function_) return std::nullopt;
  std::map<Place, std::vector<Term>> entries;  // in the order of compressed columns
  for (std::int64_t i = 0; i < system.size(); ++i) entries[{i, i}];
  std::int64_t first = 0;
  for (const Block& block : blocks) {
    const kanec_pattern* pattern = system.solver().find_pattern(block.name);
    if (!pattern) return std::nullopt;
    for (int k = 0; k < pattern->nonzeros; ++k) {
      const int row = pattern->row_of[k], column = pattern->column_of[k];
      const std::int64_t source = first + std::int64_t{row} * pattern->columns + column;
      entries[{block.column + column, block.row + row}].push_back({0, source, block.sign, block.by_c});
    }
    first += std::int64_t{pattern->rows} * pattern->columns;
  }
  result.starts_.assign(static_cast<std::size_t>(system.size()) + 1, 0);
  for (auto& [place, terms] : entries) {
    const auto entry = static_cast<std::int64_t>(result.rows_.size());
    for (Term term : terms) {
      term.entry = entry;
      result.terms_.push_back(term);
    }
    if (place.first == place.second && std::binary_search(diagonal.begin(), diagonal.end(), place.first))
      result.by_c_.push_back(entry);
    result.rows_.push_back(place.second);
    result.starts_[static_cast<std::size_t>(place.first) + 1] = entry + 1;
  }
  result.results_.resize(static_cast<std::size_t>(result.function_->n_out));
  result.values_.resize(result.rows_.size());
  return result;
}

bool Jacobian::evaluate(double t, const double* z, const double* zdot, double c) noexcept {
  const int nx = system_->nx();
  system_->solver().evaluate(*function_, t, z, z + nx, zdot ? zdot + nx : nullptr, results_.data());
  ++evaluations_;
  std::fill(values_.begin(), values_.end(), 0.0);
  for (const Term& term : terms_)
    values_[static_cast<std::size_t>(term.entry)] +=
        (term.by_c ? c : term.sign) * results_[static_cast<std::size_t>(term.source)];
  for (const std::int64_t entry : by_c_) values_[static_cast<std::size_t>(entry)] += c;
  return first_not_finite(values_) < 0;
}

}  // namespace kanec::integrate
