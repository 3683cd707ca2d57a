// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/rolled.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "generator/program/builder.hpp"
#include "generator/program/passes.hpp"
#include "runtime/base/error.hpp"

namespace kanec::program {
namespace {

class Rolling {
 public:
  Rolling(const Program& program, const Function& function)
      : program_(program),
        function_(function),
        stages_(stages(program)),
        sections_(sections(program, function, stages_)),
        signs_(program, function, stages_),
        crosses_(program.nodes.size(), false),
        place_(program.nodes.size(), -1) {}

  Rolled result() {
    classify();
    for (std::size_t c = 0; c < members_.size(); ++c) name_fields(c);
    lay_out_frames();
    for (std::size_t c = 0; c < members_.size(); ++c) result_.classes.push_back(made(c));
    for (const Canonical& form : forms_) result_.operations += form.operations.size();
    for (const auto& members : members_) result_.written += forms_[members[0]].operations.size();
    return std::move(result_);
  }

 private:
  using Members = std::vector<std::size_t>;  // sections

  void classify() {
    std::map<std::vector<std::int64_t>, std::size_t> known;
    std::map<std::pair<Pass, int>, int> runs;  // sections before, by pass and body
    for (std::size_t i = 0; i < sections_.list.size(); ++i) {
      const Section& section = sections_.list[i];
      forms_.push_back(canonical(program_, sections_, i, stages_, signs_));
      class_of_.push_back(0);
      Canonical& form = forms_.back();
      ordinal_.push_back(runs[{section.pass, section.body}]++);
      n_frames_ = std::max(n_frames_, at(std::max(section.body, 0)) + 1);
      if (form.operations.empty() && section.stores.empty()) continue;
      form.key.push_back(static_cast<std::int64_t>(section.pass));
      form.key.push_back(ordinal_.back());
      form.key.push_back(section.body > 0);
      for (const Store& store : section.stores) form.key.push_back(result_of(store.output));
      const auto [found, is_new] = known.emplace(form.key, members_.size());
      if (is_new) members_.emplace_back();
      result_.steps.push_back({found->second, members_[found->second].size()});
      members_[found->second].push_back(i);
      class_of_.back() = found->second;
      for (std::size_t p = 0; p < form.operations.size(); ++p) place_[at(form.operations[p])] = static_cast<Index>(p);
      for (const Ref leaf : form.leaves)
        if (sections_.home[at(leaf.node)] >= 0) crosses_[at(leaf.node)] = true;
    }
  }

  // Which of the function's results an output belongs to.
  std::int64_t result_of(std::size_t output) const {
    std::int64_t i = 0;
    for (const Result& result : results(function_)) {
      if (output < at(result.count)) return i;
      output -= at(result.count);
      ++i;
    }
    throw InternalError("rolled: an output of no result");
  }

  const Section& section(std::size_t i) const { return sections_.list[i]; }

  // Of the node's value, which may be the negative of the entry.
  Stem signed_stem(const Quantity& quantity, std::size_t e) const {
    return stem((signs_.now(quantity.entries[e]).negative ? "minus_" : "") + quantity.labels[e], quantity.body);
  }

  // Stems of the entries made in a section, by place.
  std::unordered_map<Index, Stem> stems(std::size_t i) const {
    std::unordered_map<Index, Stem> result;
    for (const std::size_t q : section(i).quantities) {
      const Quantity& quantity = function_.quantities[q];
      for (std::size_t e = 0; e < quantity.entries.size(); ++e)
        if (sections_.home[at(quantity.entries[e].node)] == static_cast<Index>(i))
          result.emplace(place_[at(quantity.entries[e].node)], signed_stem(quantity, e));
    }
    return result;
  }

  void name_fields(std::size_t c) {
    const Members& members = members_[c];
    const std::unordered_map<Index, Stem> known = stems(members[0]);
    auto& fields = fields_.emplace_back();
    std::set<Stem> taken;  // no two results of a section share a field
    const auto own_stem = [&taken](const Stem& wish) {
      Stem own = wish;
      for (int i = 2; !taken.insert(own).second; ++i) own.back = wish.back + "_" + std::to_string(i);
      return own;
    };
    int unnamed = 0;
    const std::size_t count = forms_[members[0]].operations.size();
    for (std::size_t p = 0; p < count; ++p) {
      const bool is_kept = std::any_of(members.begin(), members.end(),
                                       [&](std::size_t m) { return crosses_[at(forms_[m].operations[p])]; });
      if (!is_kept) continue;
      const auto name = known.find(static_cast<Index>(p));
      const Stem own = name != known.end() ? name->second : Stem{"s", "_" + std::to_string(++unnamed), true};
      fields[static_cast<Index>(p)] = field(members[0], own_stem(own));
    }
  }

  Index field(std::size_t i, const Stem& own) {
    const auto [found, is_new] =
        field_of_.emplace(std::tuple(section(i).pass, ordinal_[i], own), static_cast<Index>(result_.fields.size()));
    if (is_new) result_.fields.push_back(own);
    return found->second;
  }

  std::size_t frame_of(std::size_t i) const { return at(std::max(section(i).body, 0)); }

  // Each field in the first place that is free in the frames of all bodies that have it; those of most bodies first, so
  // that a body of many fields of its own makes no other's frame longer.
  void lay_out_frames() {
    std::vector<std::vector<std::size_t>> owners(result_.fields.size());
    for (std::size_t c = 0; c < members_.size(); ++c)
      for (const auto& [p, field] : fields_[c])
        for (const std::size_t m : members_[c]) owners[at(field)].push_back(frame_of(m));
    std::vector<std::vector<bool>> taken(n_frames_);
    const auto is_taken = [&](std::size_t body, std::size_t slot) {
      return slot < taken[body].size() && taken[body][slot];
    };
    std::vector<std::size_t> order(owners.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return owners[a].size() > owners[b].size(); });
    result_.slots.resize(owners.size());
    for (const std::size_t field : order) {
      const std::vector<std::size_t>& bodies = owners[field];
      std::size_t slot = 0;
      while (std::any_of(bodies.begin(), bodies.end(), [&](std::size_t b) { return is_taken(b, slot); })) ++slot;
      for (const std::size_t b : bodies) {
        if (taken[b].size() <= slot) taken[b].resize(slot + 1, false);
        taken[b][slot] = true;
      }
      result_.slots[field] = static_cast<Index>(slot);
    }
    for (const auto& frame : taken) {
      result_.begins.push_back(result_.frames_size);
      result_.frames_size += static_cast<Index>(frame.size());
    }
  }

  std::vector<std::int64_t> values(const Leaf& leaf) const {
    std::vector<std::int64_t> key = {static_cast<std::int64_t>(leaf.kind)};
    key.insert(key.end(), leaf.places.begin(), leaf.places.end());
    key.insert(key.end(), leaf.fields.begin(), leaf.fields.end());
    return key;
  }

  // What stands at one place of the members' lists of leaves.
  Leaf leaf(const Members& members, std::size_t l) const {
    Leaf result;
    const Index first = forms_[members[0]].leaves[l].node;
    result.kind = leaf_kind(program_.nodes[at(first)], stages_[at(first)]);
    for (const std::size_t m : members) {
      const auto [node, negative] = forms_[m].leaves[l];
      if (const auto* constant = std::get_if<Constant>(&program_.nodes[at(node)])) {
        result.numbers.push_back(negative ? -constant->value : constant->value);
        result.places.push_back(negative ? -1 - node : node);
      } else if (result.kind == LeafKind::frame) {
        const Index home = sections_.home[at(node)];
        result.places.push_back(std::max(section(at(home)).body, 0));
        result.fields.push_back(fields_[class_of_[at(home)]].at(place_[at(node)]));
      } else {
        const auto* variable = std::get_if<Variable>(&program_.nodes[at(node)]);
        result.places.push_back(result.kind != LeafKind::prepared && variable != nullptr ? variable->index : node);
      }
    }
    return result;
  }

  // The section body of a class while it is made.
  struct Body {
    Builder builder;
    std::map<std::vector<std::int64_t>, Ref> known;
    std::vector<Ref> done;  // by place
    std::size_t next_leaf = 0;
  };

  Ref read(Body& body, SectionClass& made, const Members& members) const {
    Leaf found = leaf(members, body.next_leaf++);
    const auto [entry, is_new] = body.known.emplace(values(found), Ref{});
    if (!is_new) return entry->second;
    const bool is_fixed = found.kind == LeafKind::constant &&
                          std::equal(found.numbers.begin() + 1, found.numbers.end(), found.numbers.begin());
    if (is_fixed) {
      entry->second = body.builder.constant(found.numbers[0]);
    } else {
      entry->second = body.builder.variable(Group::x, static_cast<Index>(made.leaves.size()));
      made.leaves.push_back(std::move(found));
    }
    return entry->second;
  }

  SectionClass made(std::size_t c) {
    const Members& members = members_[c];
    const std::size_t first = members[0];
    SectionClass result;
    result.pass = section(first).pass;
    for (const std::size_t m : members) result.bodies.push_back(section(m).body);
    Body body;
    const auto value = [&](Ref ref) {
      const bool is_here = sections_.home[at(ref.node)] == static_cast<Index>(first);
      const Ref now = is_here ? body.done[at(place_[at(ref.node)])] : read(body, result, members);
      return signs_.now(ref).negative ? -now : now;
    };
    // in the order in which the leaves were listed
    const auto make = [&](Ref root) { make_to(body, result, members, root.node); };
    for (const Ref entry : section(first).entries) make(entry);
    Function function{function_.name, "", {}, {}, {}, 0, 0, {}};
    for (std::size_t s = 0; s < section(first).stores.size(); ++s) {
      make(section(first).stores[s].value);
      Output output{value(section(first).stores[s].value), {}};
      for (const std::size_t m : members) output.places.push_back(section(m).stores[s].output);
      function.outputs.push_back(output.value);
      result.outputs.push_back(std::move(output));
    }
    for (const auto& [p, field] : fields_[c]) result.kept.push_back({body.done[at(p)], field});
    std::sort(result.kept.begin(), result.kept.end(), [](const Kept& a, const Kept& b) { return a.field < b.field; });
    for (const Kept& kept : result.kept) function.outputs.push_back(kept.value);
    function.n_out = static_cast<Index>(function.outputs.size());
    add_quantities(function, result, body, first);
    result.body.nodes = std::move(body.builder.nodes());
    result.body.functions.push_back(std::move(function));
    return result;
  }

  // Makes the operations up to a node, in the canonical order.
  void make_to(Body& body, SectionClass& made, const Members& members, Index node) const {
    const std::size_t first = members[0];
    if (sections_.home[at(node)] != static_cast<Index>(first)) return;
    const Canonical& form = forms_[first];
    for (std::size_t p = body.done.size(); p <= at(place_[at(node)]); ++p) {
      const Node& operation = program_.nodes[at(form.operations[p])];
      Refs now;
      for (const std::size_t i : form.order[p]) {
        const Index operand = operands(operation).at[i];
        const bool is_here = sections_.home[at(operand)] == static_cast<Index>(first);
        const Ref made_before = is_here ? body.done[at(place_[at(operand)])] : read(body, made, members);
        now[i] = signs_.negative(form.operations[p], static_cast<int>(i)) ? -made_before : made_before;
      }
      body.done.push_back(same_again(body.builder, operation, now));
    }
  }

  void add_quantities(Function& function, SectionClass& made, const Body& body, std::size_t first) const {
    for (const std::size_t q : section(first).quantities) {
      const Quantity& quantity = function_.quantities[q];
      Quantity own = quantity;
      own.entries.clear();
      own.labels.clear();
      for (std::size_t e = 0; e < quantity.entries.size(); ++e) {
        const Ref entry = quantity.entries[e];
        if (sections_.home[at(entry.node)] != static_cast<Index>(first)) continue;
        const Ref now = body.done[at(place_[at(entry.node)])];
        own.entries.push_back(signs_.now(entry).negative ? -now : now);
        own.labels.push_back(quantity.labels[e]);
        made.names.push_back(stem(quantity.labels[e], quantity.body));
      }
      if (!own.entries.empty()) function.quantities.push_back(std::move(own));
    }
  }

  const Program& program_;
  const Function& function_;
  std::vector<Stage> stages_;
  Sections sections_;
  Signs signs_;
  std::vector<Canonical> forms_;  // of the sections
  std::vector<int> ordinal_;      // of a section among those of its pass and body
  std::vector<Members> members_;  // of the classes
  std::vector<std::size_t> class_of_;
  std::vector<bool> crosses_;                             // of a node: another section reads it
  std::vector<Index> place_;                              // of a node in its section
  std::vector<std::unordered_map<Index, Index>> fields_;  // of the classes: by place
  std::map<std::tuple<Pass, int, Stem>, Index> field_of_;
  std::size_t n_frames_ = 1;
  Rolled result_;
};

}  // namespace

Stem stem(const std::string& label, int body) {
  const std::string number = std::to_string(body);
  const std::size_t begin = label.find_first_of("0123456789");
  const std::size_t end = std::min(label.find_first_not_of("0123456789", begin), label.size());
  if (begin == std::string::npos || label.compare(begin, end - begin, number) != 0) return {label, "", false};
  return {label.substr(0, begin), label.substr(end), true};
}

std::optional<Rolled> rolled(const Program& program, const Function& function) {
  if (!function.placements.empty()) return std::nullopt;
  return Rolling(program, function).result();
}

}  // namespace kanec::program
