#pragma once
// A ruler on the screen, by which one finds how far one's eyes are apart: a thin rod before it is seen at
// another place with each eye.

#include <optional>

#include "client/setup/interface.h"
#include "client/setup/words.h"
#include "drivers/fitting/guide.h"

namespace prosector {

class EyeRuler {
 public:
  /// Shows it. Returns what came out once that is asked for; `said` tells what doesn't go.
  std::optional<GuideOutcome> draw(Interface& ui, Said& said);

 private:
  double card_ = 0;                        // pixels that a bank card is wide; 0: not measured yet
  double left_ = 60, right_ = 40;          // mm: where each eye sees the rod
  double screen_mm_ = 600, rod_mm_ = 450;  // from the eyes

  void draw_ruler(Interface& ui, double pixel);
};

}  // namespace prosector
