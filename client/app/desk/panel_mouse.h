#pragma once
// Operation of a desk user's own panel with the mouse.

#include <chrono>
#include <optional>

#include "client/app/desk/desk_panel.h"
#include "client/app/desk/double_click.h"
#include "client/view/pick.h"
#include "common/commands.h"
#include "common/math.h"

namespace prosector {

/// The left mouse button on the panel and the strips below it. The header is dragged; a double click on it
/// returns the panel to its original position.
class PanelMouse {
 public:
  /// Handles a press of the button on the panel, at this pixel of the frame. `back`: unit vector, out of the
  /// image. Returns the command to the server; nullopt: none.
  std::optional<CommandBody> press(DeskPanel& panel, const Ray& pointer, const Vec3& back,
                                   DoubleClick& clicks, const Eigen::Vector2d& pixel);
  /// Handles a motion of the pointer. Returns the command to the server, at a limited rate, while the slider
  /// is dragged; otherwise nullopt.
  std::optional<CommandBody> move(DeskPanel& panel, const Ray& pointer);
  /// Handles the release of the button.
  void release(DeskPanel& panel);

 private:
  bool sliding_ = false;  // the button drags the slider
  std::chrono::steady_clock::time_point last_slide_{};

  CommandBody slide(const Vec3& at);
};

}  // namespace prosector
