#pragma once
// Display options that a desk user changes with keys.

#include <cstddef>
#include <optional>
#include <utility>

#include "client/app/desk/desk_room.h"
#include "client/app/desk/desk_section.h"
#include "client/app/desk/desk_view.h"
#include "client/render/window_context.h"
#include "client/view/draw_list.h"
#include "client/view/value_paint.h"

namespace prosector {

/// Display options that a desk user has chosen with keys: coloured quantity, section plane, wireframes,
/// statistics, help, and full screen.
struct DeskChoices {
  Shown shown = Shown::none;
  std::optional<SectionPlane> section = {};  // clipping plane
  bool wireframes = false, figures = false, help = false, full_screen = false;
};

inline constexpr Key section_key = key_of('X');

class DisplayKeys {
 public:
  explicit DisplayKeys(const DeskChoices& choices) : choices_(choices) {}

  /// Handles the press of a key other than section_key. `shift`: Shift is held.
  void press(Key key, bool shift);
  /// Handles the press of section_key: opens the section plane at the pointer.
  void press_section(const DeskView& view, const DeskRoom& room);
  void release_section();
  /// Moves the section plane by wheel notches.
  void move_section(double notches);

  const DeskChoices& choices() const { return choices_; }
  /// Returns how often, since the last call, the user has pressed the key that shows the view of the next
  /// participant.
  std::size_t take_follow_requests() { return std::exchange(follow_requests_, 0); }
  /// Returns the size of the screenshot that the user requested since the last call, as a multiple of the
  /// window's size: 1 or 2; 0 if none was requested.
  int take_picture_request() { return std::exchange(picture_request_, 0); }

 private:
  DeskChoices choices_;
  DeskSection section_;
  std::size_t follow_requests_ = 0;
  int picture_request_ = 0;
};

}  // namespace prosector
