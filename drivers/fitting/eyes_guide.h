#pragma once
// Guides a person who lays crosses on the screen of a head-mounted display over a mark in the room, first
// with the left eye, then with the right one (SPAAM).

#include <array>

#include "drivers/fitting/eye_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/still_window.h"

namespace prosector {

inline constexpr std::size_t most_crosses = 20;  // of each eye

class EyesGuide final : public Guide {
 public:
  /// Takes the mark's place (m, room), the size of each eye's picture in pixels, and how many crosses each
  /// eye lays over the mark: least_seen_points to most_crosses.
  EyesGuide(const ClientConfig& config, const Vec3& mark, int width, int height,
            std::size_t crosses = most_crosses);
  /// Returns how to open the tracker: the head's pose is its receiver's.
  static DeviceConfig device(const ClientConfig& config);

  void take(const DeviceSample& sample) override;
  /// Takes the mark as covered by the cross now. Returns false where the head wasn't still, or is where it
  /// was for the last cross; step() says so.
  bool confirm();
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  /// Tells whether it is the right eye's turn.
  bool right_eye() const { return covered() >= crosses_; }
  /// Fits what an eye saw so far. Throws InputError as fit_eye() does.
  EyeFit fit(bool right) const { return fit_eye(seen_[right ? 1 : 0], width_, height_); }

 private:
  std::size_t covered() const { return seen_[0].size() + seen_[1].size(); }
  Eigen::Vector2d cross() const;

  Vec3 mark_;
  int width_, height_;
  std::size_t crosses_;  // of each eye
  std::size_t station_;
  StillWindow window_;
  std::array<std::vector<SeenPoint>, 2> seen_;  // left eye, right eye
  std::string trouble_;
};

/// Returns what both eyes' fits say, without a head's mount.
GuideOutcome eyes_outcome(const EyeFit& left, const EyeFit& right, const EyesFit& eyes);

}  // namespace prosector
