// A scene's tables out of Python's dicts. Not: which keys there are (models/README.md).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "kanec/value.hpp"

namespace kanec::python {

// Throws Refused, which names the key, for what a scene cannot hold.
Table table_of(const pybind11::dict& dict);

}  // namespace kanec::python
