// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/read.hpp"
