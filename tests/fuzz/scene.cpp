// Any text as a scene: it is one, or an error of kanec, in one line. Not: what is done with scenes.
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const kanec::scene::Scene scene = kanec::scene::parse(text, "f");
    if (kanec::scene::coordinate_names(scene).size() != kanec::scene::initial_coordinates(scene).size()) std::abort();
  } catch (const kanec::InternalError&) {
    std::abort();
  } catch (const kanec::Error& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
