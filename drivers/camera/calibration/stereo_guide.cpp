#include "drivers/camera/calibration/stereo_guide.h"

#include <fmt/format.h>

#include <cmath>

namespace prosector {
namespace {

constexpr std::array<const char*, 2> camera_names = {"first", "second"};

}  // namespace

void StereoGuide::take(std::size_t camera, const Frame& frame) {
  guides_[camera].take(frame.image);
  newest_[camera] = {frame.time_ns, guides_[camera].views().size()};
  const auto &first = guides_[0].resting(), &second = guides_[1].resting();
  apart_ = false;
  // A pose that is new to either camera adds a pair.
  const std::size_t kept = newest_[0].kept + newest_[1].kept;
  if (!first || !second || kept == kept_) return;
  apart_ = std::abs(static_cast<double>(newest_[0].time_ns - newest_[1].time_ns)) * 1e-9 > most_apart;
  if (apart_) return;
  pairs_.push_back({*first, *second});
  kept_ = kept;
}

StereoGuideStep StereoGuide::step() const {
  const std::array<LensGuideStep, 2> steps = {guides_[0].step(), guides_[1].step()};
  StereoGuideStep out;
  out.views = {steps[0].views, steps[1].views};
  out.pairs = pairs_.size();
  out.done = steps[0].done && steps[1].done && out.pairs >= recommended_stereo_pairs;
  if (out.done) {
    out.instruction = "that is enough";
    return out;
  }
  if (apart_) {
    out.instruction =
        fmt::format("the cameras' images are more than {:.0f} ms apart: hold the board still for longer",
                    1e3 * most_apart);
    return out;
  }
  // The camera with fewer views determines the instruction.
  const std::size_t behind = steps[0].done || (!steps[1].done && steps[1].views < steps[0].views) ? 1 : 0;
  out.instruction =
      steps[behind].done
          ? std::string("hold the board in view of both cameras, each time in another orientation")
          : fmt::format("{} camera: {}", camera_names[behind], steps[behind].instruction);
  return out;
}

}  // namespace prosector
