#include "client/setup/eye_position_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/setup/orthographic_view.h"

namespace prosector {
namespace {

constexpr double usual_aspect = 16. / 9;  // of a screen, because its width is not measured
constexpr double least_shown = 0.9;       // m, before the screen
constexpr ImU32 screen_shade = IM_COL32(200, 205, 212, 255), camera_shade = IM_COL32(110, 190, 255, 255),
                eyes_shade = IM_COL32(90, 210, 120, 255);

/// A direction of the drawing. The screen is at one end, and the eyes are on its front side.
struct Side {
  const char* name;
  Vec3 right, up;            // axes of the drawing
  Vec3 half_screen;          // from its centre to its border, for a height of 1
  float middle_x, middle_y;  // position of the screen's centre, as fractions of the drawing
};

void draw_side(const Side& side, ImVec2 corner, ImVec2 size, const std::optional<Vec3>& eyes,
               const ScreenGeometry& screen, float scale) {
  const double farthest = std::max(least_shown, eyes ? 1.15 * eyes->norm() : 0.);
  Mat3 view;
  view << side.right.transpose(), side.up.transpose(), side.right.cross(side.up).transpose();
  const OrthographicView space = {corner.x + side.middle_x * size.x, corner.y + side.middle_y * size.y,
                                  0.8f * size.y / static_cast<float>(farthest), view};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
  const Vec3 rim = screen.height * side.half_screen;
  list.AddLine(space.at<ImVec2>(-rim), space.at<ImVec2>(rim), screen_shade, 3 * scale);
  const ImVec2 camera = space.at<ImVec2>(screen.camera);
  const float box = 4 * scale;
  list.AddRectFilled({camera.x - box, camera.y - box}, {camera.x + box, camera.y + box}, camera_shade);
  if (eyes) {
    const ImVec2 at = space.at<ImVec2>(*eyes);
    list.AddLine(at, space.at<ImVec2>(Vec3::Zero()), IM_COL32(90, 210, 120, 110), scale);
    list.AddLine(at, camera, IM_COL32(110, 190, 255, 110), scale);
    list.AddCircleFilled(at, 6 * scale, eyes_shade);
  }
  list.AddText({corner.x + 6 * scale, corner.y + 3 * scale}, IM_COL32(158, 166, 178, 255), side.name);
  list.PopClipRect();
  list.AddRect(corner, {corner.x + size.x, corner.y + size.y}, IM_COL32(255, 255, 255, 30), 4 * scale, 0,
               scale);
}

}  // namespace

std::string distance_text(const Catalogue& words, const Vec3& eyes, const ScreenGeometry& screen) {
  return words.tr("{:.0f} mm from the camera and {:.0f} mm from the screen centre to the eyes",
                  1e3 * (eyes - screen.camera).norm(), 1e3 * eyes.norm());
}

std::string direction_text(const Catalogue& words, const Vec3& eyes) {
  constexpr double degrees = 180 / std::numbers::pi;
  const char* const aside = eyes.x() < 0 ? words.tr("to the left") : words.tr("to the right");
  const char* const high = eyes.y() < 0 ? words.tr("below") : words.tr("above");
  return words.tr(
      "Eyes, from the screen centre: {:.0f} mm {} ({:.0f}°), {:.0f} mm {} ({:.0f}°), {:.0f} mm in front",
      1e3 * std::abs(eyes.x()), aside, degrees * std::abs(std::atan2(eyes.x(), std::abs(eyes.z()))),
      1e3 * std::abs(eyes.y()), high, degrees * std::abs(std::atan2(eyes.y(), std::abs(eyes.z()))),
      1e3 * eyes.z());
}

void draw_eye_position(Interface& ui, const std::optional<Vec3>& eyes, const ScreenGeometry& screen) {
  const auto scale = static_cast<float>(ui.scale());
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 at = ImGui::GetCursorScreenPos(),
               size = {(ImGui::GetContentRegionAvail().x - gap) / 2, 200 * scale};
  const Side above = {ui.tr("from above"),          Vec3::UnitX(), -Vec3::UnitZ(),
                      Vec3(usual_aspect / 2, 0, 0), 0.5f,          0.14f};
  const Side beside = {ui.tr("from the right"), -Vec3::UnitZ(), Vec3::UnitY(), Vec3(0, 0.5, 0), 0.9f, 0.5f};
  draw_side(above, at, size, eyes, screen, scale);
  draw_side(beside, {at.x + size.x + gap, at.y}, size, eyes, screen, scale);
  ImGui::Dummy({2 * size.x + gap, size.y});
  ui.note("eyes picture");
}

}  // namespace prosector
