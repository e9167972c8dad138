#pragma once
// A desk user's own panel: as the server has it, but where the user drags it until the server has it there,
// and from which line of its description on. The line is this viewer's alone.

#include <chrono>
#include <optional>

#include "client/app/panel_scroll.h"
#include "client/view/pick.h"
#include "client/view/price_strip.h"
#include "client/view/view_settings.h"
#include "common/panel.h"
#include "common/panel_placing.h"

namespace prosector {

class DeskPanel {
 public:
  /// Follows what the server says of it; `hidden_lines`: of its description, which do not fit on it.
  /// `effort`: what strips below it say of how its part is solved; nullopt: there are none. Returns true when
  /// it is another part's. What isn't dragged stands where the server has it, at the latest a second after.
  bool follow(const std::optional<Panel>& panel, const std::optional<ShownEffort>& effort,
              std::size_t hidden_lines);
  /// Returns the panel where the user has it; nullopt: there is none.
  const std::optional<Panel>& shown() const { return shown_; }
  /// Returns where the pointer is on it.
  std::optional<PanelPoint> at(const Ray& pointer) const {
    return shown_ ? meet(pointer, *shown_) : std::nullopt;
  }
  /// Returns the steps down that the pointer is at on its strip.
  std::optional<std::uint32_t> effort_at(const Ray& pointer) const {
    return shown_ && effort_ ? meet_effort(pointer, *shown_) : std::nullopt;
  }
  /// Returns the accuracy that the pointer is at on its strip of prices, %; 0: the question for them.
  std::optional<double> accuracy_at(const Ray& pointer) const;
  /// Tells whether the pointer is at the board or its strips.
  bool covers(const Ray& pointer) const { return at(pointer) || effort_at(pointer) || accuracy_at(pointer); }
  /// Returns how far board and strips reach down from its middle, m.
  double bottom() const;
  /// Returns what the user did to it, for its picture.
  PanelLook look() const { return {.place = place_, .first_line = scroll_.line()}; }

  /// Takes hold of the board at that place, which drag() keeps below the pointer and turned as it is. It
  /// stays as far away along `back` (unit, out of the picture).
  void take_hold(const Ray& pointer, const PanelPoint& at, const Vec3& back);
  void drag(const Ray& pointer);
  void let_go();
  /// Puts it back to where it came up.
  void put_back();
  /// Returns what is to be asked of the server for its place, no oftener than a server takes; nullopt:
  /// nothing now.
  std::optional<Command> take_placing();

  /// Moves on by lines of its description.
  void scroll(double lines) { scroll_.move(lines); }
  /// Tells, about once a second while it is pointed at, that it is to stay open.
  bool asks_to_stay(const Ray& pointer);

 private:
  struct Hold {
    Vec3 at;           // m, world frame: what was taken hold of, in the plane that it stays in
    Vec3 back;         // that plane's normal
    Vec3 from_middle;  // m, from what was taken hold of to the board's middle
  };
  std::optional<Panel> shown_;
  std::optional<ShownEffort> effort_;
  std::optional<Pose> place_;  // where the user put it; nullopt: nowhere
  std::optional<Hold> held_;
  std::chrono::steady_clock::time_point let_go_{}, last_told_{};
  std::optional<PanelPlacing> untold_;  // of what the user did to its place
  PanelScroll scroll_;
  std::chrono::steady_clock::time_point last_asked_{};
};

/// Tells whether it is the board's head, where the part's name stands: there it can be taken hold of.
bool is_panel_head(const PanelPoint& point);

}  // namespace prosector
