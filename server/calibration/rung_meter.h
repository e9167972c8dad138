#pragma once
// What a rung costs and gets wrong on the bending beam (beam_piece.h), by running it.
//
// It takes three figures. The settled shape is the mesh's and the model's error and no solver's. The drift is
// what solving with less effort than to the end adds on the way. The third is the CPU time of a frame. The
// first two are the same on every machine.

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "server/calibration/rung.h"

namespace prosector {

inline constexpr double frame_seconds = 1. / 60;

/// What is run: a rung at a resolution.
struct RungTrial {
  Rung rung;
  double poisson_ratio = 0.45;  // one of bend_ratios
  unsigned cells = 8;           // along the beam, a multiple of 4
  bool operator==(const RungTrial&) const = default;
};

struct RungFigures {
  double elements = 0;     // tetrahedra, whatever the model makes of them
  double settled_sag = 0;  // m: −u_y of the free face at rest
  double drift = 0;        // RMS over frames and nodes from the path of the same mesh solved to the end, over
                           // the RMS displacement (models that integrate by themselves: 0, their effort shows
                           // in the settled shape); at least the share of frames that fell back on another
                           // rung
  double iterations = 0;   // of the linear solver, a frame, mean; 0: it has none
  double ms = 0;           // CPU time of a frame of 1/60 s on one thread, median
  double share = 1;        // CPU time over time that passed meanwhile: below 1, other work had the processor
};

class RungMeter {
 public:
  /// Runs the trial on one thread, whatever the caller's arena. Throws InputError when the rung refuses the
  /// beam.
  RungFigures measure(const RungTrial& trial);

 private:
  /// The exact solution of a model on a mesh.
  struct Exact {
    double settled_sag;
    std::vector<VecX> path;  // displacements frame by frame, 3n each
  };
  std::map<std::tuple<std::string, std::string, double, unsigned>, Exact> exact_;

  const Exact& exact(const RungTrial& trial);
};

}  // namespace prosector
