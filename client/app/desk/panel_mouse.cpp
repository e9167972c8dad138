#include "client/app/desk/panel_mouse.h"

namespace prosector {
namespace {

constexpr std::chrono::milliseconds slide_interval{40};  // the server accepts at most 50 commands a second

}  // namespace

std::optional<CommandBody> PanelMouse::press(DeskPanel& panel, const Ray& pointer, const Vec3& back,
                                             DoubleClick& clicks, const Eigen::Vector2d& pixel) {
  if (const auto steps_down = panel.effort_at(pointer)) return SetEffort{panel.shown()->body, *steps_down};
  if (const auto accuracy = panel.accuracy_at(pointer)) return SetAccuracy{panel.shown()->body, *accuracy};
  const auto point = panel.at(pointer);
  if (!point) return std::nullopt;
  if (is_panel_head(*point)) {
    clicks.press(pixel) ? panel.put_back() : panel.take_hold(pointer, *point, back);
    return std::nullopt;
  }
  if (point->control == PanelControl::stiffness) {
    sliding_ = true;
    return slide(point->at);
  }
  if (!point->control) return std::nullopt;
  const ControlState& button = panel.shown()->controls[static_cast<std::size_t>(*point->control)];
  return SetControl{*point->control, button.on ? 0.0 : 1.0};
}

std::optional<CommandBody> PanelMouse::move(DeskPanel& panel, const Ray& pointer) {
  panel.drag(pointer);
  if (!sliding_ || std::chrono::steady_clock::now() - last_slide_ <= slide_interval) return std::nullopt;
  const auto point = panel.at(pointer);
  if (!point) return std::nullopt;
  return slide(point->at);
}

void PanelMouse::release(DeskPanel& panel) {
  sliding_ = false;
  panel.let_go();
}

CommandBody PanelMouse::slide(const Vec3& at) {
  last_slide_ = std::chrono::steady_clock::now();
  return SetControl{PanelControl::stiffness, slider_position(at)};
}

}  // namespace prosector
