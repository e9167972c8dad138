#include "client/ar/paper_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace prosector {
namespace {

constexpr std::size_t least_places = 8;

// Returns the linear light of an sRGB value, IEC 61966-2-1.
double light_of(std::uint8_t byte) {
  const double shown = byte / 255.0;
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

}  // namespace

std::optional<Vec3> paper_light(const Image& picture, const Lens& straight, const Board& board,
                                const Pose& camera_board) {
  std::array<std::vector<std::uint8_t>, 3> seen;
  for (const BoardTag& tag : board.tags) {
    const double rim = tag.size * (0.5 + 0.5 / black_cells);  // centre line of the white cells around the tag
    for (const double along : {-0.3, 0.0, 0.3})
      for (const auto& [x, y] : {std::pair{rim, along * tag.size},
                                 {-rim, along * tag.size},
                                 {along * tag.size, rim},
                                 {along * tag.size, -rim}}) {
        const Vec3 place = camera_board * (tag.pose * Vec3(x, y, 0));
        if (place.z() <= 0) continue;
        const Vec2 pixel = straight.project(place);
        if (!straight.sees(pixel)) continue;
        const std::uint8_t* rgb =
            picture.pixel(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
        for (std::size_t c = 0; c < 3; ++c) seen[c].push_back(rgb[c]);
      }
  }
  if (seen[0].size() < least_places) return std::nullopt;
  Vec3 out;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto middle = seen[c].begin() + static_cast<std::ptrdiff_t>(seen[c].size() / 2);
    std::nth_element(seen[c].begin(), middle, seen[c].end());
    out[static_cast<int>(c)] = light_of(*middle);
  }
  return out;
}

}  // namespace prosector
