#pragma once
// Guides a user through the hand poses that calibrate a glove's counts.

#include <deque>

#include "drivers/fitting/glove_fit.h"
#include "drivers/fitting/guide.h"

namespace prosector {

class GloveGuide final : public Guide {
 public:
  /// Starts a guided calibration of the glove on `hand` (left_hand or right_hand). `least_span` is the number
  /// of counts by which each sensor must differ between flat hand and fist.
  GloveGuide(std::size_t hand, double least_span);
  /// Returns the number of counts by which each sensor of the glove at `address` must differ between flat
  /// hand and fist. It is larger for USB gloves (0 … 4095 counts) than for others (0 … 255).
  static double least_span_of(const std::string& address);

  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  GloveFit fit() const { return fit_glove(held_, least_span_); }

 private:
  struct Reading {
    std::int64_t time_ns;
    std::array<std::uint16_t, fingers> counts;
  };
  PoseCounts between(std::size_t first, std::size_t end) const;
  double filled() const;

  std::size_t hand_;
  double least_span_;
  std::deque<Reading> window_;
  std::vector<PoseCounts> held_;
};

}  // namespace prosector
