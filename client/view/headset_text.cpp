#include "client/view/headset_text.h"

#include <algorithm>

namespace prosector {
namespace {

// Points per unit tangent, so that labels of 13 points are 1.2° high.
constexpr double points_of_tangent = 600;

double pixels_of_tangent(const DrawCamera& eye) {
  return eye.height / (eye.top - eye.bottom);
}

}  // namespace

double headset_pixels_per_point(const DrawCamera& eye) {
  return std::max(1.0, pixels_of_tangent(eye) / points_of_tangent);
}

void add_headset_text(DrawList& list, const std::string& words) {
  if (words.empty()) return;
  const Vec3 ahead(0, -0.6, -1);                                   // m, from the midpoint of the eyes
  constexpr double height = 0.025, width = 0.8, least_height = 9;  // tangents; points
  const DrawCamera& eye = list.cameras[0];
  const double points = pixels_of_tangent(eye) / list.scale;  // points per unit tangent
  const Vec3 middle = (list.cameras.at(0).pose.p + list.cameras.at(1).pose.p) / 2;
  list.texts.push_back({.text = words,
                        .at = middle + eye.pose.q * ahead,
                        .overlay = false,
                        .height = std::max(points * height, least_height),
                        .wrap = points * width,
                        .ground = TextGround::plate});
}

}  // namespace prosector
