#include "client/setup/eye_ruler.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "drivers/fitting/eye_fit.h"

namespace prosector {
namespace {

constexpr double usual_pixel = 0.265e-3;  // m, pixel size of a 96-dpi screen, at scale 1
constexpr ImU32 pale = IM_COL32(225, 230, 235, 255), left_shade = IM_COL32(110, 190, 255, 255),
                right_shade = IM_COL32(255, 190, 90, 255);

}  // namespace

std::optional<GuideOutcome> EyeRuler::draw(Interface& ui, Said& said) {
  const auto scale = static_cast<float>(ui.scale());
  const float field = 190 * scale;
  if (card_ == 0) card_ = card_width / usual_pixel * ui.scale();
  quiet(ui.tr("1. Hold a bank card to the bar, and make the bar as wide as the card."));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float high = 0.8f * ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + static_cast<float>(card_), at.y + high}, pale,
                                            3 * scale);
  ImGui::Dummy({static_cast<float>(card_), high});
  ui.note("card");
  ImGui::SetNextItemWidth(field);
  ImGui::InputDouble(ui.tr("pixels wide"), &card_, 1, 10, "%.0f");
  ui.note("card width");
  card_ = std::clamp(card_, 1., 8192.);
  double pixel = 0;
  try {
    pixel = pixel_size_from_card(card_);
  } catch (const InputError& error) {
    warning(error.what());
    return std::nullopt;
  }
  quiet(
      ui.tr("2. Hold a thin rod upright in front of the ruler. At which mark does each eye see it, with the "
            "other eye closed?"));
  draw_ruler(ui, pixel);
  ImGui::PushItemWidth(field);
  ImGui::InputDouble(ui.tr("mm: mark seen by the left eye"), &left_, 0.5, 5, "%.1f");
  ui.note("left mark");
  ImGui::InputDouble(ui.tr("mm: mark seen by the right eye"), &right_, 0.5, 5, "%.1f");
  ui.note("right mark");
  quiet(ui.tr("3. Measure how far the screen and the thin rod before the ruler are from your eyes."));
  ImGui::InputDouble(ui.tr("mm to the screen"), &screen_mm_, 5, 50, "%.0f");
  ui.note("screen distance");
  ImGui::InputDouble(ui.tr("mm to the rod"), &rod_mm_, 5, 50, "%.0f");
  ui.note("rod distance");
  ImGui::PopItemWidth();
  const bool asked = ImGui::Button(ui.tr("Calculate"));
  ui.note("reckon");
  if (!asked) return std::nullopt;
  try {
    const EyeDistance eyes =
        eye_distance_by_sighting(1e-3 * std::abs(left_ - right_), 1e-3 * screen_mm_, 1e-3 * rod_mm_);
    return GuideOutcome{
        {ui.tr("Your eyes are {:.1f} ± {:.1f} mm apart.", 1e3 * eyes.distance, 1e3 * eyes.error)},
        {{"eyes.distance", eyes.distance}}};
  } catch (const InputError& error) {
    said = {error.what(), true};
    return std::nullopt;
  }
}

/// Draws a millimetre scale at its true size, with both marks. A press moves the nearer mark there.
void EyeRuler::draw_ruler(Interface& ui, double pixel) {
  const auto scale = static_cast<float>(ui.scale());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float wide = ImGui::GetContentRegionAvail().x - 8 * scale;
  const float line = ImGui::GetTextLineHeight(), high = 3.4f * line;
  const auto mm = static_cast<float>(1e-3 / pixel);  // pixels per mm
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + wide, at.y + high}, IM_COL32(255, 255, 255, 14), 3 * scale);
  const int last = static_cast<int>(wide / mm);
  for (int k = 0; k <= last; ++k) {
    const float x = at.x + static_cast<float>(k) * mm;
    const float tick = (k % 10 == 0 ? 1.1f : k % 5 == 0 ? 0.8f : 0.5f) * line;
    list.AddLine({x, at.y}, {x, at.y + tick}, pale, scale);
    const std::string number = std::to_string(k);
    if (k % 10 == 0 && x + 1.5f * line < at.x + wide)
      list.AddText({x + 3 * scale, at.y + 1.2f * line}, pale, number.c_str());
  }
  const auto mark = [&](double place, ImU32 shade, const char* name) {
    const float x = at.x + std::clamp(static_cast<float>(place) * mm, 0.f, wide);
    list.AddLine({x, at.y}, {x, at.y + high}, shade, 3 * scale);
    list.AddText({x + 5 * scale, at.y + high - line}, shade, name);
  };
  mark(left_, left_shade, ui.tr("left"));
  mark(right_, right_shade, ui.tr("right"));
  ImGui::InvisibleButton("ruler", {wide, high});
  ui.note("ruler");
  if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  const double place = (ImGui::GetIO().MousePos.x - at.x) / mm;
  double& nearer = std::abs(place - left_) <= std::abs(place - right_) ? left_ : right_;
  nearer = std::clamp(place, 0., static_cast<double>(last));
}

}  // namespace prosector
