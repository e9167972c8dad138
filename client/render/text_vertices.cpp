#include "client/render/text_vertices.h"

#include <array>

namespace prosector {
namespace {

constexpr std::array<std::size_t, 6> two_triangles = {0, 1, 2, 0, 2, 3};

}  // namespace

void add_glyph(std::vector<GlyphVertex>& out, const std::array<Eigen::Vector4d, 4>& corners,
               const GlyphSpot& spot, const Vec3& color) {
  const auto left = static_cast<float>(spot.x), right = static_cast<float>(spot.x + spot.width);
  const auto top = static_cast<float>(spot.y), bottom = static_cast<float>(spot.y + spot.height);
  const std::array<Eigen::Vector2f, 4> texels = {
      {{left, top}, {right, top}, {right, bottom}, {left, bottom}}};
  for (const std::size_t k : two_triangles)
    out.push_back({corners[k].cast<float>(), color.cast<float>(), texels[k]});
}

void add_plate(std::vector<PlateVertex>& out, const ScreenBox& box, const PlateLook& look,
               const Eigen::Vector2d& picture) {
  const Eigen::Vector2d middle((box.left + box.right) / 2, (box.top + box.bottom) / 2);
  const Eigen::Vector2d half((box.right - box.left) / 2, (box.bottom - box.top) / 2);
  const double radius = std::min(look.radius, half.minCoeff());
  const Eigen::Vector4f shape = Eigen::Vector4d(half.x(), half.y(), radius, look.rim_width).cast<float>();
  const Eigen::Vector2d reach = half.array() + 0.5;  // includes pixels that the border covers partly
  const std::array<Eigen::Vector2d, 4> signs = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (const std::size_t k : two_triangles) {
    const Eigen::Vector2d place = signs[k].cwiseProduct(reach);
    out.push_back({clip_of(middle + place, picture).head<2>().cast<float>(), place.cast<float>(), look.fill,
                   look.rim, shape});
  }
}

Eigen::Vector4d clip_of(const Eigen::Vector2d& pixels, const Eigen::Vector2d& picture) {
  return {2 * pixels.x() / picture.x() - 1, 1 - 2 * pixels.y() / picture.y(), 0, 1};
}

}  // namespace prosector
