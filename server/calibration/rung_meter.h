#pragma once
// Measures the cost and error of a rung by running it on the bending beam (beam_piece.h).
//
// There are three figures. The settled shape has the error of mesh and model, without the solver's. The drift
// is the error that is added on the way by solving with limited effort instead of to convergence. The third
// figure is the CPU time of a frame. The first two are the same on every machine.

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "server/calibration/rung.h"

namespace prosector {

inline constexpr double frame_seconds = 1. / 60;

/// Settings of one measurement on the bending beam: the rung (model configuration) that is measured, the
/// Poisson ratio, and the number of mesh cells along the beam.
struct RungTrial {
  Rung rung;
  double poisson_ratio = 0.45;  // one of bend_ratios
  unsigned cells = 8;           // along the beam, a multiple of 4
  bool operator==(const RungTrial&) const = default;
};

struct RungFigures {
  double elements = 0;     // tetrahedra, however the model uses them
  double settled_sag = 0;  // m: −u_y of the free face at rest
  double drift = 0;  // RMS deviation, over frames and nodes, from the converged path on the same mesh, over
                     // the RMS displacement. For position-based models it is 0: their effort shows in the
                     // settled shape. It is at least the share of frames that fell back on another rung
  double iterations = 0;  // of the linear solver, per frame, mean; 0: it has none
  double ms = 0;          // CPU time of a frame of 1/60 s on one thread, median
  double share = 1;       // CPU time over wall time: below 1, other programs used the processor
};

class RungMeter {
 public:
  /// Measures the cost and error of the trial's configuration on the bending beam. Runs on one thread,
  /// whatever task arena the caller is in. Throws InputError if the configuration can't model the beam.
  RungFigures measure(const RungTrial& trial);

 private:
  /// The converged solution of a model on a mesh of the beam: its deflection at rest and its motion.
  struct Exact {
    double settled_sag;
    std::vector<VecX> path;  // displacements frame by frame, 3n each
  };
  std::map<std::tuple<std::string, std::string, double, unsigned>, Exact> exact_;

  const Exact& exact(const RungTrial& trial);
};

}  // namespace prosector
