#include "server/haptics/felt_panel.h"

#include <cmath>

#include "common/index_tip.h"
#include "common/panel.h"
#include "server/haptics/felt_hand.h"
#include "server/physics/mechanics/panel/panel_motion.h"

namespace prosector {
namespace {

constexpr double report_height = 0.03;         // m: height above the board below which planes are reported
constexpr double rubbing = 0.6;                // coefficient of friction
constexpr std::uint32_t of_panels = 1u << 31;  // bit in plane ids that only planes of panels have

/// Returns the control at a position on the board, m; null: none.
const ControlDesc* control_at(const Panel& panel, double x, double y) {
  for (const ControlDesc& control : panel_controls) {
    const Vec3 face =
        control_face(control, panel.controls[static_cast<std::size_t>(control.control)].position);
    if (std::abs(x - face.x()) <= control.half_width && std::abs(y - face.y()) <= control.half_height)
      return &control;
  }
  return nullptr;
}

}  // namespace

std::vector<ContactPlane> panel_planes(const Panel& panel, std::size_t hand, const HandPose& pose) {
  const double radius = hand_segments(hand)[index_end].radius;
  const Vec3 tip = panel.pose.inverse() * index_tip(hand, pose) - Vec3(0, 0, radius);
  if (!panel.open || !tip.allFinite() || std::abs(tip.x()) > panel_width / 2 ||
      std::abs(tip.y()) > panel_height / 2 || tip.z() > report_height || tip.z() < -panel::finger_depth)
    return {};
  const ControlDesc* control = control_at(panel, tip.x(), tip.y());
  const std::uint32_t place = control != nullptr ? 1 + static_cast<std::uint32_t>(control->control) : 0;
  std::vector<ContactPlane> out;
  const auto add = [&](double height, double stiffness) {
    ContactPlane plane;
    plane.id = of_panels | place << 1 | static_cast<std::uint32_t>(out.size());
    plane.body = panel.body;
    plane.normal = panel.pose.q * Vec3::UnitZ();
    plane.point = panel.pose * Vec3(tip.x(), tip.y(), height);
    plane.arm = pose.pose.inverse() * (panel.pose * tip);
    plane.stiffness = plane.tangential = stiffness;
    plane.friction = rubbing;
    plane.radius = report_height;
    out.push_back(plane);
  };
  if (control != nullptr && control->kind == ControlKind::button) {
    add(control->height - control->travel, hard_stiffness);
    add(control->height, panel::button_stiffness);
  } else {
    add(control != nullptr ? control->height : 0, hard_stiffness);
  }
  return out;
}

}  // namespace prosector
