#pragma once
// Connects panels with the simulation: hands press controls, and controls change parts and the room.

#include <optional>
#include <span>
#include <utility>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/panel/panel_world.h"
#include "server/physics/world/state.h"
#include "server/physics/world/tick_output.h"

namespace prosector {

/// Answers the panels' queries about bodies.
class PanelStation final : public PanelSubjects {
 public:
  /// Stores a reference: `state` outlives this.
  explicit PanelStation(const State& state) : state_(state) {}
  bool has_panel(BodyId body) const override;
  std::pair<Vec3, Vec3> box(BodyId body) const override;
  ShownControls shown(BodyId body) const override;
  std::optional<BodyId> first() const override;

 private:
  const State& state_;
};

/// Runs the panels after a tick. `hand_states`: parallel to the state's hands.
void step_panels(State& state, std::span<const HandState> hand_states, StepReport& report);

}  // namespace prosector
