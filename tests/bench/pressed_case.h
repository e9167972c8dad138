#pragma once
// The cases press and organ: a ball pressed into tissue and held.

#include <memory>

#include "server/calibration/rung.h"
#include "tests/bench/trade_case.h"

namespace prosector {

/// A pressed body: the ball moves to its depth within 0.5 s and is then held.
class PressedSpecimen final : public Steppable {
 public:
  PressedSpecimen(const PressedBody& body, const SoftDesc& desc, double dt);
  VecX positions() const override;
  StepFigures step(double dt, const Vec3& gravity) override;
  std::size_t nodes() const;
  const PressedTissue& tissue() const { return tissue_; }

 private:
  double depth_;  // m
  double dt_;     // s, tick duration
  PressedTissue tissue_;
  int steps_ = 0;
};

/// Returns a pressed body with `cells` cells along its longest side. Throws InputError if the configuration
/// refuses it.
std::unique_ptr<PressedSpecimen> make_pressed(const PressedBody& body, const Rung& rung, unsigned cells,
                                              double dt);

/// Presses and holds the body; returns the force, or an empty row if the run stopped early.
ReportRow measure_press(const PressedSpecimen& specimen, Runner& runner);

}  // namespace prosector
