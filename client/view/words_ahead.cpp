#include "client/view/words_ahead.h"

#include <algorithm>

namespace prosector {

void add_words_ahead(DrawList& list, const std::string& words) {
  if (words.empty()) return;
  const Vec3 ahead(0, -0.6, -1);                                   // m, of the place between the eyes
  constexpr double height = 0.025, width = 0.8, least_height = 9;  // tangents; points
  const DrawCamera& eye = list.cameras[0];
  const double points = eye.height / (eye.top - eye.bottom) / list.scale;  // of a tangent
  const Vec3 middle = (list.cameras.at(0).pose.p + list.cameras.at(1).pose.p) / 2;
  list.texts.push_back({.text = words,
                        .at = middle + eye.pose.q * ahead,
                        .overlay = false,
                        .height = std::max(points * height, least_height),
                        .wrap = points * width,
                        .ground = TextGround::plate});
}

}  // namespace prosector
