// All of kanec::kanec: scenes read or built, derived, generated, compiled, checked, simulated; and all of
// kanec::runtime.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "kanec/runtime.hpp"
#include "kanec/scene.hpp"
