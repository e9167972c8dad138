#include "server/physics/mechanics/soft/elements/corotational_kernel.h"
#include "server/physics/mechanics/soft/elements/element_batches.h"

namespace prosector::soft {
namespace {

class CorotationalBatches final : public ElementBatches {
 public:
  using ElementBatches::ElementBatches;

  void move(std::size_t batch, const double* x) override {
    deform(batch, x);
    lane_rotations(strain_[batch]);
  }
  double energy(std::size_t batch) const override {
    double each[elements_per_batch], sum = 0;
    lane_corotational_energy(rest_[batch], strain_[batch], each);
    for (std::size_t e = 0; e < count(batch); ++e) sum += each[e];
    return sum;
  }
  void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const override {
    lane_corotational_forces(rest_[batch], strain_[batch], f);
  }
  void dilatations(std::size_t batch, std::span<double> theta) const override {
    lane_corotational_dilatations(strain_[batch], theta);
  }
  void dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override {
    lane_turned_gradients(rest_[batch], strain_[batch].R, G);
  }
  void warped_dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override {
    dilatation_forces(batch, G);
  }
  void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    lane_corotational_stiffness(rest_[batch], strain_[batch], K);
  }
  void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    lane_warped_stiffness(rest_[batch], strain_[batch].R, K);
  }
  bool turns() const override { return true; }
  void turn(std::size_t batch, double share, std::span<CorotatedVector> gradients,
            std::span<Twist> twists) const override {
    lane_turned_elements(rest_[batch], strain_[batch], share, gradients, twists);
  }
};

}  // namespace

std::unique_ptr<ElementBatches> make_corotational_batches(const Materials& materials,
                                                          const Tet4Elements& elements) {
  return std::make_unique<CorotationalBatches>(materials, elements);
}

}  // namespace prosector::soft
