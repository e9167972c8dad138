#pragma once
// Everything that affects the next tick. Checkpoints store it and hashes cover it, except the members that
// are marked as caches.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "server/physics/mechanics/contact/layers.h"
#include "server/physics/mechanics/contact/parting.h"
#include "server/physics/mechanics/coupled/vibration.h"
#include "server/physics/mechanics/hands/hand.h"
#include "server/physics/mechanics/organs/dissection.h"
#include "server/physics/mechanics/panel/panel_world.h"
#include "server/physics/world/bodies.h"

namespace prosector {

// Keyed by two soft bodies, the lower index first.
using LayerSides = std::map<std::pair<std::size_t, std::size_t>, std::vector<contact::LayerSide>>;
using Entanglements = std::map<std::pair<std::size_t, std::size_t>, contact::Entanglement>;

struct State {
  State(const Model& model, std::vector<CompiledTissue> tissues)
      : bodies(model, std::move(tissues)), lingerers(model.h) {}

  SimTime time;
  Bodies bodies;
  std::vector<hands::Hand> hands;  // by (participant, side)
  organs::Dissection dissection;
  LayerSides layer_sides;
  Entanglements entangled;
  coupled::Lingerers lingerers;
  std::optional<panel::PanelWorld> panels;  // set in scenes with parts
  double room_lights = 1;
};

}  // namespace prosector
