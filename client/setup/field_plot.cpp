#include "client/setup/field_plot.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "client/setup/orthographic_view.h"
#include "client/setup/text_styles.h"

namespace prosector {
namespace {

double rms_of(const std::vector<Vec3>& errors) {
  double squares = 0;
  for (const Vec3& e : errors) squares += e.squaredNorm();
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, errors.size())));
}

double most_of(const std::vector<Vec3>& errors) {
  double most = 0;
  for (const Vec3& e : errors) most = std::max(most, e.norm());
  return most;
}

/// Returns a colour from green for 0 over amber to red for `much` and more.
ImU32 error_shade(double error, double much) {
  const auto share = static_cast<float>(std::clamp(error / much, 0., 1.));
  float r = 0, g = 0, b = 0;
  ImGui::ColorConvertHSVtoRGB(0.36f * (1 - share), 0.68f, 0.95f, r, g, b);
  return ImGui::ColorConvertFloat4ToU32({r, g, b, 1});
}

void draw_arrows(const std::vector<Vec3>& places, const std::vector<Vec3>& errors,
                 const OrthographicView& space, double enlarged, double much, float scale) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t k = 0; k < places.size(); ++k) {
    const ImU32 shade = error_shade(errors[k].norm(), much);
    const ImVec2 from = space.at<ImVec2>(places[k]), to = space.at<ImVec2>(places[k] + enlarged * errors[k]);
    list.AddLine(from, to, shade, 1.6f * scale);
    list.AddCircleFilled(from, 2.4f * scale, shade);
  }
}

}  // namespace

FieldPicture picture_of(const std::vector<FieldSample>& samples, const FieldFit& fit) {
  FieldPicture out;
  out.expected = fit.after;
  for (const FieldSample& s : samples) {
    out.places.push_back(s.truth.p);
    out.before.push_back(s.reported.p - s.truth.p);
    out.after.push_back(fit.map.apply(s.reported).p - s.truth.p);
  }
  return out;
}

void draw_field_picture(Interface& ui, const FieldPicture& picture) {
  if (picture.places.empty()) return;
  const auto scale = static_cast<float>(ui.scale());
  const float wide = ImGui::GetContentRegionAvail().x / 2, high = 230 * scale;
  Vec3 low = picture.places.front(), top = low;
  for (const Vec3& p : picture.places) {
    low = low.cwiseMin(p);
    top = top.cwiseMax(p);
  }
  const double size = (top - low).norm(), much = 2 * rms_of(picture.before);
  const double enlarged = 0.2 * size / std::max(most_of(picture.before), 1e-6);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  OrthographicView space;
  space.view = seen_from(0.4, 0.5);
  space.scale = static_cast<float>(0.95 * std::min(wide, high) / size);
  const Vec3 middle = (low + top) / 2;
  for (const bool after : {false, true}) {
    const ImVec2 centre = {at.x + (after ? 1.5f : 0.5f) * wide, at.y + high / 2};
    space.x = space.y = 0;
    const auto moved = space.at<ImVec2>(middle);
    space.x = centre.x - moved.x;
    space.y = centre.y - moved.y;
    draw_arrows(picture.places, after ? picture.after : picture.before, space, enlarged, much, scale);
  }
  ImGui::Dummy({2 * wide, high});
  ui.note("field picture");
  const float left = ImGui::GetCursorPosX();
  wrapped(ui.tr("error before correction: {:.1f} mm RMS, {:.1f} mm at most", 1e3 * rms_of(picture.before),
                1e3 * most_of(picture.before)));
  ImGui::SameLine(left + wide);
  wrapped(ui.tr("error after correction: {:.1f} mm RMS; expected between the points: {:.1f} mm",
                1e3 * rms_of(picture.after), 1e3 * picture.expected));
  quiet(ui.tr("Arrows show errors magnified {:.1f} times.", enlarged));
}

}  // namespace prosector
