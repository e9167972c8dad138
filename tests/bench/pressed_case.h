#pragma once
// Press, organ: a ball pressed into tissue by a rung, and held.

#include <memory>

#include "server/calibration/rung.h"
#include "tests/bench/trade_case.h"

namespace prosector {

/// Pressed within half a second, then held.
class PressedSpecimen final : public Steppable {
 public:
  PressedSpecimen(const PressedBody& body, const SoftDesc& desc, double dt);
  VecX positions() const override;
  StepFigures step(double dt, const Vec3& gravity) override;
  std::size_t nodes() const;
  const PressedTissue& tissue() const { return tissue_; }

 private:
  double depth_;  // m
  double dt_;     // s: a tick
  PressedTissue tissue_;
  int steps_ = 0;
};

/// Returns one of cells that go `cells` times into the body's longest side. Throws InputError when the rung
/// refuses it.
std::unique_ptr<PressedSpecimen> make_pressed(const PressedBody& body, const Rung& rung, unsigned cells,
                                              double dt);

/// Presses and holds it; returns the force. Empty: it did not get that far.
ReportRow measure_press(const PressedSpecimen& specimen, Runner& runner);

}  // namespace prosector
