#pragma once
// Options of the displayed scene: whose views, and what is added to the bodies.

#include <string>
#include <vector>

#include "client/view/value_paint.h"

namespace prosector {

struct ViewOptions {
  std::string follow;               // name of the participant whose eyes give the view; empty: own camera
  std::vector<std::string> insets;  // names of participants whose views are shown as insets
  bool overlay = true;              // statistics and axes
  bool wireframes = false;          // of the bodies' collision shapes; a desk user's C key toggles them
  Shown shown = Shown::none;        // quantity shown by soft bodies' colours; a desk user's V key changes it
};

}  // namespace prosector
