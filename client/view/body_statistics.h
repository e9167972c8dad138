#pragma once
// Solver statistics of a deformable body, as text for the view.

#include <string>

#include "client/language/catalogue.h"
#include "common/scene_messages.h"
#include "common/status_messages.h"

namespace prosector {

/// Returns solver statistics of a soft body as lines of text: its name, and its time step ("12 steps of 1.39
/// ms"). Adds its estimated error, if known, and whether its solver effort was reduced.
std::string body_figures(const SceneBody& body, const BodyStatus& status, const Catalogue& words = {});

}  // namespace prosector
