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

/// Source of the answers to control panels' queries about bodies: which have a panel, their bounding boxes,
/// and which controls to show.
class PanelStation final : public panel::PanelSubjects {
 public:
  /// Stores a reference to `state`, which must outlive the object.
  explicit PanelStation(const State& state) : state_(state) {}
  bool has_panel(BodyId body) const override;
  std::pair<Vec3, Vec3> box(BodyId body) const override;
  panel::ShownControls shown(BodyId body) const override;
  std::optional<BodyId> first() const override;

 private:
  const State& state_;
};

/// Advances the control panels by one tick: finds the controls that hands press, and applies their effects.
/// `hand_states` is parallel to the hands in `state`.
void step_panels(State& state, std::span<const HandState> hand_states, StepReport& report);

}  // namespace prosector
