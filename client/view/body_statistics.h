#pragma once
// Solver statistics of a deformable body, as text for the view.

#include <string>

#include "client/language/catalogue.h"
#include "common/scene_messages.h"
#include "common/status_messages.h"

namespace prosector {

/// Returns the body's name and its time step ("12 steps of 1.39 ms"). Adds its estimated error, if known, and
/// whether its effort was reduced. One line each.
std::string body_figures(const SceneBody& body, const BodyStatus& status, const Catalogue& words = {});

}  // namespace prosector
