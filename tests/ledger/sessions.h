#pragma once
// Scripted sessions that together reach every kind of state that decides what comes next.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "server/physics/simulation.h"

namespace prosector::test {

/// What people do in one scene, tick by tick. `input` may look at the simulation, which is the same in each
/// run.
struct Session {
  std::string name;  // of the line in hashes.txt
  SceneDesc scene;
  int ticks = 120;
  std::function<TickInput(int tick, Simulation& simulation)> input;
  std::vector<std::string> reaches;  // of what `events` names: so that a script can't miss unnoticed
  int handed_over = 0;  // at this tick a checkpoint goes to a fresh simulation, which goes on; 0: never
};

std::vector<Session> sessions();

/// What happened in the step just taken: "cut", "piece", "undo", "rewind", "hold", "shared" (a hold by two),
/// "break", "panel", "obeyed" (a part), "reset", "substeps", "pressed" (two bodies, one of them soft),
/// "squeezed" (two soft bodies).
std::set<std::string> events(const Simulation& simulation, const StepReport& report);

}  // namespace prosector::test
