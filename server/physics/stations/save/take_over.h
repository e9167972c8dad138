#pragma once
// A scene's state, taken over into the same scene with some bodies modelled in another way.

#include <string>

#include "common/refusal.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Says why a body that was cut is not modelled in another way.
Refusal cut_stays(const std::string& body);

/// Takes over from `from` where everything is and what was made of it. Bodies that are modelled alike keep
/// every bit. Of a soft body that isn't, the shape and motion are kept: at each node the displacement from
/// rest under gravity that was there. Hands and their panels stay behind. Refuses, and changes nothing, where
/// the scenes have other bodies, or a body that is modelled in another way was cut.
Refusal take_over(const State& from, State& to);

}  // namespace prosector
