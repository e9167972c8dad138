#include "drivers/camera/face/face_finder.h"

#include <algorithm>
#include <array>

#include "drivers/camera/hands/net_file.h"

namespace prosector {
namespace {

constexpr double least_face_score = 0.5;
constexpr std::size_t face_points = 6;
constexpr double closer_side = 2;       // of the face's box: so eyes are found best, among 1.3 to 3
constexpr double between_looks = 0.06;  // of the box's side, from its middle

double area_of(const AnchoredThing& face) {
  return (face.high - face.low).prod();
}

std::optional<AnchoredThing> largest_of(const std::vector<AnchoredThing>& faces) {
  const auto largest = std::max_element(
      faces.begin(), faces.end(),
      [](const AnchoredThing& a, const AnchoredThing& b) { return area_of(a) < area_of(b); });
  return largest == faces.end() ? std::nullopt : std::optional(*largest);
}

}  // namespace

FaceFinder::FaceFinder(const std::filesystem::path& folder)
    : network_(load_fetched_net(folder, "face_short_range.tflite", "faces"),
               {128, -1, {{16, 2}, {8, 6}}, face_points}, "faces") {}

/// Looks at a face several times, closer: so its points are seen more exactly, the more so in the mean.
std::optional<FoundFace> FaceFinder::look_closer(const Image& image, const AnchoredThing& rough) {
  constexpr std::array<std::array<double, 2>, 4> corners = {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  const double side = (rough.high - rough.low).maxCoeff();
  std::vector<Vec2> sum(face_points, Vec2::Zero());
  double scores = 0;
  int looks = 0;
  for (const auto& [right, down] : corners) {
    const Vec2 middle = (rough.low + rough.high) / 2 + between_looks * side * Vec2(right, down);
    const auto face = largest_of(network_.find_in(image, {middle, closer_side * side, 0}, least_face_score));
    if (!face) continue;
    for (std::size_t k = 0; k < face_points; ++k) sum[k] += face->points[k];
    scores += face->score;
    ++looks;
  }
  if (looks == 0) return std::nullopt;
  for (Vec2& at : sum) at /= looks;
  return FoundFace{scores / corners.size(), sum[0], sum[1], sum[2], sum[3], sum[4], sum[5]};
}

std::vector<FoundFace> FaceFinder::find_all(const Image& image) {
  std::vector<FoundFace> out;
  if (!is_whole(image)) return out;
  std::vector<AnchoredThing> rough = network_.find(image, least_face_score);
  std::stable_sort(rough.begin(), rough.end(),
                   [](const AnchoredThing& a, const AnchoredThing& b) { return area_of(a) > area_of(b); });
  if (rough.size() > most_faces) rough.resize(most_faces);
  for (const AnchoredThing& one : rough)
    if (const auto face = look_closer(image, one)) out.push_back(*face);
  return out;
}

std::optional<FoundFace> FaceFinder::find(const Image& image) {
  const std::vector<FoundFace> faces = find_all(image);
  return faces.empty() ? std::nullopt : std::optional(faces.front());
}

}  // namespace prosector
