#pragma once
// Bouts of play: people act for a while and leave; then the organs are judged.

#include <functional>
#include <string>
#include <vector>

#include "tests/play/judge.h"
#include "tests/play/person.h"
#include "tests/save_check.h"

namespace prosector::test {

struct PlayOptions {
  unsigned seed = 1;
  int people = 2;
  int bouts = 1;
  double bout = 8;    // s that people play
  double rest = 5;    // s that the organs have then
  bool tell = false;  // how the organs are while they rest
  Bounds bounds;
  SaveCheck* saves =
      nullptr;  // checks the saved state after every tick; checkpoints as often as a server does
};

struct PlayFigures {
  double seconds = 0;                        // simulated
  int bouts = 0, bad = 0;                    // bad: out of bounds when the rest was over
  int acts = 0;                              // what people did
  int resets = 0;                            // bodies that were reset or unfolded
  int recoveries = 0;                        // ticks in which a body was stepped under the law that leads out
  double least_volume = 1, most_volume = 1;  // when a rest was over
  double overlap = 0;                        // m, likewise
  double recovery = 0;                       // s after the hands left until all was in bounds, the longest
  double step_ms = 0;                        // the slowest tick, CPU or wall as the step measures
  double rest_ms = 0;                        // mean step over the last half second of a rest, the slowest
  int bad_saves = 0;                         // ticks whose saved state could not be restored
  std::vector<std::string> found;            // a line for each bad bout, and for the first bad save of each
};

/// Plays in the simulation, bout after bout, in one state that goes on.
PlayFigures play(Simulation& simulation, const PlayOptions& options,
                 const std::function<void(const std::string&)>& say = {});

/// Sums, and the worst of both.
void add(PlayFigures& to, const PlayFigures& from);

}  // namespace prosector::test
