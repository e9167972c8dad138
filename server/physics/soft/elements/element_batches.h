#pragma once
// The strain energy of all elements of a body and its derivatives, batch by batch. It is the seam at which a
// law may take over whole batches (corotational_batches.cpp); other laws go element by element
// (law_batches.cpp).

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "server/physics/soft/elements/tet4.h"
#include "server/physics/soft/elements/turned_elements.h"
#include "server/physics/soft/laws/constitutive_law.h"
#include "server/physics/soft/simd/element_lanes.h"

namespace prosector {

/// Batch k has the elements from k·elements_per_batch on. Different batches may be worked on at once.
class ElementBatches {
 public:
  ElementBatches(const Materials& materials, const Tet4Elements& elements);
  virtual ~ElementBatches() = default;

  /// Tells whether follow() will do.
  virtual bool can_follow() const { return true; }
  /// Follows the elements, which have followed `edit`: the tetrahedra, or as many points of each.
  virtual void follow(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit);

  std::size_t kind_of(std::size_t e) const { return materials_.kind_of(e); }
  /// Tells whether turning the whole body turns its forces along.
  virtual bool objective() const { return true; }
  /// Puts a batch at node positions x (3n): what all below share is computed once.
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
  /// Pressures p, Pa, as which forces and stiffness take W + p·θ for W; none until set.
  virtual void set_pressures(std::size_t batch, std::span<const double> pressure);
  /// Computes the projected tangent, N/m, one entry per element of the batch.
  virtual void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const = 0;
  /// Computes Hooke's stiffness turned with each element: positive semidefinite and of the size it has at
  /// rest, whatever the shape.
  virtual void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const = 0;
  /// Tells whether turn() is there.
  virtual bool turns() const { return false; }
  /// Computes the batch's turned elements: 4 gradients and a twist each, see ElasticModel::linearise.
  virtual void turn(std::size_t /*batch*/, double /*share*/, std::span<TurnedVector> /*gradients*/,
                    std::span<Twist> /*twists*/) const {}

  /// Returns the trace of the warped stiffness at rest, N/m, of all batches.
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

  std::vector<double> trace_;  // N/m: of the warped stiffness at rest, of each batch
};

/// Makes batches that go element by element, with a law for each material; `elements` must outlive the
/// result.
std::unique_ptr<ElementBatches> make_law_batches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
                                                 const Materials& materials, const Tet4Elements& elements);

/// One row of the table of laws that take over whole batches.
struct BatchedLawRow {
  const char* law;  // of laws()
  std::unique_ptr<ElementBatches> (*make)(const Materials&, const Tet4Elements&);
};
const std::vector<BatchedLawRow>& batched_laws();

/// Makes the batches of the law called `name`, with the material of each element: by its row in
/// batched_laws(), else from the law itself. Throws InputError that lists the laws there are. `elements` must
/// outlive the result.
std::unique_ptr<ElementBatches> make_batches(const std::string& name, const Materials& materials,
                                             const Tet4Elements& elements);
/// Makes what make_fem_corotational's law gives, vectorised.
std::unique_ptr<ElementBatches> make_corotational_batches(const Materials& materials,
                                                          const Tet4Elements& elements);

}  // namespace prosector
