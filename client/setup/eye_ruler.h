#pragma once
// A ruler on the screen for measuring the distance between the user's eyes. A thin rod in front of it appears
// at a different position for each eye.

#include <optional>

#include "client/setup/interface.h"
#include "client/setup/text_styles.h"
#include "drivers/fitting/guide.h"

namespace prosector {

class EyeRuler {
 public:
  /// Draws a ruler and input fields by which the user measures the distance between their eyes. Returns the
  /// distance as a change of the configuration when the user presses "Calculate", otherwise nullopt. `said`
  /// receives error messages.
  std::optional<GuideOutcome> draw(Interface& ui, Said& said);

 private:
  double card_ = 0;                        // pixels, width of a bank card on the screen; 0: not measured yet
  double left_ = 60, right_ = 40;          // mm: positions of the rod as seen by each eye
  double screen_mm_ = 600, rod_mm_ = 450;  // from the eyes

  void draw_ruler(Interface& ui, double pixel);
};

}  // namespace prosector
