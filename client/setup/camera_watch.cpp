#include "client/setup/camera_watch.h"

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr double rate_weight = 0.1;  // weight of the newest image in the displayed rate

}  // namespace

CameraWatch::CameraWatch(std::string address)
    : thread_(
          std::move(address),
          [this](const Camera& camera) {
            const std::lock_guard lock(mutex_);
            identity_ = camera.identity();
          },
          [this](const Frame& frame) { see(frame); }) {}

EvaluatedImage CameraWatch::picture() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

std::string CameraWatch::identity() const {
  const std::lock_guard lock(mutex_);
  return identity_;
}

void CameraWatch::guide(const Board& board) {
  const std::lock_guard lock(guide_mutex_);
  guide_.emplace(board);
}

void CameraWatch::stop_guide() {
  const std::lock_guard lock(guide_mutex_);
  guide_.reset();
}

std::vector<LensView> CameraWatch::views() const {
  const std::lock_guard lock(guide_mutex_);
  return guide_ ? guide_->views() : std::vector<LensView>();
}

void CameraWatch::see(const Frame& frame) {
  EvaluatedImage now;
  now.image = std::make_shared<const Image>(frame.image);
  const GreyImage grey = grey_of(frame.image);
  now.brightness = brightness_of(grey);
  {
    const std::lock_guard lock(guide_mutex_);
    if (guide_) {
      guide_->take(frame.image);
      now.step = guide_->step();
      now.tags = now.step.seen;
      now.covered = covered_cells(guide_->views());
    }
  }
  if (now.tags.empty()) now.tags = finder_.find(grey);
  const std::lock_guard lock(mutex_);
  now.number = last_.number + 1;
  now.rate = last_.rate;
  if (const std::int64_t step_ns = frame.time_ns - std::exchange(last_ns_, frame.time_ns);
      now.number > 1 && step_ns > 0) {
    const double rate = 1e9 / static_cast<double>(step_ns);
    now.rate = last_.rate == 0 ? rate : 1 / ((1 - rate_weight) / last_.rate + rate_weight / rate);
  }
  last_ = std::move(now);
}

}  // namespace prosector
