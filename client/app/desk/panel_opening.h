#pragma once
// Opening and closing of a desk user's panel by requests, touches and the view.

#include <chrono>
#include <optional>
#include <utility>

#include "client/app/desk/desk_panel.h"
#include "client/app/desk/desk_view.h"
#include "client/view/pick.h"
#include "common/commands.h"
#include "common/ids.h"

namespace prosector {

class PanelOpening {
 public:
  /// Requests the panel of the part under the pointer.
  void request(const Ray& pointer) { request_ = pointer; }
  /// Returns the ray (world frame) of the pointer at the user's last request for the panel of the part under
  /// it. Returns nullopt if there was no request since the last call.
  std::optional<Ray> take_request() { return std::exchange(request_, std::nullopt); }
  /// Notes that the server was asked to open a panel, so that the view makes room for it when it opens.
  void expect() { is_expected_ = true; }

  /// Notes the body that the simulated hand touches at `now`.
  void follow_touch(const std::optional<BodyId>& touched, std::chrono::steady_clock::time_point now);
  /// Handles that the panel has just opened. A requested panel is brought into the frame. For a panel that a
  /// hovering hand opened by grazing the part, returns the command that closes it.
  std::optional<CommandBody> opened(const DeskPanel& panel, bool hand_hovers, DeskView& view,
                                    std::chrono::steady_clock::time_point now);

  /// Notes that the view moves to a saved position. The panel faces the view in which it opened: seen from
  /// elsewhere it hides its part.
  void leave() { leaves_ = true; }
  /// Returns the command that closes the panel after the view has reached its new position; nullopt: none
  /// now. Touching a part opens the panel again, facing the new view.
  std::optional<CommandBody> close_when_left(const DeskPanel& panel, const DeskView& view);

 private:
  std::optional<Ray> request_;
  std::optional<BodyId> touched_;  // body that the simulated hand touches
  std::chrono::steady_clock::time_point touches_since_{};
  bool is_expected_ = false;  // a requested panel has not opened yet
  bool leaves_ = false;       // the view is moving to a saved position
};

}  // namespace prosector
