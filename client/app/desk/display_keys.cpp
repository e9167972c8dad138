#include "client/app/desk/display_keys.h"

namespace prosector {
namespace {

Shown next(Shown shown) {
  return static_cast<Shown>((static_cast<std::size_t>(shown) + 1) % value_scales.size());
}

}  // namespace

void DisplayKeys::press(Key key, bool shift) {
  if (key == Key::tab) ++follow_requests_;
  if (key == Key::f1 || key == key_of('H')) choices_.help = !choices_.help;
  if (key == Key::f11) choices_.full_screen = !choices_.full_screen;
  if (key == Key::f12) picture_request_ = shift ? 2 : 1;
  if (key == key_of('C')) choices_.wireframes = !choices_.wireframes;
  if (key == key_of('I')) choices_.figures = !choices_.figures;
  if (key == key_of('V')) choices_.shown = next(choices_.shown);
}

void DisplayKeys::press_section(const DeskView& view, const DeskRoom& room) {
  const ViewPlace& place = view.place();
  const auto point = room.surface(view.pointer());
  const bool opens = point && (!room.opens || room.opens(point->body));
  section_.press(place.back(), opens ? room.box(point->body).center() : place.target);
  choices_.section = section_.plane();
}

void DisplayKeys::release_section() {
  section_.let_go();
  choices_.section = section_.plane();
}

void DisplayKeys::move_section(double notches) {
  section_.move(notches);
  choices_.section = section_.plane();
}

}  // namespace prosector
