#pragma once
// Scenes of the presses of the finite-layer table.

#include <string>

#include "common/scene/scene.h"
#include "tests/physics/layer_press.h"

namespace prosector {

/// Returns a readable name of the press.
std::string name(const LayerPress& press);

/// Returns a scene with a fixed ball just above the centre of a layer whose underside is held. The layer has
/// `fem_linear`, no gravity, multigrid, and otherwise default settings. `cell`: cell size, m.
SceneDesc layer_scene(const LayerPress& press, const std::string& element, double cell);

}  // namespace prosector
