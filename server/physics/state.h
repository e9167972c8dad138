#pragma once
// All that decides what the next tick does: what checkpoints hold, and hashes are of. Caches inside say so.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "server/physics/bodies.h"
#include "server/physics/contact/layers.h"
#include "server/physics/contact/parting.h"
#include "server/physics/coupled/lingering.h"
#include "server/physics/hands/hand.h"
#include "server/physics/organs/dissection.h"
#include "server/physics/panel/panel_world.h"

namespace prosector {

// By two soft bodies, the lower index first.
using LayerSides = std::map<std::pair<std::size_t, std::size_t>, std::vector<LayerSide>>;
using Entanglements = std::map<std::pair<std::size_t, std::size_t>, Entanglement>;

struct State {
  State(const Model& model, std::vector<CompiledTissue> tissues)
      : bodies(model, std::move(tissues)), lingerers(model.h) {}

  SimTime time;
  Bodies bodies;
  std::vector<Hand> hands;  // by (participant, side)
  Dissection dissection;
  LayerSides layer_sides;
  Entanglements entangled;
  Lingerers lingerers;
  std::optional<PanelWorld> panels;  // of scenes with parts
  double room_lights = 1;
};

}  // namespace prosector
