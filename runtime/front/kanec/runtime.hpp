// All of kanec::runtime: compiled models loaded, evaluated, integrated. Nothing here links GiNaC.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kanec/batch.hpp"
#include "kanec/error.hpp"
#include "kanec/model.hpp"
#include "kanec/motion.hpp"
