#include "drivers/camera/nets/anchor_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double same_object_overlap = 0.3;  // intersection over union above which two boxes are one object
constexpr std::size_t box_values = 4;

std::vector<Vec2> make_anchors(const AnchorLayout& layout) {
  std::vector<Vec2> out;
  for (const AnchorLayout::Grid& grid : layout.grids)
    for (int y = 0; y < grid.side; ++y)
      for (int x = 0; x < grid.side; ++x)
        for (int k = 0; k < grid.each; ++k) out.emplace_back((x + 0.5) / grid.side, (y + 0.5) / grid.side);
  return out;
}

double logistic(double x) {
  return 1 / (1 + std::exp(-std::clamp(x, -100.0, 100.0)));
}

}  // namespace

double overlap(const DetectedObject& a, const DetectedObject& b) {
  const Vec2 both = (a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low)).cwiseMax(0);
  const double shared = both.prod(), all = (a.high - a.low).prod() + (b.high - b.low).prod() - shared;
  return all > 0 ? shared / all : 0;
}

AnchorDetector::AnchorDetector(NetPlan plan, AnchorLayout layout, const char* what)
    : layout_(std::move(layout)),
      values_(box_values + 2 * layout_.points),
      network_(std::move(plan)),
      anchors_(make_anchors(layout_)) {
  if (network_.input().size() != layout_.input * layout_.input * 3 || network_.outputs() != 2 ||
      network_.output(0).size() != anchors_.size() * values_ || network_.output(1).size() != anchors_.size())
    throw InputError(
        fmt::format("the file is not a network that detects {}: fetch it with deploy/fetch_models.sh", what));
}

std::vector<AnchorDetector::Answer> AnchorDetector::answers(double least_score) const {
  const auto values = network_.output(0), scores = network_.output(1);
  std::vector<Answer> out;
  for (std::size_t k = 0; k < anchors_.size(); ++k) {
    Answer answer{logistic(scores[k]), Eigen::VectorXd(static_cast<Eigen::Index>(values_))};
    if (answer.score < least_score) continue;
    for (std::size_t v = 0; v < values_; ++v) {
      const bool size = v == 2 || v == 3;
      answer.values[static_cast<Eigen::Index>(v)] =
          values[k * values_ + v] / static_cast<double>(layout_.input) + (size ? 0 : anchors_[k][v % 2]);
    }
    if (answer.values.allFinite()) out.push_back(std::move(answer));
  }
  std::sort(out.begin(), out.end(), [](const Answer& a, const Answer& b) { return a.score > b.score; });
  return out;
}

DetectedObject AnchorDetector::thing_of(const Answer& answer, const ImageRegion& square) const {
  const auto point = [&](std::size_t k) {
    const auto at = static_cast<Eigen::Index>(k);
    return square.pixel({answer.values[at], answer.values[at + 1]});
  };
  DetectedObject out;
  out.score = answer.score;
  const Vec2 center = point(0), size = square.side * answer.values.segment<2>(2).cwiseMax(0);
  out.low = center - size / 2;
  out.high = center + size / 2;
  for (std::size_t k = 0; k < layout_.points; ++k) out.points.push_back(point(box_values + 2 * k));
  return out;
}

std::vector<DetectedObject> AnchorDetector::find(const Image& image, double least_score) {
  const ImageRegion whole{{(image.width - 1) / 2.0, (image.height - 1) / 2.0},
                          static_cast<double>(std::max(image.width, image.height)),
                          0};
  return find_in(image, whole, least_score);
}

std::vector<DetectedObject> AnchorDetector::find_in(const Image& image, const ImageRegion& square,
                                                    double least_score) {
  sample_region(image, square, layout_.input, Outside::black, network_.input());
  brighten(network_.input());
  for (float& x : network_.input()) x = layout_.darkest + (1 - layout_.darkest) * x;
  network_.run();
  // Detections of the same object are averaged, weighted by score.
  std::vector<Answer> left = answers(least_score);
  std::vector<DetectedObject> out;
  while (!left.empty()) {
    const DetectedObject best = thing_of(left.front(), square);
    Answer mean{best.score, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(values_))};
    double weight = 0;
    std::vector<Answer> others;
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (k > 0 && overlap(best, thing_of(left[k], square)) < same_object_overlap) {
        others.push_back(std::move(left[k]));
        continue;
      }
      mean.values += left[k].score * left[k].values;
      weight += left[k].score;
    }
    mean.values /= weight;
    out.push_back(thing_of(mean, square));
    left = std::move(others);
  }
  return out;
}

}  // namespace prosector
