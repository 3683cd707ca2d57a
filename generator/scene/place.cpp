// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/place.hpp"

#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

constexpr std::size_t shown_bytes = 40;
constexpr std::size_t shown_names = 20;
constexpr std::size_t longest_name = 63;

// The first bytes of `text`, not ending inside a UTF-8 character.
std::string_view beginning(std::string_view text) {
  std::size_t end = shown_bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end);
}

}  // namespace

void fail(const Place& place, const std::string& found, const std::string& allowed) {
  throw SceneError({place.file, place.line, place.body, place.field, found, allowed});
}

std::string remark(const Place& place, const std::string& text) {
  const std::string separator = place.field.empty() ? "" : ": ";
  return SceneError({place.file, place.line, place.body, place.field + separator + text, "", ""}).what();
}

std::string in_quotes(std::string_view text) {
  if (text.size() <= shown_bytes) return '"' + fit::line(text) + '"';
  return '"' + fit::line(beginning(text)) + "\"… (" + std::to_string(text.size()) + " bytes)";
}

std::string one_of(const std::vector<std::string>& known, std::string_view found) {
  std::string text;
  for (std::size_t i = 0; i < known.size() && i < shown_names; ++i) text += (i == 0 ? "" : ", ") + known[i];
  if (known.size() > shown_names) text += ", … (" + std::to_string(known.size()) + " in all)";
  const std::string near = found.empty() || found.size() > longest_name ? "" : nearest(found, known);
  return near.empty() ? text : text + " (did you mean " + near + "?)";
}

}  // namespace kanec::scene
