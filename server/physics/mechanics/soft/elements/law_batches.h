#pragma once
// Element batches of any law, evaluated element by element in double precision.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/mechanics/soft/elements/element_batches.h"

namespace prosector::soft {

/// Element batches that call a ConstitutiveLaw for each element, with one law for each material.
class LawBatches : public ElementBatches {
 public:
  LawBatches(std::unique_ptr<ConstitutiveLaw> (*make)(const Material&), const Materials& materials,
             const Tet4Elements& elements);

  bool objective() const override { return laws_.front()->objective(); }
  void move(std::size_t batch, const double* x) override { deform(batch, x); }
  double energy(std::size_t batch) const override;
  void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const override;
  void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override;
  void dilatations(std::size_t batch, std::span<double> theta) const override;
  void dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override;
  void warped_dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override;
  void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override;

 protected:
  /// Returns the deformation of a batch with its rotations R; the identity for laws that are not objective.
  LaneStrain rotated(std::size_t batch) const;

 private:
  void add_fiber(std::size_t batch, const LaneMatrix& R, std::size_t lane, Tet4Elements::Stiffness& K) const;
  Mat3 gradient(std::size_t batch, std::size_t lane) const;
  template <class Call>
  void for_laws(std::size_t batch, const Call& f) const;

  std::vector<std::unique_ptr<ConstitutiveLaw>> laws_;  // by material
};

}  // namespace prosector::soft
