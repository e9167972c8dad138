#pragma once
// A desk user's own panel. Its pose is the server's, except while the user drags it until the server reports
// that pose. The first visible line of its description is local to this viewer.

#include <chrono>
#include <optional>

#include "client/app/desk/panel_scroll.h"
#include "client/view/outlook.h"
#include "client/view/pick.h"
#include "client/view/price_strip.h"
#include "common/panel.h"
#include "common/panel_placement.h"

namespace prosector {

class DeskPanel {
 public:
  /// Updates the user's own panel to the server's state. Returns true if it has just opened, or belongs to
  /// another part than before. `hidden_lines`: lines of its description that do not fit. `effort`: solver
  /// effort shown on the strips below the panel; nullopt: no strips. A panel that isn't dragged has the
  /// server's pose after at most 1 s.
  bool follow(const std::optional<Panel>& panel, const std::optional<ShownEffort>& effort,
              std::size_t hidden_lines);
  /// Returns the user's own panel, at the pose to which the user has dragged it, if any; nullopt if no panel
  /// is open.
  const std::optional<Panel>& shown() const { return shown_; }
  /// Returns the point of the user's own panel under the pointer, and the control there; nullopt if the
  /// pointer is not on it.
  std::optional<PanelPoint> at(const Ray& pointer) const {
    return shown_ ? meet(pointer, *shown_) : std::nullopt;
  }
  /// Returns the solver effort under the pointer on the effort strip below the panel, as the number of steps
  /// by which it is reduced. Returns nullopt if the pointer is not on the strip.
  std::optional<std::uint32_t> effort_at(const Ray& pointer) const {
    return shown_ && effort_ ? picked_effort(pointer, *shown_) : std::nullopt;
  }
  /// Returns the accuracy (permitted error, %) of the model configuration under the pointer on the price
  /// strip below the panel. Returns 0 if the strip is empty and a click requests its values, and nullopt if
  /// the pointer is not on it.
  std::optional<double> accuracy_at(const Ray& pointer) const;
  /// Returns whether the pointer is on the user's own panel or on the strips below it.
  bool covers(const Ray& pointer) const { return at(pointer) || effort_at(pointer) || accuracy_at(pointer); }
  /// Returns the height of the lower end of the panel and the strips below it, m, relative to the panel's
  /// centre; negative.
  double bottom() const;
  /// Returns the pose to which the user drags the panel, if any, and the scroll position of its text, for
  /// rendering.
  PanelLook look() const { return {.place = place_, .first_line = scroll_.line()}; }

  /// Grasps the panel at this point. drag() then keeps the point under the pointer without rotating the
  /// panel. The point's distance along `back` (unit vector, out of the image) stays constant.
  void take_hold(const Ray& pointer, const PanelPoint& at, const Vec3& back);
  void drag(const Ray& pointer);
  void let_go();
  /// Requests that the panel returns to the pose at which it opened, and ends dragging.
  void put_back();
  /// Returns the next command that sets the panel's pose on the server after dragging; nullopt if there is
  /// none now. The rate is limited to that which the server accepts.
  std::optional<CommandBody> take_placing();

  /// Scrolls the description on the panel by this number of lines; negative: towards the beginning.
  void scroll(double lines) { scroll_.move(lines); }
  /// Returns true about once a second while the pointer is on the panel. Then the server must be asked to
  /// keep the panel open.
  bool should_keep_open(const Ray& pointer);

 private:
  struct Hold {
    Vec3 at;           // m, world frame: grasped point, in the plane in which it is dragged
    Vec3 back;         // normal of that plane
    Vec3 from_middle;  // m, from the grasped point to the panel's centre
  };
  std::optional<Panel> shown_;
  std::optional<ShownEffort> effort_;
  std::optional<Pose> place_;  // pose set by the user; nullopt: none
  std::optional<Hold> held_;
  std::chrono::steady_clock::time_point release_time_{}, last_sent_{};
  std::optional<PanelPlacement> unsent_placing_;  // change of the pose not yet sent
  PanelScroll scroll_;
  std::chrono::steady_clock::time_point last_request_{};
};

/// Returns whether the point is on the header of the panel, with the part's name, by which the panel is
/// dragged.
bool is_panel_head(const PanelPoint& point);

}  // namespace prosector
