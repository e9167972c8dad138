#include "client/view/panel_view.h"

#include <fmt/format.h>

#include "client/view/body_mesh.h"
#include "common/primitives.h"

namespace prosector {
namespace {

constexpr double cap_depth = 0.014;      // m, of the caps as drawn: they end within the board
constexpr double label_height = 0.0135;  // m
constexpr double mark_height = 0.010;    // m, of the slider's marks
constexpr double rim = 0.004;            // m, of the board
constexpr double over_surface = 0.0004;  // m: writing over what it stands on
constexpr double letter_width = 0.615;   // of its height

const Vec3 board_color{0.020, 0.026, 0.034}, rim_color{0.20, 0.23, 0.26}, rail_color{0.004, 0.005, 0.007};
const Vec3 cap_color{0.16, 0.18, 0.21}, on_color{0.95, 0.60, 0.10}, touched_color{0.07, 0.75, 0.14};
const Vec3 writing{0.85, 0.88, 0.90}, dark_writing{0.01, 0.01, 0.01}, dim_writing{0.55, 0.60, 0.64};

std::shared_ptr<const DrawMesh> box(const Vec3& size, double rounding, std::uint64_t id) {
  PartDesc part;
  part.size = size;
  part.rounding = rounding;
  return rigid_mesh(mesh_of(part), id);
}

/// Makes writing whose first line begins at the place, in the panel's frame.
DrawText write(const Pose& panel, const Vec3& at, std::string text, double height, const Vec3& color,
               double wrap = 0) {
  return {.text = std::move(text),
          .overlay = false,
          .height = height,
          .color = color,
          .surface = panel * Pose{at + Vec3(0, 0, over_surface), Quat::Identity()},
          .wrap = wrap};
}

/// Makes writing in the middle of a place.
DrawText write_centred(const Pose& panel, const Vec3& middle, std::string text, double height,
                       const Vec3& color) {
  const double width = letter_width * height * static_cast<double>(text.size());
  return write(panel, middle + Vec3(-width / 2, height / 2, 0), std::move(text), height, color);
}

}  // namespace

PanelView::PanelView(std::uint64_t id)
    : board_(box({panel_width, panel_height, panel_thickness}, 0.003, id)),
      rim_(box({panel_width + 2 * rim, panel_height + 2 * rim, panel_thickness - 0.002}, 0.003, id + 1)),
      button_(box({2 * panel_controls[0].half_width, 2 * panel_controls[0].half_height, cap_depth}, 0.0025,
                  id + 2)),
      knob_(box({2 * describe(PanelControl::stiffness).half_width,
                 2 * describe(PanelControl::stiffness).half_height, knob_height + 0.002},
                0.003, id + 3)),
      rail_(box({describe(PanelControl::stiffness).travel + 0.02, 0.006, 0.002}, 0.001, id + 4)) {}

void PanelView::add(DrawList& list, const Panel& panel, const SceneBody& part) const {
  const auto put = [&](const std::shared_ptr<const DrawMesh>& mesh, const Vec3& at, const Vec3& color) {
    list.items.push_back({.mesh = mesh,
                          .pose = panel.pose * Pose{at, Quat::Identity()},
                          .appearance = {.color = color, .roughness = 0.6},
                          .casts_shadow = false});
  };
  put(board_, {0, 0, -panel_thickness / 2}, board_color);
  put(rim_, {0, 0, -panel_thickness / 2 - 0.002}, rim_color);
  put(rail_, {0, slider_y, 0.0005}, rail_color);
  const Vec3 corner(panel_info.left, panel_info.top, 0);
  list.texts.push_back(write(panel.pose, corner, part.name, panel_name_height, writing));
  list.texts.push_back(write(panel.pose, corner - Vec3(0, 1.6 * panel_name_height, 0), part.description,
                             panel_text_height, dim_writing, panel_info.right - panel_info.left));
  add_controls(list, panel);
}

void PanelView::add_controls(DrawList& list, const Panel& panel) const {
  for (const ControlDesc& control : panel_controls) {
    const ControlState& state = panel.controls[static_cast<std::size_t>(control.control)];
    const bool button = control.kind == ControlKind::button, glows = state.touched || state.on;
    const Vec3 face = control_face(control, state.position);
    Appearance look{.color = cap_color, .roughness = 0.5};
    if (glows) look.surface = Surface::emissive;
    if (state.on) look.color = on_color;
    if (state.touched) look.color = touched_color;
    const double depth = button ? cap_depth : knob_height + 0.002;
    list.items.push_back({.mesh = button ? button_ : knob_,
                          .pose = panel.pose * Pose{face - Vec3(0, 0, depth / 2), Quat::Identity()},
                          .appearance = look,
                          .casts_shadow = false});
    if (button)
      list.texts.push_back(write_centred(panel.pose, face,
                                         std::string(state.on ? control.label_on : control.label),
                                         label_height, glows ? dark_writing : writing));
  }
  const ControlDesc& slider = describe(PanelControl::stiffness);
  const double stiffness = stiffness_at(panel.controls[static_cast<std::size_t>(slider.control)].position);
  list.texts.push_back(write_centred(panel.pose, {0.071, -0.052, 0},
                                     fmt::format("{} x{:.2f}", slider.label, stiffness), label_height,
                                     writing));
  constexpr std::array<const char*, 5> marks = {"1/4", "1/2", "1", "2", "4"};
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const Vec3 at = control_face(slider, static_cast<double>(k) / 4);
    list.texts.push_back(write_centred(panel.pose, {at.x(), slider.y - slider.half_height - 0.007, 0},
                                       marks[k], mark_height, dim_writing));
  }
}

}  // namespace prosector
