#pragma once
// Strain energy of all elements of a body and its derivatives, batch by batch. A law can implement whole
// batches (corotational_batches.cpp); other laws are evaluated element by element (law_batches.cpp).

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "server/physics/mechanics/soft/elements/corotated_elements.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/simd/element_lanes.h"

namespace prosector {

/// Batch k has the elements from k·elements_per_batch on. Different batches may be processed concurrently.
class ElementBatches {
 public:
  ElementBatches(const Materials& materials, const Tet4Elements& elements);
  virtual ~ElementBatches() = default;

  /// Returns whether follow() can apply an edit.
  virtual bool can_follow() const { return true; }
  /// Updates the batches after the elements followed `edit`. The elements are the tetrahedra, or equally many
  /// integration points of each.
  virtual void follow(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit);

  std::size_t kind_of(std::size_t e) const { return materials_.kind_of(e); }
  /// Returns whether the elastic forces rotate with the body (objectivity).
  virtual bool objective() const { return true; }
  /// Moves a batch to node positions x (3n), and computes the data that all functions below share.
  virtual void move(std::size_t batch, const double* x) = 0;
  /// Returns the energy of the batch, J.
  virtual double energy(std::size_t batch) const = 0;
  /// Computes V·P·b_a, N, one entry per element of the batch.
  virtual void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const = 0;
  /// Computes θ of each element of the batch, see mean_dilatation.h.
  virtual void dilatations(std::size_t batch, std::span<double> theta) const = 0;
  /// Computes V·∂θ/∂x_a, m², one entry per element of the batch.
  virtual void dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const = 0;
  /// Computes V·∂θ/∂x_a at F = R.
  virtual void warped_dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const = 0;
  /// Sets pressures p, Pa: forces and stiffness use W + p·θ instead of W. Zero until set.
  virtual void set_pressures(std::size_t batch, std::span<const double> pressure);
  /// Computes the projected tangent, N/m, one entry per element of the batch.
  virtual void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const = 0;
  /// Computes the warped stiffness: the linear elastic stiffness, rotated with each element. It is positive
  /// semidefinite and has the magnitude of the rest stiffness for any shape.
  virtual void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const = 0;
  /// Returns whether turn() is implemented.
  virtual bool turns() const { return false; }
  /// Computes the batch's rotated elements: 4 gradients and a twist each, see ElasticModel::linearise.
  virtual void turn(std::size_t /*batch*/, double /*share*/, std::span<CorotatedVector> /*gradients*/,
                    std::span<Twist> /*twists*/) const {}

  /// Returns the trace of the warped stiffness of all batches at rest, N/m.
  double rest_trace() const;

 protected:
  std::size_t first(std::size_t batch) const { return batch * elements_per_batch; }
  std::size_t count(std::size_t batch) const;
  /// Computes F of the batch at x, into `strain`.
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

/// Creates batches that are evaluated element by element, with a law for each material. `elements` must
/// outlive the result.
std::unique_ptr<ElementBatches> make_law_batches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
                                                 const Materials& materials, const Tet4Elements& elements);

/// Row of the table of laws that implement whole batches.
struct BatchedLawRow {
  const char* law;  // name in laws()
  std::unique_ptr<ElementBatches> (*make)(const Materials&, const Tet4Elements&);
};
const std::vector<BatchedLawRow>& batched_laws();

/// Creates the batches of the law called `name`, with the material of each element: from its row in
/// batched_laws(), else from the law itself. Throws InputError that lists the known laws. `elements` must
/// outlive the result.
std::unique_ptr<ElementBatches> make_batches(const std::string& name, const Materials& materials,
                                             const Tet4Elements& elements);
/// Creates vectorised batches of the law of make_fem_corotational.
std::unique_ptr<ElementBatches> make_corotational_batches(const Materials& materials,
                                                          const Tet4Elements& elements);

}  // namespace prosector
