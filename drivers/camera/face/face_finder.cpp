#include "drivers/camera/face/face_finder.h"

#include <algorithm>

#include "drivers/camera/hands/net_file.h"

namespace prosector {
namespace {

constexpr double least_face_score = 0.5;
constexpr std::size_t face_points = 6;
constexpr double closer_side = 2;       // of the face's box: so eyes are found best, among 1.3 to 3
constexpr double between_looks = 0.06;  // of the box's side, from its middle

std::optional<AnchoredThing> largest_of(const std::vector<AnchoredThing>& faces) {
  const auto largest =
      std::max_element(faces.begin(), faces.end(), [](const AnchoredThing& a, const AnchoredThing& b) {
        return (a.high - a.low).prod() < (b.high - b.low).prod();
      });
  return largest == faces.end() ? std::nullopt : std::optional(*largest);
}

}  // namespace

FaceFinder::FaceFinder(const std::filesystem::path& folder)
    : network_(load_fetched_net(folder, "face_short_range.tflite", "faces"),
               {128, -1, {{16, 2}, {8, 6}}, face_points}, "faces") {}

std::optional<FoundFace> FaceFinder::find(const Image& image) {
  if (!is_whole(image)) return std::nullopt;
  const auto rough = largest_of(network_.find(image, least_face_score));
  if (!rough) return std::nullopt;
  // Closer, its points are seen more exactly, and the more so in the mean of several looks.
  const double side = (rough->high - rough->low).maxCoeff();
  std::vector<Vec2> sum(face_points, Vec2::Zero());
  int looks = 0;
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)}) {
    const Vec2 middle = (rough->low + rough->high) / 2 + between_looks * side * corner;
    const auto face = largest_of(network_.find_in(image, {middle, closer_side * side, 0}, least_face_score));
    if (!face) continue;
    for (std::size_t k = 0; k < face_points; ++k) sum[k] += face->points[k];
    ++looks;
  }
  if (looks == 0) return std::nullopt;
  for (Vec2& at : sum) at /= looks;
  return FoundFace{rough->score, sum[0], sum[1], sum[2], sum[3], sum[4], sum[5]};
}

}  // namespace prosector
