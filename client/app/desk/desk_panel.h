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
  /// Updates the panel to the server's state. Returns true if it belongs to another part than before.
  /// `hidden_lines`: lines of its description that do not fit. `effort`: solver effort shown on the strips
  /// below the panel; nullopt: no strips. A panel that isn't dragged has the server's pose after at most 1 s.
  bool follow(const std::optional<Panel>& panel, const std::optional<ShownEffort>& effort,
              std::size_t hidden_lines);
  /// Returns the panel with the pose that the user gave it; nullopt: there is none.
  const std::optional<Panel>& shown() const { return shown_; }
  /// Returns the point of the panel under the pointer.
  std::optional<PanelPoint> at(const Ray& pointer) const {
    return shown_ ? meet(pointer, *shown_) : std::nullopt;
  }
  /// Returns the effort level under the pointer on the panel's effort strip, in steps below exact.
  std::optional<std::uint32_t> effort_at(const Ray& pointer) const {
    return shown_ && effort_ ? picked_effort(pointer, *shown_) : std::nullopt;
  }
  /// Returns the accuracy under the pointer on the panel's price strip, %; 0: the request for the prices.
  std::optional<double> accuracy_at(const Ray& pointer) const;
  /// Reports whether the pointer is on the panel or its strips.
  bool covers(const Ray& pointer) const { return at(pointer) || effort_at(pointer) || accuracy_at(pointer); }
  /// Returns the lower end of panel and strips, m, relative to the panel's centre.
  double bottom() const;
  /// Returns the position and scroll state that the user gave the panel, for rendering.
  PanelLook look() const { return {.place = place_, .first_line = scroll_.line()}; }

  /// Grasps the panel at this point, which drag() keeps under the pointer without rotating the panel. Its
  /// distance along `back` (unit vector, out of the image) stays constant.
  void take_hold(const Ray& pointer, const PanelPoint& at, const Vec3& back);
  void drag(const Ray& pointer);
  void let_go();
  /// Returns the panel to the pose at which it opened.
  void put_back();
  /// Returns the next command that sets the panel's pose on the server, limited to the rate that the server
  /// accepts; nullopt: none now.
  std::optional<CommandBody> take_placing();

  /// Scrolls by lines of its description.
  void scroll(double lines) { scroll_.move(lines); }
  /// Reports, about once a second while the pointer is on the panel, that the server must keep it open.
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
  std::chrono::steady_clock::time_point let_go_{}, last_told_{};
  std::optional<PanelPlacement> unsent_placing_;  // change of the pose not yet sent
  PanelScroll scroll_;
  std::chrono::steady_clock::time_point last_asked_{};
};

/// Reports whether the point is on the panel's header with the part's name, by which the panel is dragged.
bool is_panel_head(const PanelPoint& point);

}  // namespace prosector
