#pragma once
// The measured table of rungs: what each costs and gets wrong at each resolution, and what follows for a body
// of another size.
//
// How a figure is carried over. A mesh's *fineness* is its body's thickness, four times volume over surface,
// in mean element sizes, (volume / elements)^(1/3). The error at a fineness is interpolated between the
// beam's in double logarithms. A mesh finer than measured counts as the finest measured, never as better; on
// a coarser one the error grows by the rate of the first two. No mesh counts as better than a finer one of
// the same rung: where a model and its locking cancel, that is chance.
//
// The cost at a number of elements is interpolated in double logarithms, too. Beyond what was measured it
// grows as elements^p with p the last two's, held within [1, 4/3]. 1 is work in proportion to the elements;
// 4/3 is that of conjugate gradients, whose iterations grow with the number of elements along a side.
//
// The beam is stiff (E = 3e5 Pa), moves, and touches nothing: softer tissue takes fewer iterations, contacts
// cost extra.

#include <optional>
#include <string>
#include <vector>

#include "server/calibration/rung_meter.h"

namespace prosector {

struct BodyGeometry {
  double elements = 0;
  double volume = 0;     // m³, of the elements
  double thickness = 0;  // m
  double fineness() const;
};
/// Measures a mesh of tetrahedra, whose surface may be open.
BodyGeometry geometry_of(const TetMesh& mesh);

/// What is expected of a body by a rung.
struct Prospect {
  double error = 0;  // of displacements, fraction: of the mesh and model, and of solving with that effort
  double drift = 0;  // what of the error the effort makes; of position-based models all
  double ms = 0;     // CPU time a frame of 1/60 s, one thread
};

class RungTable {
 public:
  void add(const RungTrial& trial, const RungFigures& figures) { rows_.push_back({trial, figures}); }
  const RungFigures* find(const RungTrial& trial) const;
  /// Returns what is expected of the body by the rung; nothing when the rung is not in the table at that
  /// ratio. `own_law`: true when errors count against the model's own continuum, where it has one; false:
  /// tissue's.
  std::optional<Prospect> prospect(const Rung& rung, double poisson_ratio, const BodyGeometry& body,
                                   bool own_law) const;
  /// Returns the fineness of the coarsest and finest mesh that the rung was measured on; 0, 0 when it was
  /// not.
  std::pair<double, double> measured_fineness(const Rung& rung, double poisson_ratio) const;

  struct Row {
    RungTrial trial;
    RungFigures figures;
  };
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;

  std::vector<const Row*> rows_of(const Rung& rung, double poisson_ratio) const;
};

/// Returns the table's ratio that stands for a body's: the next larger one; above all, the largest.
double table_ratio(double poisson_ratio);

/// Interpolates y at x between (xs, ys), x rising, all positive, in double logarithms. Beyond the ends it
/// goes on by the rate of the nearest two, held within [low, high]. `xs` must not be empty.
double log_interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x, double low,
                       double high);

}  // namespace prosector
