#include "client/view/panel_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "client/text/text_block.h"
#include "client/view/body_mesh.h"
#include "client/view/price_strip.h"
#include "common/scene/primitives.h"

namespace prosector {
namespace {

constexpr double cap_depth = 0.014;      // m, drawn depth of the caps: they end within the board
constexpr double label_height = 0.0135;  // m
constexpr double mark_height = 0.010;    // m, of the slider's marks
constexpr double rim = 0.004;            // m, of the board
constexpr double over_surface = 0.0004;  // m: height of text over its surface
constexpr double label_margin = 0.004;   // m, around a label on its cap
constexpr double least_name = 0.010;     // m: minimum em height of a name that shrinks to fit

constexpr double info_width = panel_info.right - panel_info.left;                              // m
constexpr double description_height = panel_info.top - panel_info.bottom - panel_head_height;  // m

const Vec3 board_color{0.020, 0.026, 0.034}, rim_color{0.20, 0.23, 0.26}, rail_color{0.004, 0.005, 0.007};
const Vec3 cap_color{0.16, 0.18, 0.21}, on_color{0.95, 0.60, 0.10}, touched_color{0.07, 0.75, 0.14};
const Vec3 writing{0.85, 0.88, 0.90}, dark_writing{0.01, 0.01, 0.01}, dim_writing{0.55, 0.60, 0.64};

std::shared_ptr<const DrawMesh> box(const Vec3& size, double rounding, std::uint64_t id) {
  PartDesc part;
  part.size = size;
  part.rounding = rounding;
  return rigid_mesh(mesh_of(part), id);
}

/// Position of a text on the panel, in the panel's frame, and the size that it must fit into, m.
struct Place {
  Vec3 at;  // its top left; of centred text its centre
  double width = 0, height = 0;
};

DrawText write(const Pose& panel, const Place& place, std::string text, double height, const Vec3& color) {
  return {.text = std::move(text),
          .overlay = false,
          .height = height,
          .color = color,
          .surface = panel * Pose{place.at + Vec3(0, 0, over_surface), Quat::Identity()},
          .wrap = place.width,
          .least_height = std::min(height, least_panel_writing),
          .tallest = place.height};
}

DrawText write_centred(const Pose& panel, const Place& place, std::string text, double height,
                       const Vec3& color) {
  DrawText out = write(panel, place, std::move(text), height, color);
  out.centred = true;
  return out;
}

/// Returns whether the button is on in the initial state: parts are attached, the room is bright.
bool is_on_at_first(PanelControl control) {
  return control == PanelControl::attach || control == PanelControl::room_lights;
}

/// Returns the area for the label on a cap.
Place label_place(const ControlDesc& control, const Vec3& face) {
  return {face, 2 * (control.half_width - label_margin), 2 * (control.half_height - label_margin)};
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
      rail_(box({describe(PanelControl::stiffness).travel + 0.02, 0.006, 0.002}, 0.001, id + 4)),
      strip_(box({panel_width, strip_height, panel_thickness}, 0.003, id + 5)),
      notches_(box({notches_width + 0.01, 0.005, 0.002}, 0.001, id + 6)),
      price_strip_(box({panel_width, price_strip_height, panel_thickness}, 0.003, id + 7)) {}

void PanelView::add(DrawList& list, const Panel& panel, const SceneBody& part,
                    const std::optional<ShownEffort>& effort, std::size_t first_line) {
  const auto put = [&](const std::shared_ptr<const DrawMesh>& mesh, const Vec3& at, const Vec3& color) {
    list.items.push_back({.mesh = mesh,
                          .pose = panel.pose * Pose{at, Quat::Identity()},
                          .appearance = {.color = color, .surface = Surface::emissive},
                          .casts_shadow = false});
  };
  put(board_, {0, 0, -panel_thickness / 2}, board_color);
  put(rim_, {0, 0, -panel_thickness / 2 - 0.002}, rim_color);
  put(rail_, {0, slider_y, 0.0005}, rail_color);
  add_information(list, panel.pose, part, first_line);
  add_controls(list, panel);
  if (effort) add_effort(list, panel.pose, *effort);
  if (effort && (effort->may_ask || !effort->prices.empty())) add_prices(list, panel.pose, effort->prices);
}

void PanelView::add_effort(DrawList& list, const Pose& panel, const ShownEffort& effort) const {
  constexpr double word_width = 0.05, figures_above = 0.013;
  const auto put = [&](const std::shared_ptr<const DrawMesh>& mesh, const Vec3& at, const Vec3& color) {
    list.items.push_back({.mesh = mesh,
                          .pose = panel * Pose{at, Quat::Identity()},
                          .appearance = {.color = color, .surface = Surface::emissive},
                          .casts_shadow = false});
  };
  put(strip_, {0, strip_y, -panel_thickness / 2}, board_color);
  put(notches_, {0, notches_y, 0.0005}, rail_color);
  put(knob_, effort_notch(effort.steps_down) + Vec3(0, 0, 0.003), cap_color);
  const double beside = notches_width / 2 + 0.012 + word_width / 2;
  for (const auto& [x, word] :
       {std::pair{-beside, list.words.tr("accurate")}, std::pair{beside, list.words.tr("coarse")}})
    list.texts.push_back(
        write_centred(panel, {{x, notches_y, 0}, word_width, strip_height}, word, mark_height, dim_writing));
  list.texts.push_back(write_centred(
      panel, {{0, strip_y + figures_above, 0}, panel_width - 2 * panel_margin, strip_height / 2},
      in_words(effort, list.words), mark_height, writing));
}

/// Adds the available prices, or the question for them if they were not requested yet.
void PanelView::add_prices(DrawList& list, const Pose& panel, const std::vector<Price>& prices) const {
  constexpr double words_below = 0.012, in_front = 0.001;
  list.items.push_back({.mesh = price_strip_,
                        .pose = panel * Pose{{0, price_strip_y, -panel_thickness / 2}, Quat::Identity()},
                        .appearance = {.color = board_color, .surface = Surface::emissive},
                        .casts_shadow = false});
  const Vec3 middle(0, price_strip_y, 0);
  if (prices.empty())
    list.texts.push_back(write_centred(panel,
                                       {middle, panel_width - 2 * panel_margin, price_strip_height / 2},
                                       list.words.tr(price_question), mark_height, writing));
  const std::vector<Vec3> curve = price_curve(prices);
  const double cell =
      (panel_width - 2 * panel_margin) / static_cast<double>(std::max<std::size_t>(1, prices.size()));
  for (std::size_t k = 0; k < prices.size(); ++k) {
    const Vec3 at = price_cell_centre(k, prices.size()) - Vec3(0, words_below, 0);
    list.texts.push_back(write_centred(panel, {at, cell - label_margin, price_strip_height / 2},
                                       in_words(prices[k]), mark_height, writing));
    const Vec3 from = curve[std::max<std::size_t>(k, 1) - 1] + Vec3(0, 0, in_front),
               to = curve[k] + Vec3(0, 0, in_front);
    list.lines.push_back({panel * from, panel * to, on_color});
    for (const Vec3& arm : {Vec3(0.002, 0, 0), Vec3(0, 0.002, 0)})
      list.lines.push_back({panel * Vec3(to - arm), panel * Vec3(to + arm), writing});
  }
}

std::size_t PanelView::hidden_lines(const SceneBody& part) {
  const TextFrame board{.size = panel_text_height,
                        .least_size = least_panel_writing,
                        .width = info_width,
                        .height = description_height};
  if (!typesetter_.set(part.description, board).block->cut) return 0;
  const SetText all = typesetter_.set(part.description, {.size = least_panel_writing, .width = info_width});
  std::size_t fit = 1;
  while (least_panel_writing * height_of_lines(fit + 1) <= description_height) ++fit;
  return all.block->lines.size() - std::min(fit, all.block->lines.size());
}

/// Returns the description from a line on. `first_line` is clamped so that the last lines fill the board.
std::string PanelView::description_from(const SceneBody& part, std::size_t first_line) {
  const std::size_t first = std::min(first_line, hidden_lines(part));
  if (first == 0) return part.description;
  const SetText all = typesetter_.set(part.description, {.size = least_panel_writing, .width = info_width});
  std::string out;
  for (std::size_t k = first; k < all.block->lines.size(); ++k) out += all.block->lines[k].text + '\n';
  out.pop_back();
  return out;
}

void PanelView::add_information(DrawList& list, const Pose& panel, const SceneBody& part,
                                std::size_t first_line) {
  const Vec3 corner(panel_info.left, panel_info.top, 0);
  DrawText name = write(panel, {corner, info_width, height_of_lines(1) * panel_name_height}, part.name,
                        panel_name_height, writing);
  name.least_height = least_name;
  list.texts.push_back(std::move(name));
  list.texts.push_back(write(panel, {corner - Vec3(0, panel_head_height, 0), info_width, description_height},
                             description_from(part, first_line), panel_text_height, dim_writing));
}

void PanelView::add_controls(DrawList& list, const Panel& panel) const {
  for (const ControlDesc& control : panel_controls) {
    const ControlState& state = panel.controls[static_cast<std::size_t>(control.control)];
    const bool button = control.kind == ControlKind::button;
    const bool changed = button && state.on != is_on_at_first(control.control);
    const Vec3 face = control_face(control, state.position);
    Appearance look{.color = cap_color, .surface = Surface::emissive};
    if (changed) look.color = on_color;
    if (state.touched) look.color = touched_color;
    const double depth = button ? cap_depth : knob_height + 0.002;
    list.items.push_back({.mesh = button ? button_ : knob_,
                          .pose = panel.pose * Pose{face - Vec3(0, 0, depth / 2), Quat::Identity()},
                          .appearance = look,
                          .casts_shadow = false});
    if (button)
      list.texts.push_back(
          write_centred(panel.pose, label_place(control, face),
                        list.words.tr(std::string(state.on ? control.label_on : control.label)), label_height,
                        changed || state.touched ? dark_writing : writing));
  }
  const ControlDesc& slider = describe(PanelControl::stiffness);
  const double stiffness = stiffness_at(panel.controls[static_cast<std::size_t>(slider.control)].position);
  const Place stiffness_place{{0.071, -0.052, 0}, 0.134, 0.032};
  list.texts.push_back(write_centred(
      panel.pose, stiffness_place,
      fmt::format("{} x{:.2f}", list.words.tr(std::string(slider.label)), stiffness), label_height, writing));
  constexpr std::array<const char*, 5> marks = {"1/4", "1/2", "1", "2", "4"};
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const Vec3 at = control_face(slider, static_cast<double>(k) / 4);
    list.texts.push_back(write_centred(panel.pose, {{at.x(), slider.y - slider.half_height - 0.007, 0}},
                                       marks[k], mark_height, dim_writing));
  }
}

}  // namespace prosector
