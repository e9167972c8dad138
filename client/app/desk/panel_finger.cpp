#include "client/app/desk/panel_finger.h"

#include "client/view/panel_view.h"
#include "common/index_tip.h"
#include "common/panel.h"

namespace prosector {
namespace {

constexpr double before_board = 0.02,
                 behind_board = 0.03;  // m: distance from the panel within which a tip is on the text

/// Reports whether a point (m, panel frame) is on the description.
bool is_at_text(const Vec3& at) {
  return at.x() > panel_info.left && at.x() < panel_info.right && at.y() > panel_info.bottom &&
         at.y() < panel_head_bottom && at.z() < before_board && at.z() > -behind_board;
}

}  // namespace

void PanelFinger::follow(const std::optional<Panel>& panel, std::size_t hidden_lines, const HandInput& user) {
  scroll_.follow(panel, hidden_lines);
  for (std::size_t hand = 0; hand < heights_.size(); ++hand) {
    std::optional<double> height;
    if (panel && user.hands[hand].tracked) {
      const Vec3 tip = panel->pose.inverse() * index_tip(hand, user.hands[hand]);
      if (is_at_text(tip)) height = tip.y();
    }
    if (height && heights_[hand]) scroll_.move((*height - *heights_[hand]) / scrolled_line);
    heights_[hand] = height;
  }
}

}  // namespace prosector
