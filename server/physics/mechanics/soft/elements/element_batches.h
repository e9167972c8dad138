#pragma once
// Strain energy of all elements of a body and its derivatives, batch by batch. A law can implement whole
// batches (corotational_batches.cpp, isotropic_batches.cpp); other laws are evaluated element by element
// (law_batches.cpp).

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "server/physics/mechanics/soft/elements/corotated_elements.h"
#include "server/physics/mechanics/soft/elements/point_tangents.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/simd/element_lanes.h"

namespace prosector::soft {

/// Strain energy of a body's elements and its derivatives, evaluated in batches of elements_per_batch (64)
/// elements. Batch k has the elements from k·elements_per_batch on. Different batches may be processed
/// concurrently.
class ElementBatches {
 public:
  ElementBatches(const Materials& materials, const Tet4Elements& elements);
  virtual ~ElementBatches() = default;

  /// Returns whether follow() can update the batches after an edit of the mesh; if not, they must be rebuilt.
  virtual bool can_follow() const { return true; }
  /// Updates the batches after `edit` changed the mesh to `mesh`, and after the elements were updated. The
  /// elements are the tetrahedra, or an equal number of integration points of each tetrahedron.
  virtual void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit);

  std::size_t kind_of(std::size_t e) const { return materials_.kind_of(e); }
  /// Returns whether the material law is objective: rotating the body does not change its energy.
  virtual bool objective() const { return true; }
  /// Computes the deformation gradients of a batch of elements at node positions x (3n, m), and other data
  /// that the functions below share.
  virtual void move(std::size_t batch, const double* x) = 0;
  /// Returns the strain energy, J, of all elements of the batch at the positions of its last move().
  virtual double energy(std::size_t batch) const = 0;
  /// Computes the gradient of each element's energy with respect to its four node positions, V·P·b_a, N. V is
  /// the volume, P the first Piola stress, and b_a the gradient of shape function a. `f` has one entry per
  /// element of the batch.
  virtual void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const = 0;
  /// Computes the measure of volume change θ(F) of the material law (mean_dilatation.h) for each element of
  /// the batch.
  virtual void dilatations(std::size_t batch, std::span<double> theta) const = 0;
  /// Computes V·∂θ/∂x_a, m², for the four nodes a of each element of the batch: volume times the derivative
  /// of the law's measure of volume change θ.
  virtual void dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const = 0;
  /// Computes V·∂θ/∂x_a, m², for the four nodes a of each element of the batch, as dilatation_forces() does,
  /// but with the element's rotation R instead of its deformation gradient. For the warped stiffness.
  virtual void warped_dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const = 0;
  /// Sets an external pressure p (Pa) for each element of the batch. Forces and stiffness then use the energy
  /// density W + p·θ instead of W, where θ is the law's measure of volume change. Initially zero.
  virtual void set_pressures(std::size_t batch, std::span<const double> pressure);
  /// Computes the tangent stiffness blocks (N/m) of each element of the batch, projected to have no negative
  /// eigenvalue. `K` has one entry per element.
  virtual void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const = 0;
  /// Computes the warped stiffness (N/m) of each element of the batch: the linear elastic stiffness, rotated
  /// with the element. It is positive semidefinite and has the magnitude of the rest stiffness for any shape.
  virtual void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const = 0;
  /// Returns whether turn() is implemented: whether the law can compute each element's gradients in its
  /// rotated frame (corotated_elements.h), which with its twist determine the whole tangent.
  virtual bool turns() const { return false; }
  /// Computes the batch as rotated elements (data from which the corotational tangent is assembled): four
  /// gradients and one twist per element. `share` is defined at ElasticModel::linearise().
  virtual void turn(std::size_t /*batch*/, double /*share*/, std::span<CorotatedVector> /*gradients*/,
                    std::span<Twist> /*twists*/) const {}
  /// Returns whether point_tangents() is implemented, from which stiffness blocks in single precision are
  /// computed.
  virtual bool has_point_tangents() const { return false; }
  /// Computes the tangents at the points of the batch, at the positions of its last move(). `share` is
  /// defined at ElasticModel::linearise().
  virtual void point_tangents(std::size_t /*batch*/, double /*share*/, PointTangents& /*out*/) const {}
  /// Returns whether the law has fibres.
  virtual bool has_fibers() const { return false; }

  /// Returns the trace, N/m, of the warped stiffness (the linear elastic stiffness) of all elements of the
  /// body at rest.
  double rest_trace() const;

 protected:
  std::size_t first(std::size_t batch) const { return batch * elements_per_batch; }
  std::size_t count(std::size_t batch) const;
  /// Computes the deformation gradients F of the batch at node positions x (3n, m), and stores them in
  /// `strain_`.
  void deform(std::size_t batch, const double* x);

  Materials materials_;
  const Tet4Elements& elements_;
  std::vector<LaneRest> rest_;
  std::vector<LaneStrain> strain_;

 private:
  void set_rest(std::size_t batch);
  void set_trace(std::size_t batch);

  std::vector<double> trace_;  // N/m: by batch, trace of the warped stiffness at rest
};

/// Creates batches whose elements are evaluated one by one, with one law for each material, created by
/// `make`. `elements` must outlive the result.
std::unique_ptr<ElementBatches> make_law_batches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
                                                 const Materials& materials, const Tet4Elements& elements);

/// Row of the table of material laws that are implemented for whole batches of elements with SIMD: the law's
/// name and the factory of its batches.
struct BatchedLawRow {
  const char* law;  // name in laws()
  std::unique_ptr<ElementBatches> (*make)(const Materials&, const Tet4Elements&);
};
const std::vector<BatchedLawRow>& batched_laws();

/// Creates the element batches of the material law called `name`: a vectorised implementation if
/// batched_laws() has one, otherwise one that evaluates element by element. `materials`: the material of each
/// element. Throws InputError that lists the known laws. `elements` must outlive the result.
std::unique_ptr<ElementBatches> make_batches(const std::string& name, const Materials& materials,
                                             const Tet4Elements& elements);
/// Creates SIMD-vectorised element batches of the corotational law, the same law as that of
/// make_fem_corotational. `elements` must outlive the result.
std::unique_ptr<ElementBatches> make_corotational_batches(const Materials& materials,
                                                          const Tet4Elements& elements);

}  // namespace prosector::soft
