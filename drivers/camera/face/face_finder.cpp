#include "drivers/camera/face/face_finder.h"

#include <algorithm>
#include <cmath>

#include "drivers/camera/hands/net_file.h"

namespace prosector {
namespace {

constexpr double least_face_score = 0.5;
constexpr std::size_t face_points = 6;
constexpr double closer_side = 2.5;     // of the face's box
constexpr double between_eyes = 0.063;  // m, of adults in the mean
constexpr double nose_ahead = 0.45;     // of that: the nose's tip before the eyes
constexpr double most_yaw = 0.9;        // rad: farther round the points say nothing

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
  // Closer, its points are seen more exactly.
  const PictureRegion near{(rough->low + rough->high) / 2,
                           closer_side * (rough->high - rough->low).maxCoeff(), 0};
  const auto face = largest_of(network_.find_in(image, near, least_face_score));
  const auto& p = face ? face->points : rough->points;
  return FoundFace{rough->score, p[0], p[1], p[2], p[3], p[4], p[5]};
}

EyesPlace place_eyes(const FoundFace& face, const Lens& lens) {
  // A camera sees a user's right eye on the left.
  const Vec2 right = lens.ray(face.right_eye).head<2>(), left = lens.ray(face.left_eye).head<2>(),
             nose = lens.ray(face.nose).head<2>();
  const Vec2 across = left - right, middle = (left + right) / 2;
  const double distance = std::max(across.norm(), 1e-6);
  EyesPlace out;
  out.yaw = std::clamp(std::atan((nose - middle).dot(across) / (distance * distance * nose_ahead)), -most_yaw,
                       most_yaw);
  out.roll = std::atan2(across.y(), across.x());
  out.middle = between_eyes * std::cos(out.yaw) / distance * Vec3(middle.x(), middle.y(), 1);
  return out;
}

}  // namespace prosector
