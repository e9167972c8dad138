#include "drivers/camera/hands/palm_detector.h"

#include <cmath>

namespace prosector {
namespace {

constexpr double least_palm_score = 0.3;
// Points of a palm detection.
constexpr std::size_t palm_wrist = 0, palm_middle_knuckle = 2, palm_points = 7;
// Side of the hand's square and its shift along the fingers, as factors of the palm box' side.
constexpr double hand_side = 2.6, hand_shift = 0.5;

ImageRegion hand_around(const DetectedObject& palm) {
  const Vec2 up = palm.points[palm_middle_knuckle] - palm.points[palm_wrist];
  const double side = (palm.high - palm.low).maxCoeff();
  ImageRegion out;
  out.angle = std::atan2(up.x(), -up.y());
  out.center = (palm.low + palm.high) / 2 + Eigen::Rotation2Dd(out.angle) * Vec2(0, -hand_shift * side);
  out.side = hand_side * side;
  return out;
}

}  // namespace

PalmDetector::PalmDetector(NetPlan plan)
    : network_(std::move(plan), {192, 0, {{24, 2}, {12, 6}}, palm_points}, "palms") {}

std::vector<ImageRegion> PalmDetector::find(const Image& image) {
  std::vector<ImageRegion> out;
  for (const DetectedObject& palm : network_.find(image, least_palm_score)) out.push_back(hand_around(palm));
  return out;
}

}  // namespace prosector
