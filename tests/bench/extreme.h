#pragma once
// What no rung may explode at: steps, stiffnesses, meshes, starts, forces and inputs that scenes and users
// can come up with, and worse.

#include <vector>

#include "server/calibration/specimen.h"

namespace prosector {

/// A piece starts as `start` puts it, bears `load` for a while, and is then left alone: no gravity, no force.
/// When it is `must_recover` it has to be back in its rest shape by then.
struct Extreme {
  const char* name;
  TestPiece (*piece)();
  double dt = 1. / 60;                                                // s
  void (*start)(const TestPiece& piece, VecX& x, VecX& v) = nullptr;  // null: at rest in its rest shape
  Vec3 load = {0, 0, 0};                                              // m/s²
  double load_s = 0;                                                  // s
  double release_s = 5;                                               // s
  bool must_recover = true;
  bool cheap = false;      // done in a blink: also looked at by the test
  bool for_direct = true;  // false: a sparse factorisation would take minutes
};
const std::vector<Extreme>& extremes();

}  // namespace prosector
