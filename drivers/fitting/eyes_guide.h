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
  /// Starts a guided calibration of both eyes, in which the user aligns displayed crosses with a mark at a
  /// known position (m, room frame). `width` and `height` are the size of each eye's image in pixels.
  /// `crosses` is the number of crosses per eye, from min_seen_points to max_crosses.
  EyesGuide(const ClientConfig& config, const Vec3& mark, int width, int height,
            std::size_t crosses = max_crosses);
  /// Returns the tracker settings to use during the eye calibration. The head's pose is that of its receiver,
  /// because the head's mount is still unknown.
  static DeviceConfig device(const ClientConfig& config);

  void take(const DeviceSample& sample) override;
  /// Records that the user now sees the displayed cross on the mark in the room. Returns false if the head
  /// was not still or has not moved since the last cross, or if all crosses are recorded. step() gives the
  /// reason to the user.
  bool confirm();
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  /// Returns whether the user has aligned all crosses with the left eye, so that the right eye is being
  /// calibrated.
  bool right_eye() const { return covered() >= crosses_; }
  /// Fits the projection of one eye (`right` or left) to the crosses that the user has aligned with the mark
  /// so far. Throws InputError if there are fewer than 12 or the points lie nearly in a plane.
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
  std::string rejection_;
};

/// Returns the result of an eye calibration for the user: text lines, and changes to the configuration's eye
/// keys without the head's mount.
GuideOutcome eyes_outcome(const EyeFit& left, const EyeFit& right, const EyesFit& eyes);

}  // namespace prosector
