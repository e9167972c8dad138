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

namespace prosector::soft {

struct SpringNetwork;

/// Elastic energy W of a soft body as a function of node positions x (3n, m, world frame), with its gradient
/// and Hessian. Results at x are cached for the next call at the same x, so calls are not thread-safe. Calls
/// run in parallel internally, with bitwise equal results for any number of threads, and allocate no memory.
class ElasticModel {
 public:
  virtual ~ElasticModel() = default;

  virtual const VecX& rest() const = 0;    // 3n, m: rest positions, at which W = 0
  virtual const VecX& volume() const = 0;  // n, m³: lumped volume; times the density, the nodal mass
  /// Returns the integrals of the nodes' shape functions over the body, n, m³. Their sum is the body's
  /// volume, but those of vertices of quadratic elements are negative. For linear elements it equals
  /// volume().
  virtual const VecX& shape_volume() const { return volume(); }
  virtual const Connectivity& connectivity() const = 0;
  virtual std::size_t dropped_elements() const = 0;  // degenerate elements, left out of the connectivity

  /// Returns whether the model is objective: rotating the body does not change its energy. False for linear
  /// elasticity.
  virtual bool objective() const { return true; }

  /// Returns the elastic energy W, J, at node positions x (3n, m, world frame).
  virtual double energy(const double* x) = 0;
  /// Adds the gradient ∂W/∂x of the elastic energy at node positions x (3n, m) to g (3n, N).
  virtual void add_gradient(const double* x, double* g) = 0;
  /// Returns the Hessian of the elastic energy at node positions x (3n, m), element by element, N/m. Each
  /// element's matrix is projected to have no negative eigenvalue. There is one block ∂²W/∂x_a∂x_b per pair
  /// of corners, in the connectivity's order. A rigid translation causes no strain, so rows sum to zero and
  /// diagonal blocks are not stored. Valid until the next call.
  virtual std::span<const Mat3> tangent(const double* x) = 0;
  /// Returns the warped stiffness, N/m: the linear elastic stiffness, rotated with each element at node
  /// positions x (3n, m). It has one block per pair of corners of each element, like tangent(). It is
  /// positive semidefinite and has the magnitude of the rest stiffness for any shape.
  virtual std::span<const Mat3> warped_stiffness(const double* x) = 0;

  /// Returns the trace, N/m, of the linear elastic stiffness matrix of the whole body at rest, as a measure
  /// of the body's stiffness.
  virtual double rest_trace();

  /// Returns whether linearise() is implemented, which computes each element's gradients in its rotated
  /// frame. From them, tangent and warped stiffness are assembled at a fraction of the usual cost.
  virtual bool turns() const { return false; }
  /// Computes the rotated elements (data from which the corotational tangent is assembled) at node positions
  /// x (3n, m) into `out`. `share` = 1/(s + 1), where s is the factor of the warped stiffness that damping
  /// adds to the tangent. With `share` = 1, the data that only damping needs may be left out. The same pass
  /// computes the data that energy and gradient at x need. Allocates memory at the first call for `out`.
  virtual void linearise(const double* /*x*/, double /*share*/, CorotatedElements& /*out*/) {}

  // ---- Updates after a cut or an undone cut
  /// Returns whether follow() can apply the mesh edit; if not, the model must be rebuilt. It can if no
  /// tetrahedron or spring was left out as degenerate, and no element becomes flat by the edit.
  virtual bool can_follow(const MeshEdit& /*edit*/) const { return false; }
  /// Updates the model after `edit` changed the body's mesh to `mesh`. The result is bitwise equal to a newly
  /// built model.
  virtual void follow(const SoftMaterial& /*material*/, const TetMesh& /*mesh*/, const MeshEdit& /*edit*/) {}
  /// Returns whether the model is that of a sheet and follow_sheet() can update it after a cut; if not, it
  /// must be rebuilt.
  virtual bool can_follow_sheet() const { return false; }
  /// Updates the model of a sheet to its geometry `sheet` after a cut or an undo. The result is bitwise equal
  /// to a newly built model. `nodes`: the nodes that remain, with their new indices. `touched`: indices after
  /// the change of the corners of cells and triangles that were added or removed. Returns the nodes,
  /// ascending, of elements that may have been added, removed or changed; the other elements keep their
  /// order.
  virtual std::vector<std::uint32_t> follow_sheet(const SoftMaterial& /*material*/, const Anatomy& /*sheet*/,
                                                  const Kept& /*nodes*/,
                                                  std::span<const std::uint32_t> /*touched*/) {
    return {};
  }

  /// Returns the springs and bending elements of which the model consists, as those of a rope, a sheet or a
  /// solid without volume springs. Null for models with finite elements.
  virtual const SpringNetwork* springs() const { return nullptr; }

  // ---- Viscoelastic relaxation, see relaxation.h; no effect on bodies without relaxation.
  /// Returns the number of values of viscoelastic stress history that a state of the body has; 0 without
  /// stress relaxation.
  virtual std::size_t history_size() const { return 0; }
  /// Begins a step of h s from node positions x (3n, m) for a body with stress relaxation. From now on
  /// energy, gradient and tangent are those that the step must minimise. `history`: the stress history at its
  /// start.
  virtual void begin_step(double /*h*/, const double* /*x*/, const double* /*history*/) {}
  /// Updates `history`, the viscoelastic stress history, after a step that ended at node positions x (3n, m).
  virtual void end_step(const double* /*x*/, double* /*history*/) {}
  /// Sets viscoelastic stress relaxation to complete: energy, gradient and tangent become those of a body
  /// held for an infinite time.
  virtual void relax_fully() {}
};

}  // namespace prosector::soft
