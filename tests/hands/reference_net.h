#pragma once
// Networks run by loops that say what each layer is, slowly, and made at random.

#include <map>

#include "drivers/camera/nets/net_plan.h"
#include "tests/random.h"

namespace prosector {

/// Runs a network. Returns its outputs in the plan's order.
std::vector<std::vector<float>> run_slowly(const NetPlan& plan, const std::vector<float>& input);

/// Makes a small network in which each kind of layer comes once or more, with random sizes and weights.
NetPlan random_net(Random& random);

/// Writes it as a TensorFlow Lite file, with weights as half-precision floats where `halves`.
std::vector<std::uint8_t> write_net(const NetPlan& plan, bool halves);

}  // namespace prosector
