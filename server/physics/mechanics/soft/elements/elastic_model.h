#pragma once
// Elastic model: the strain energy W of node positions, and its derivatives. IncrementalPotential adds
// inertia, damping and attachments, and uses elements only through this interface.

#include <memory>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/base/connectivity.h"
#include "server/physics/mechanics/soft/elements/corotated_elements.h"

namespace prosector {

struct SpringNetwork;

/// Strain energy of a body. Positions x are 3n, m, world frame. Results at x are cached for the next call at
/// the same x, so calls are not thread-safe. Calls run in parallel internally, with bitwise equal results for
/// any number of threads, and allocate no memory.
class ElasticModel {
 public:
  virtual ~ElasticModel() = default;

  virtual const VecX& rest() const = 0;    // 3n, m: rest positions, at which W = 0
  virtual const VecX& volume() const = 0;  // n, m³: lumped volume; times the density, the nodal mass
  /// Returns the nodal volume by the integrals of the shape functions, n, m³. The sum is the body's volume,
  /// but some entries are negative. For linear elements it equals volume().
  virtual const VecX& shape_volume() const { return volume(); }
  virtual const Connectivity& connectivity() const = 0;
  virtual std::size_t dropped_elements() const = 0;  // degenerate elements, left out of the connectivity

  /// Returns whether the elastic forces rotate with the body (objectivity).
  virtual bool objective() const { return true; }

  /// Returns W(x), J.
  virtual double energy(const double* x) = 0;
  /// Adds ∂W/∂x to g, N.
  virtual void add_gradient(const double* x, double* g) = 0;
  /// Returns the Hessian, N/m, element by element, each projected to have no negative eigenvalue. There is
  /// one block ∂²W/∂x_a∂x_b per pair of corners, in the connectivity's order. A rigid translation causes no
  /// strain, so rows sum to zero and diagonal blocks are not stored. Valid until the next call.
  virtual std::span<const Mat3> tangent(const double* x) = 0;
  /// Returns the warped stiffness in the same layout: the linear elastic stiffness, rotated with each
  /// element. It is positive semidefinite and has the magnitude of the rest stiffness for any shape.
  virtual std::span<const Mat3> warped_stiffness(const double* x) = 0;

  /// Returns the trace of the linear elastic stiffness of the whole body at rest, N/m, as a measure of its
  /// stiffness.
  virtual double rest_trace();

  /// Returns whether tangent and warped stiffness are also available as rotated elements, at a fraction of
  /// the cost.
  virtual bool turns() const { return false; }
  /// Computes the rotated elements at x, with twists for `share` = 1/(s + 1). The same pass computes the data
  /// that energy and gradient need at x. Allocates memory at the first call for `out`.
  virtual void linearise(const double* /*x*/, double /*share*/, CorotatedElements& /*out*/) {}

  // ---- Updates after a cut or an undone cut
  /// Returns whether follow() can apply the edit: the elements are all tetrahedra of the edited mesh, and
  /// none becomes flat.
  virtual bool can_follow(const MeshEdit& /*edit*/) const { return false; }
  /// Updates the model to the edited `mesh`. Bitwise equal to a rebuild.
  virtual void follow(const SoftDesc& /*desc*/, const TetMesh& /*mesh*/, const MeshEdit& /*edit*/) {}
  /// Returns whether follow_sheet() can apply an edit.
  virtual bool can_follow_sheet() const { return false; }
  /// Updates the model of a sheet after an edit. Bitwise equal to a rebuild. `nodes`: the nodes that are
  /// kept. `touched`: the present corners of cells and triangles that were added or removed. Returns the
  /// nodes, ascending, of elements that may have been added, removed or changed; the other elements keep
  /// their order.
  virtual std::vector<std::uint32_t> follow_sheet(const SoftDesc& /*desc*/, const Anatomy& /*sheet*/,
                                                  const Kept& /*nodes*/,
                                                  std::span<const std::uint32_t> /*touched*/) {
    return {};
  }

  /// Returns the springs of a rope or a sheet; null for other bodies.
  virtual const SpringNetwork* springs() const { return nullptr; }

  // ---- Viscoelastic relaxation, see relaxation.h; no effect on bodies without relaxation.
  /// Returns the number of values of stress history in a state.
  virtual std::size_t history_size() const { return 0; }
  /// Begins a step of h s from x: from now on, energy, gradient and tangent are those of the step.
  virtual void begin_step(double /*h*/, const double* /*x*/, const double* /*history*/) {}
  /// Updates the history after a step that ended at x.
  virtual void end_step(const double* /*x*/, double* /*history*/) {}
  /// Switches energy, gradient and tangent to those of a body held for an infinite time.
  virtual void relax_fully() {}
};

}  // namespace prosector
