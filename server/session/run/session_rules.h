#pragma once
// Derives the rules of a session from its scene.

#include <string>

#include "common/scene/scene.h"
#include "server/session/people/roster.h"

namespace prosector {

/// Returns the rules (limits, timeouts and body properties) of a session with that scene. `remodels`: whether
/// the models of bodies can be changed while it runs.
SessionRules rules_of(const SceneDesc& scene, const std::string& session, bool remodels = false);

}  // namespace prosector
