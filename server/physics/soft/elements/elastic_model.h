#pragma once
// What a body stores energy in: the strain energy W of its node positions and W's derivatives.
// IncrementalPotential adds inertia, damping and attachments; it knows of elements only what stands here.

#include <memory>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/soft/base/connectivity.h"
#include "server/physics/soft/elements/turned_elements.h"

namespace prosector {

struct SpringNetwork;

/// Positions x are 3n, m, world frame. What a call finds out about x is kept for the next call at the same x,
/// so calls are not for several threads at once. Inside they run in parallel, with the same bits for any
/// number of threads, and allocate nothing.
class ElasticModel {
 public:
  virtual ~ElasticModel() = default;

  virtual const VecX& rest() const = 0;    // 3n, m: where W = 0
  virtual const VecX& volume() const = 0;  // n, m³: lumped; times the density it is the nodes' mass
  /// Returns what the shape functions' integrals give nodes of the volume, n, m³: all of it together, but
  /// some less than none. Of linear elements it is volume().
  virtual const VecX& shape_volume() const { return volume(); }
  virtual const Connectivity& connectivity() const = 0;
  virtual std::size_t dropped_elements() const = 0;  // degenerate ones, left out of the connectivity

  /// Tells whether turning the whole body turns its forces along.
  virtual bool objective() const { return true; }

  /// Returns W(x), J.
  virtual double energy(const double* x) = 0;
  /// Adds ∂W/∂x to g, N.
  virtual void add_gradient(const double* x, double* g) = 0;
  /// Returns the Hessian, N/m, element by element, each projected so that it has no negative eigenvalue.
  /// There is one block ∂²W/∂x_a∂x_b per pair of corners, in the connectivity's order. Moving as a whole
  /// strains nothing, so rows sum to zero and diagonal blocks need not be stored. Valid until the next call.
  virtual std::span<const Mat3> tangent(const double* x) = 0;
  /// Returns Hooke's stiffness turned with each element, in the same layout. It is positive semidefinite and
  /// of the size it has at rest, whatever the shape.
  virtual std::span<const Mat3> warped_stiffness(const double* x) = 0;

  /// Returns the trace of all of Hooke's stiffness at rest, N/m: how stiff the body is.
  virtual double rest_trace();

  /// Tells whether tangent and warped stiffness can be had as turned elements, at a fraction of the cost.
  virtual bool turns() const { return false; }
  /// Finds the turned elements at x, their twists with `share` = 1/(s + 1). In the same pass it finds what
  /// energy and gradient need there. Allocates at the first call for `out`.
  virtual void linearise(const double* /*x*/, double /*share*/, TurnedElements& /*out*/) {}

  // ---- Following a cut, or what takes one back
  /// Tells whether follow() will do: elements are the tetrahedra of the mesh that was edited, all of them,
  /// and none becomes flat.
  virtual bool can_follow(const MeshEdit& /*edit*/) const { return false; }
  /// Makes the model as if made anew, bit for bit, of `mesh`, which was edited so.
  virtual void follow(const SoftDesc& /*desc*/, const TetMesh& /*mesh*/, const MeshEdit& /*edit*/) {}
  /// Tells whether follow_sheet() will do.
  virtual bool can_follow_sheet() const { return false; }
  /// Makes the model as if made anew, bit for bit, of a sheet. `nodes`: which stay; `touched`: the corners
  /// there now of cells and triangles that came or went. Returns the nodes, ascending, of elements that may
  /// have come, gone or changed; the others keep their order.
  virtual std::vector<std::uint32_t> follow_sheet(const SoftDesc& /*desc*/, const Anatomy& /*sheet*/,
                                                  const Kept& /*nodes*/,
                                                  std::span<const std::uint32_t> /*touched*/) {
    return {};
  }

  /// Returns what a rope or a sheet consists of; null: it is something else.
  virtual const SpringNetwork* springs() const { return nullptr; }

  // ---- Viscoelastic relaxation, see relaxation.h; nothing to bodies without.
  /// Returns how many numbers of history a state carries.
  virtual std::size_t history_size() const { return 0; }
  /// Makes energy, gradient and tangent what a step of h s from x stores, from here on.
  virtual void begin_step(double /*h*/, const double* /*x*/, const double* /*history*/) {}
  /// Takes a step that ended at x into the history.
  virtual void end_step(const double* /*x*/, double* /*history*/) {}
  /// Makes them those of a body that has been held for ever, from here on.
  virtual void relax_fully() {}
};

}  // namespace prosector
