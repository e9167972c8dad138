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

/// A measurement: a rung at a resolution.
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
  /// Runs the trial on one thread, whatever the caller's arena. Throws InputError when the rung can't model
  /// the beam.
  RungFigures measure(const RungTrial& trial);

 private:
  /// The converged solution of a model on a mesh.
  struct Exact {
    double settled_sag;
    std::vector<VecX> path;  // displacements frame by frame, 3n each
  };
  std::map<std::tuple<std::string, std::string, double, unsigned>, Exact> exact_;

  const Exact& exact(const RungTrial& trial);
};

}  // namespace prosector
