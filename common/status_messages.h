#pragma once
// Messages about the server's step and the estimated error of each deformable body.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/error_estimate.h"
#include "common/ids.h"

namespace prosector {

/// Message from the server to all clients at 10 Hz: the server's speed, load and numbers of participants.
struct ServerStatus {
  SimTime time;
  double real_time_factor = 0;
  double step_ms_p50 = 0, step_ms_p99 = 0;  // over the last second
  std::array<double, step_phases>
      phase_ms{};              // mean over the last second, in step order (server/physics/base/step_report.h)
  double solver_residual = 0;  // worst relative residual in the last second
  double energy = 0;           // J: kinetic + elastic + gravitational
  std::uint32_t participants = 0, observers = 0;  // dissectors and the host; observers
  std::uint32_t awake_bodies = 0, asleep_bodies = 0;
  std::uint64_t invalid_dropped = 0;  // samples refused by the wire checks since the start
  std::uint64_t state_hash = 0;       // of `time`
  std::string degraded;               // names of bodies that were reset, not converged or slowed; empty: none
  double error = -1;                  // largest current error estimate of all deformables; < 0: unknown
};

/// Message from the server to all clients: solver statistics and error estimates of one soft body, for its
/// current state. Keyed by body; sent at about 2 Hz while the body is awake. `residual` is measured in the
/// solves of the last second (docs/understand/soft-tissue.md).
struct BodyStatus {
  BodyId body = 0;
  SimTime time;
  bool asleep = false;
  bool converged = true;         // in all ticks since the last status
  std::uint32_t substeps = 0;    // explicit, position-based: substeps of the last tick; 0: one solve a tick
  double step = 0;               // s: length of its time steps
  double newton_iterations = 0;  // mean over the ticks since the last status
  double solver_iterations = 0;  // of the linear solver: mean over the ticks since the last status
  double residual = 0;           // worst: unbalanced force after a linear solve, over that before it
  double correction = 0;         // m, worst: displacement of a node by the last Newton step
  double error = -1;             // of the displacements under its loads, fraction; < 0: unknown
  double expected_ms = -1;  // CPU ms per frame predicted when the configuration was chosen; < 0: not chosen
  std::uint32_t stepped_down = 0;  // number of steps by which solver effort is reduced because of overload
  std::vector<Price> prices{};     // available configurations, the cheapest first; empty: not requested
  ErrorParts parts = {};           // components of `error`
  double press_error = -1;         // of the contact force where the body is pressed, fraction; < 0: unknown
  ErrorMap error_map = {};
};

}  // namespace prosector
