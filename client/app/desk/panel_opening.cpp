#include "client/app/desk/panel_opening.h"

namespace prosector {
namespace {

constexpr std::chrono::seconds fresh_touch{
    3};  // a panel that opens within this time of a touch was opened by it

/// Returns the bounding box (m, world frame) of the panel and the strips below it.
Eigen::AlignedBox3d box_of(const DeskPanel& panel) {
  Eigen::AlignedBox3d box;
  for (const double x : {-panel_width / 2, panel_width / 2})
    for (const double y : {panel.bottom(), panel_height / 2}) box.extend(panel.shown()->pose * Vec3(x, y, 0));
  return box;
}

}  // namespace

void PanelOpening::follow_touch(const std::optional<BodyId>& touched,
                                std::chrono::steady_clock::time_point now) {
  if (touched_ != touched) touches_since_ = now;
  touched_ = touched;
}

std::optional<CommandBody> PanelOpening::opened(const DeskPanel& panel, bool hand_hovers, DeskView& view,
                                                std::chrono::steady_clock::time_point now) {
  if (std::exchange(is_expected_, false)) {
    view.make_room_for(box_of(panel));
    return std::nullopt;
  }
  const bool grazed = touched_ == panel.shown()->body && now - touches_since_ < fresh_touch;
  if (grazed && hand_hovers) return ClosePanel{};
  return std::nullopt;
}

std::optional<CommandBody> PanelOpening::close_when_left(const DeskPanel& panel, const DeskView& view) {
  if (!leaves_ || view.is_under_way()) return std::nullopt;
  leaves_ = false;
  if (panel.shown()) return ClosePanel{};
  return std::nullopt;
}

}  // namespace prosector
