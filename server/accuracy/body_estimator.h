#pragma once
// Estimator of the error of a body's present state, from its own stresses: cheap enough to run again and
// again while users touch the body. It does not change the body.
//
// Discretisation. The body's stress is tested with the hierarchical functions that its elements lack first
// (bubbles.h). The residual r_k of function k and the function's own stiffness K_k give the energy that it
// would add:
//   η² = Σ_k r_k·K_k⁻¹·r_k
// K_k is Hooke's stiffness, rotated with the tissue. Its volumetric part acts on an element's mean, as far as
// that of the elements does (mean_dilatation.h). The work of the loads, C = f·u, is below its true value by
// η² where there is no other error.
//
// Model. The difference between the work of the body's law and of tissue's law at the present strains
// (law_difference.h).
//
// Both are relative to 2W = Σ V·P:(F − R), which equals C where strains are small. With these relative errors
// d and m, the true value is C·(1 + d + m). A force at a given depth is too large by d + m. The displacement
// under a load is too small by (d + m)/(1 + d + m).
//
// Time. The strain energy of the position error of the last tick's step, over that of the body, as its square
// root.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/error_estimate.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

namespace estimation {
struct ErrorWork;
}

/// State of a soft body at one time, from which its errors are estimated. It has the nodes' positions,
/// accelerations and time step error, the solver's error, and the work of pressing forces.
struct BodyMoment {
  VecX x;             // 3n, m
  VecX acceleration;  // 3n, m/s²: gravity's less the nodes' own, over the users' factor on stiffness
  VecX slip;          // 3n, m: position error of the nodes from the length of the last step
  double solver = 0;  // position error of the nodes from the last solve, over their displacement
  double give = 0;    // J: work of the pressing forces over their depth in the body: the contact's own dent
};

struct Estimate {
  double error = 0;           // relative error of the displacements under the loads
  ErrorParts parts;           // `error` is |discretisation + model| + solver + time
  double press = 0;           // relative error of the force felt by loads added since keep_as_quiet()
  double pressed = 0;         // work of these loads over that of all loads
  std::vector<double> local;  // by vertex: the mean over the volume is `error`
};

class BodyEstimator {
 public:
  /// Returns whether the errors of bodies with that description and mesh can be estimated. That requires
  /// tetrahedra and a constitutive law.
  static bool judges(const SoftDesc& desc, const TetMesh& mesh);

  /// Prepares the estimator for a body with the rest shape `mesh` (world frame; for quadratic elements with
  /// the edge midpoints among its nodes). `ties` is the stiffness (n, N/m) of the attachments at each node.
  /// `tissue` names the constitutive law that real tissue is assumed to follow.
  BodyEstimator(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue);
  ~BodyEstimator();
  BodyEstimator(BodyEstimator&&) noexcept;

  /// Returns the number of pieces of work into which an estimate is divided, each of about a microsecond.
  std::size_t pieces() const;
  /// Begins an estimate of the errors in the state `moment`, which is swapped with a member: afterwards
  /// `moment` contains an earlier state's buffers.
  void begin(BodyMoment& moment);
  /// Runs up to `pieces` pieces of work on the estimate that was begun. Returns whether the estimate is
  /// complete. Allocates no memory.
  bool go_on(std::size_t pieces);
  /// Returns the last estimate that was completed.
  const Estimate& newest() const;

  /// Stores the state of the newest estimate as the unpressed state. Loads added later count as a press,
  /// whose force's relative error is estimated separately.
  void keep_as_quiet();
  const TetMesh& mesh() const;

 private:
  std::unique_ptr<estimation::ErrorWork> work_;
};

}  // namespace prosector
