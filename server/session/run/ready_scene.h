#pragma once
// A compiled scene that is ready to be hosted.

#include <memory>
#include <vector>

#include "server/calibration/choose_rung.h"
#include "server/physics/simulation.h"

namespace prosector {

struct ReadyScene {
  std::vector<Choice> choices;  // of bodies whose model differs from the scene's text
  std::unique_ptr<Simulation> simulation;
};

}  // namespace prosector
