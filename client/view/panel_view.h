#pragma once
// A panel as something to see: board, buttons as far in as they are pressed, knob, labels, and what the part
// is.

#include <array>
#include <memory>
#include <optional>

#include "client/view/draw_list.h"
#include "client/view/effort_strip.h"
#include "common/panel.h"

namespace prosector {

class PanelView {
 public:
  /// Uses mesh ids from `first_mesh_id` on: `meshes` of them.
  explicit PanelView(std::uint64_t first_mesh_id);
  static constexpr std::size_t meshes = 7;

  /// Adds the panel; touched controls are green, buttons that are on glow. `effort`: of a part that is soft.
  void add(DrawList& list, const Panel& panel, const SceneBody& part,
           const std::optional<ShownEffort>& effort = std::nullopt) const;

 private:
  std::shared_ptr<const DrawMesh> board_, rim_, button_, knob_, rail_, strip_, notches_;

  static void add_information(DrawList& list, const Pose& panel, const SceneBody& part);
  void add_controls(DrawList& list, const Panel& panel) const;
  void add_effort(DrawList& list, const Pose& panel, const ShownEffort& effort) const;
};

}  // namespace prosector
