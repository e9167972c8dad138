#pragma once
// Hands press panels' controls, controls change parts and the room.

#include <optional>
#include <span>
#include <utility>

#include "server/physics/panel/panel_world.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// What panels ask of the bodies that they are about.
class PanelStation final : public PanelSubjects {
 public:
  /// Keeps a reference: `state` outlives this.
  explicit PanelStation(const State& state) : state_(state) {}
  bool has_panel(BodyId body) const override;
  std::pair<Vec3, Vec3> box(BodyId body) const override;
  ShownControls shown(BodyId body) const override;
  std::optional<BodyId> first() const override;

 private:
  const State& state_;
};

/// Lets hands work the panels after a tick. `hand_states`: of the hands, in their order.
void work_panels(State& state, std::span<const HandState> hand_states, StepReport& report);

}  // namespace prosector
