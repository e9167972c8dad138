#include "drivers/camera/face/face_detector.h"

#include <algorithm>
#include <array>

#include "drivers/camera/nets/net_file.h"

namespace prosector {
namespace {

constexpr double least_face_score = 0.5;
constexpr std::size_t face_points = 6;
constexpr double close_up_scale = 2;      // factor of the box' side; best for the eyes, tested from 1.3 to 3
constexpr double close_up_offset = 0.06;  // offset of the search squares, as a share of the box' side

double area_of(const DetectedObject& face) {
  return (face.high - face.low).prod();
}

std::optional<DetectedObject> largest_of(const std::vector<DetectedObject>& faces) {
  const auto largest = std::max_element(
      faces.begin(), faces.end(),
      [](const DetectedObject& a, const DetectedObject& b) { return area_of(a) < area_of(b); });
  return largest == faces.end() ? std::nullopt : std::optional(*largest);
}

}  // namespace

FaceDetector::FaceDetector(const std::filesystem::path& folder)
    : network_(load_fetched_net(folder, "face_short_range.tflite", "faces"),
               {128, -1, {{16, 2}, {8, 6}}, face_points}, "faces") {}

/// Runs the detector on four enlarged, shifted squares around a face and averages the points, which are more
/// exact than in the whole image.
std::optional<DetectedFace> FaceDetector::detect_close_up(const Image& image, const DetectedObject& rough) {
  constexpr std::array<std::array<double, 2>, 4> corners = {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  const double side = (rough.high - rough.low).maxCoeff();
  std::vector<Vec2> sum(face_points, Vec2::Zero());
  double scores = 0;
  int looks = 0;
  for (const auto& [right, down] : corners) {
    const Vec2 middle = (rough.low + rough.high) / 2 + close_up_offset * side * Vec2(right, down);
    const auto face =
        largest_of(network_.find_in(image, {middle, close_up_scale * side, 0}, least_face_score));
    if (!face) continue;
    for (std::size_t k = 0; k < face_points; ++k) sum[k] += face->points[k];
    scores += face->score;
    ++looks;
  }
  if (looks == 0) return std::nullopt;
  for (Vec2& at : sum) at /= looks;
  return DetectedFace{scores / corners.size(), sum[0], sum[1], sum[2], sum[3], sum[4], sum[5]};
}

std::vector<DetectedFace> FaceDetector::find_all(const Image& image) {
  std::vector<DetectedFace> out;
  if (!is_whole(image)) return out;
  std::vector<DetectedObject> rough = network_.find(image, least_face_score);
  std::stable_sort(rough.begin(), rough.end(),
                   [](const DetectedObject& a, const DetectedObject& b) { return area_of(a) > area_of(b); });
  if (rough.size() > max_faces) rough.resize(max_faces);
  for (const DetectedObject& one : rough)
    if (const auto face = detect_close_up(image, one)) out.push_back(*face);
  return out;
}

std::optional<DetectedFace> FaceDetector::find(const Image& image) {
  const std::vector<DetectedFace> faces = find_all(image);
  return faces.empty() ? std::nullopt : std::optional(faces.front());
}

}  // namespace prosector
