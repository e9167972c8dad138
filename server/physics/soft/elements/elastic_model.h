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

/// Positions x are 3n, metres, room frame. What one of the calls below finds out about x is kept for the
/// next call at the same x, so they are not for several threads at once; inside they run in parallel, with
/// the same bits for any number of threads, and allocate nothing.
class ElasticModel {
 public:
  virtual ~ElasticModel() = default;

  virtual const VecX& rest() const = 0;    // 3n, m: where W = 0
  virtual const VecX& volume() const = 0;  // n, m³: lumped; times the density it is the nodes' mass
  virtual const Connectivity& connectivity() const = 0;
  virtual std::size_t dropped_elements() const = 0;  // degenerate ones, left out of the connectivity

  /// Whether turning the whole body turns its forces along.
  virtual bool objective() const { return true; }

  /// W(x), J.
  virtual double energy(const double* x) = 0;
  /// g += ∂W/∂x, N.
  virtual void add_gradient(const double* x, double* g) = 0;
  /// The Hessian, element by element, each projected so that it has no negative eigenvalue; N/m. One block
  /// ∂²W/∂x_a∂x_b per pair of corners, in the connectivity's order. Moving as a whole strains nothing, so
  /// rows sum to zero and the diagonal blocks need not be stored. Valid until the next call.
  virtual std::span<const Mat3> tangent(const double* x) = 0;
  /// Hooke's stiffness turned with each element, likewise: positive semidefinite and of the size it has at
  /// rest, whatever the shape.
  virtual std::span<const Mat3> warped_stiffness(const double* x) = 0;

  /// The trace of all of Hooke's stiffness at rest, N/m: how stiff the body is.
  virtual double rest_trace();

  /// Whether tangent and warped stiffness can be had as turned elements, at a fraction of the cost.
  virtual bool turns() const { return false; }
  /// As they are at x, their twists with `share` = 1/(s + 1); and what energy and gradient need at x, in the
  /// same pass over the elements. Allocates at the first call for `out`.
  virtual void linearise(const double* /*x*/, double /*share*/, TurnedElements& /*out*/) {}

  // ---- Following a cut, or what takes one back
  /// Whether follow() will do: elements are the tetrahedra of the mesh that was edited, all of them, and none
  /// becomes flat.
  virtual bool can_follow(const MeshEdit& /*edit*/) const { return false; }
  /// As if made anew of `mesh`, which was edited so, bit for bit.
  virtual void follow(const SoftDesc& /*desc*/, const TetMesh& /*mesh*/, const MeshEdit& /*edit*/) {}
  /// Likewise of a sheet.
  virtual bool can_follow_sheet() const { return false; }
  /// `nodes`: which stay; `touched`: the corners there now of cells and triangles that came or went. Returns
  /// the nodes, ascending, of elements that may have come, gone or changed; the others keep their order.
  virtual std::vector<std::uint32_t> follow_sheet(const SoftDesc& /*desc*/, const Anatomy& /*sheet*/,
                                                  const Kept& /*nodes*/,
                                                  std::span<const std::uint32_t> /*touched*/) {
    return {};
  }

  /// What a rope or a sheet consists of; null: it is something else.
  virtual const SpringNetwork* springs() const { return nullptr; }

  // ---- Viscoelastic relaxation, see relaxation.h; nothing to bodies without.
  /// Numbers of history that a state carries.
  virtual std::size_t history_size() const { return 0; }
  /// From here on energy, gradient and tangent are what a step of h s from x stores.
  virtual void begin_step(double /*h*/, const double* /*x*/, const double* /*history*/) {}
  /// Takes a step that ended at x into the history.
  virtual void end_step(const double* /*x*/, double* /*history*/) {}
  /// From here on they are those of a body that has been held for ever.
  virtual void relax_fully() {}
};

}  // namespace prosector
