// A model whose functions are written down node by node, every kind of node among them: what no derivation of a free
// tree lowers to. Not: mechanics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/pipeline.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {

// One free body with parameters `a`, `unread`, `b` and inputs `idle`, `drive`, of which `unread` and `idle` are read by
// nothing. Functions: `every` (each kind of node, of the state, of time, inputs and of parameters alone), its Jacobian
// `every_x` by x, `still` (no time, no inputs), and `every_and_still`.
Sample every_node_sample();
// With `every` repeated with other arguments, `every_and_still` alone: 180 times makes it long enough to be cut into
// pieces. In C the header alone.
Generated every_node_model(const scene::Scene& scene, int repetitions = 1,
                           emit::Language language = emit::Language::cpp);

// With all rates of a state at once, each a sum of several kinds of node, and the Taylor series of this motion.
Generated every_node_motion(const scene::Scene& scene);

}  // namespace kanec::test
