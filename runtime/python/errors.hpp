// What goes wrong, as Python's exceptions and warnings. Not: their classes (kanec/errors.py).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace kanec::python {

// What a caller gave cannot be used: kanec.InputError. Library and module have each their own constructors of kanec's
// errors, which is why there is a class for it here.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// "accelerations: x: found ...; allowed: ..."
[[noreturn]] void refuse(const std::string& what, const std::string& found, const std::string& allowed);

// From now on all of kanec's errors leave the module as classes of kanec/errors.py.
void register_errors();

// Inside a catch block: Python's error becomes what is caught.
void set_python_error() noexcept;

// Each as a kanec.Note at the caller's line; throws where the user turns warnings into errors.
void warn(const std::vector<std::string>& notes);

// For loops without Python's lock: every 50 ms it looks for a Ctrl-C, and throws what its handler raises.
std::function<void()> watch_for_signals();

}  // namespace kanec::python
