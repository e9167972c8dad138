#include "drivers/camera/hands/palm_finder.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t palm_input = 192;  // pixels a side
constexpr std::size_t palm_anchors = 2016, palm_values = 18;
constexpr double palm_threshold = 0.3;  // who asks looks closer
constexpr double same_palm = 0.3;       // overlap
// Points of an answer, after its box.
constexpr std::size_t palm_wrist = 0, palm_middle_knuckle = 2;
// The hand's square: this many of the palm box's sides, shifted along the fingers by this many.
constexpr double hand_side = 2.6, hand_shift = 0.5;

std::vector<Vec2> make_anchors() {
  std::vector<Vec2> out;
  const auto grid = [&](int side, int each) {
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (int k = 0; k < each; ++k) out.emplace_back((x + 0.5) / side, (y + 0.5) / side);
  };
  grid(24, 2);
  grid(12, 6);
  return out;
}

double logistic(double x) {
  return 1 / (1 + std::exp(-std::clamp(x, -100.0, 100.0)));
}

/// Values of an answer in units of the network's input, with how sure it is.
struct PalmAnswer {
  double score;
  Eigen::Matrix<double, palm_values, 1> values;  // box's centre and size, then x, y of points
};

FoundPalm palm_of(const PalmAnswer& answer, const PictureRegion& whole) {
  const auto point = [&](std::size_t k) {
    const auto at = static_cast<Eigen::Index>(k);
    return whole.pixel({answer.values[at], answer.values[at + 1]});
  };
  FoundPalm out;
  out.score = answer.score;
  const Vec2 center = point(0), size = whole.side * answer.values.segment<2>(2).cwiseMax(0);
  out.low = center - size / 2;
  out.high = center + size / 2;
  const Vec2 up = point(4 + 2 * palm_middle_knuckle) - point(4 + 2 * palm_wrist);
  out.region.angle = std::atan2(up.x(), -up.y());
  out.region.center = center + Eigen::Rotation2Dd(out.region.angle) * Vec2(0, -hand_shift * size.maxCoeff());
  out.region.side = hand_side * size.maxCoeff();
  return out;
}

}  // namespace

double overlap(const FoundPalm& a, const FoundPalm& b) {
  const Vec2 both = (a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low)).cwiseMax(0);
  const double shared = both.prod(), all = (a.high - a.low).prod() + (b.high - b.low).prod() - shared;
  return all > 0 ? shared / all : 0;
}

PalmFinder::PalmFinder(NetPlan plan) : network_(std::move(plan)), anchors_(make_anchors()) {
  if (network_.input().size() != palm_input * palm_input * 3 || network_.outputs() != 2 ||
      network_.output(0).size() != palm_anchors * palm_values || network_.output(1).size() != palm_anchors)
    throw InputError("is no network that finds palms");
}

std::vector<FoundPalm> PalmFinder::find(const Image& image) {
  const PictureRegion whole{{(image.width - 1) / 2.0, (image.height - 1) / 2.0},
                            static_cast<double>(std::max(image.width, image.height)),
                            0};
  sample_region(image, whole, palm_input, Outside::black, network_.input());
  network_.run();
  const auto values = network_.output(0), scores = network_.output(1);
  std::vector<PalmAnswer> answers;
  for (std::size_t k = 0; k < palm_anchors; ++k) {
    PalmAnswer answer{logistic(scores[k]), {}};
    if (answer.score < palm_threshold) continue;
    for (std::size_t v = 0; v < palm_values; ++v) {
      const bool size = v == 2 || v == 3;
      answer.values[static_cast<Eigen::Index>(v)] =
          values[k * palm_values + v] / static_cast<double>(palm_input) + (size ? 0 : anchors_[k][v % 2]);
    }
    if (answer.values.allFinite()) answers.push_back(answer);
  }
  std::sort(answers.begin(), answers.end(), [](const auto& a, const auto& b) { return a.score > b.score; });

  // Answers about the same palm are averaged, the surer ones more.
  std::vector<FoundPalm> out;
  while (!answers.empty()) {
    const FoundPalm best = palm_of(answers.front(), whole);
    PalmAnswer mean{best.score, Eigen::Matrix<double, palm_values, 1>::Zero()};
    double weight = 0;
    std::erase_if(answers, [&](const PalmAnswer& answer) {
      if (&answer != &answers.front() && overlap(best, palm_of(answer, whole)) < same_palm) return false;
      mean.values += answer.score * answer.values;
      weight += answer.score;
      return true;
    });
    mean.values /= weight;
    out.push_back(palm_of(mean, whole));
  }
  return out;
}

}  // namespace prosector
