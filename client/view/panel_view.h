#pragma once
// Rendering of a panel: board, buttons at their pressed depth, knob, labels, and the part's description.

#include <array>
#include <memory>
#include <optional>

#include "client/text/text_block.h"
#include "client/text/typesetter.h"
#include "client/view/draw_list.h"
#include "client/view/effort_strip.h"
#include "common/error_estimate.h"
#include "common/panel.h"
#include "common/part_messages.h"
#include "common/scene_messages.h"

namespace prosector {

inline constexpr double least_panel_writing = 0.0085;  // m: minimum em height to which text shrinks to fit
// m, line height of scrolled text.
inline constexpr double scrolled_line = line_spacing * least_panel_writing;

class PanelView {
 public:
  /// Creates the render meshes of panels. They get `meshes` successive mesh ids from `first_mesh_id` on.
  explicit PanelView(std::uint64_t first_mesh_id);
  static constexpr std::size_t meshes = 8;

  /// Adds the panel of an anatomical part to the list. Touched controls are green. Buttons glow while their
  /// effect is on: the part is detached, others are hidden, it is transparent or lit, or the room is dim.
  /// `effort`: solver effort, of a soft part. `first_line`: first visible line of the description, if not all
  /// lines fit.
  void add(DrawList& list, const Panel& panel, const SceneBody& part,
           const std::optional<ShownEffort>& effort = std::nullopt, std::size_t first_line = 0);
  /// Returns the number of lines of the part's description that do not fit on its panel, and must be
  /// scrolled.
  std::size_t hidden_lines(const SceneBody& part);

 private:
  std::shared_ptr<const DrawMesh> board_, rim_, button_, knob_, rail_, strip_, notches_, price_strip_;

  Typesetter typesetter_;

  std::string description_from(const SceneBody& part, std::size_t first_line);
  void add_information(DrawList& list, const Pose& panel, const SceneBody& part, std::size_t first_line);
  void add_controls(DrawList& list, const Panel& panel) const;
  void add_effort(DrawList& list, const Pose& panel, const ShownEffort& effort) const;
  void add_prices(DrawList& list, const Pose& panel, const std::vector<Price>& prices) const;
};

}  // namespace prosector
