#pragma once
// Guides a user of a head-mounted display through aligning crosses on its screen with a mark in the room
// (SPAAM), first with the left eye, then with the right eye.

#include <array>

#include "drivers/fitting/eye_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/stillness_detector.h"

namespace prosector {

inline constexpr std::size_t max_crosses = 20;  // per eye

class EyesGuide final : public Guide {
 public:
  /// Starts with the mark's position (m, room), the size of each eye's image in pixels, and the number of
  /// crosses per eye. `crosses` is min_seen_points to max_crosses.
  EyesGuide(const ClientConfig& config, const Vec3& mark, int width, int height,
            std::size_t crosses = max_crosses);
  /// Returns the configuration to open the tracker with: the head's pose is that of its receiver.
  static DeviceConfig device(const ClientConfig& config);

  void take(const DeviceSample& sample) override;
  /// Records that the cross covers the mark now. Returns false if the head wasn't still or hasn't moved since
  /// the last cross; step() reports the reason.
  bool confirm();
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  /// Returns whether the right eye is being calibrated.
  bool right_eye() const { return covered() >= crosses_; }
  /// Fits the projection of one eye from its records so far. Throws InputError like fit_eye().
  EyeFit fit(bool right) const { return fit_eye(seen_[right ? 1 : 0], width_, height_); }

 private:
  std::size_t covered() const { return seen_[0].size() + seen_[1].size(); }
  Eigen::Vector2d cross() const;

  Vec3 mark_;
  int width_, height_;
  std::size_t crosses_;  // per eye
  std::size_t station_;
  StillnessDetector window_;
  std::array<std::vector<SeenPoint>, 2> seen_;  // left eye, right eye
  std::string trouble_;
};

/// Returns the outcome for both eyes' fits, without a head mount.
GuideOutcome eyes_outcome(const EyeFit& left, const EyeFit& right, const EyesFit& eyes);

}  // namespace prosector
