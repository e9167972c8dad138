#include "drivers/camera/hands/hand_landmarks.h"

#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t landmark_input = 224;  // pixels per side
// Points that determine the next square; outer finger joints move too fast.
constexpr std::array<std::size_t, 12> steady_points = {0, 1, 2, 3, 5, 6, 9, 10, 13, 14, 17, 18};
constexpr std::size_t index_point = 5, middle_point = 9, ring_point = 13, little_point = 17;
constexpr double next_side = 2, next_shift = 0.1;

}  // namespace

LandmarkNetwork::LandmarkNetwork(NetPlan plan) : network_(std::move(plan)) {
  if (network_.input().size() != landmark_input * landmark_input * 3 || network_.outputs() != 4 ||
      network_.output(0).size() != 3 * hand_points || network_.output(1).size() != 1 ||
      network_.output(2).size() != 1)
    throw InputError("the file is not a hand landmark network: fetch it with deploy/fetch_models.sh");
}

LandmarkAnswer LandmarkNetwork::look(const Image& image, const ImageRegion& region) {
  sample_region(image, region, landmark_input, Outside::edge, network_.input());
  brighten(network_.input());
  network_.run();
  const auto places = network_.output(0);
  LandmarkAnswer out;
  for (std::size_t k = 0; k < hand_points; ++k) {
    out.points[k] =
        region.pixel(Vec2(places[3 * k], places[3 * k + 1]) / static_cast<double>(landmark_input));
    out.depths[k] = places[3 * k + 2] * region.side / static_cast<double>(landmark_input);
  }
  out.presence = network_.output(1)[0];
  out.right = network_.output(2)[0];
  return out;
}

double length_of_hand(const HandPoints& points) {
  // The palm is 94 mm of the hand's 190 mm long.
  const double palm = (points[middle_point] - points[0]).norm(),
               breadth = (points[little_point] - points[index_point]).norm();
  return std::max(2.0 * palm, 3.1 * breadth);
}

ImageRegion region_around(const HandPoints& points) {
  const Vec2 knuckles = points[middle_point] / 2 + (points[index_point] + points[ring_point]) / 4;
  const Vec2 up = knuckles - points[0];
  ImageRegion out;
  out.angle = std::atan2(up.x(), -up.y());
  const Eigen::Rotation2Dd turn(out.angle);
  Vec2 low = Vec2::Constant(1e9), high = -low;
  for (const std::size_t k : steady_points) {
    const Vec2 x = turn.inverse() * points[k];
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Vec2 size = high - low;
  out.center = turn * ((low + high) / 2 + Vec2(0, -next_shift * size.y()));
  out.side = next_side * size.maxCoeff();
  return out;
}

}  // namespace prosector
