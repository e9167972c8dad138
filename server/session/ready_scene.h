#pragma once
// A scene that can be hosted.

#include <memory>
#include <vector>

#include "server/calibration/choose_rung.h"
#include "server/physics/simulation.h"

namespace prosector {

struct ReadyScene {
  std::vector<Choice> choices;  // of bodies that are not modelled as the scene's text says
  std::unique_ptr<Simulation> simulation;
};

}  // namespace prosector
