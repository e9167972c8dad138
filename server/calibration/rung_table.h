#pragma once
// The measured table of rungs: the cost and error of each at each resolution, and the prediction for a body
// of another size.
//
// Errors. A mesh's *fineness* is its body's thickness, four times volume over surface, in mean element sizes,
// (volume / elements)^(1/3). The error at a fineness is interpolated between the beam's meshes in double
// logarithms. A mesh finer than measured counts as the finest measured, never as better. On a coarser mesh
// the error grows by the rate of the first two. No mesh counts as better than a finer one of the same rung:
// where the errors of a model and of its locking cancel, that is chance.
//
// Costs. The cost at a number of elements is interpolated in double logarithms, too. Beyond the measured
// range it grows as elements^p, with p of the nearest two, limited to [1, 4/3]. The exponent 1 is work in
// proportion to the elements. The exponent 4/3 is that of conjugate gradients, whose iterations grow with the
// number of elements along a side.
//
// The beam is stiff (E = 3e5 Pa), moves, and touches nothing: softer tissue takes fewer iterations, and
// contacts cost extra.

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
/// Measures a tetrahedral mesh: its number of elements, volume and thickness. The anatomy's surface mesh,
/// which may be open, is not used.
BodyGeometry geometry_of(const TetMesh& mesh);

/// Expected error and cost of a body that is simulated with a certain rung (model configuration).
struct Prospect {
  double error = 0;  // relative error of displacements: of the mesh and model, and of the limited effort
  double drift = 0;  // the share of `error` that the effort causes; all of it for position-based models
  double ms = 0;     // CPU time per frame of 1/60 s, one thread
};

class RungTable {
 public:
  void add(const RungTrial& trial, const RungFigures& figures) { rows_.push_back({trial, figures}); }
  const RungFigures* find(const RungTrial& trial) const;
  /// Returns the expected error and cost of the body with the rung (model configuration). Returns nothing if
  /// the table has no row for the rung at that Poisson ratio. With `own_law`, errors are relative to the
  /// model's own continuum, if it has one. Otherwise they are relative to tissue's.
  std::optional<Prospect> prospect(const Rung& rung, double poisson_ratio, const BodyGeometry& body,
                                   bool own_law) const;
  /// Returns the fineness (body thickness in mean element sizes) of the coarsest and of the finest beam mesh
  /// on which the rung was measured. Returns 0, 0 if it was not measured.
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

/// Returns the Poisson ratio for which the table is read for a body with `poisson_ratio`: the next larger
/// measured one, or the largest.
double table_ratio(double poisson_ratio);

/// Returns y at x, interpolated in double logarithms between the points (xs, ys), with xs ascending and all
/// values positive. Beyond the ends it extrapolates with the exponent of the nearest two points, limited to
/// [low, high]. With one point the exponent is `low`. `xs` must not be empty.
double log_interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x, double low,
                       double high);

}  // namespace prosector
