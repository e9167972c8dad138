#pragma once
// Guides a person through the poses that tell what a glove's counts mean.

#include <deque>

#include "drivers/fitting/glove_fit.h"
#include "drivers/fitting/guide.h"

namespace prosector {

class GloveGuide final : public Guide {
 public:
  /// Takes `least_span`, counts by which each sensor must differ between flat hand and fist.
  GloveGuide(std::size_t hand, double least_span);
  /// Returns the least span of a glove by its address: of 255 counts, or of the 4095 of those on USB.
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
  HeldCounts between(std::size_t first, std::size_t end) const;
  double filled() const;

  std::size_t hand_;
  double least_span_;
  std::deque<Reading> window_;
  std::vector<HeldCounts> held_;
};

}  // namespace prosector
