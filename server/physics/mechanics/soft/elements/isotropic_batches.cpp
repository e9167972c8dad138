#include "server/physics/mechanics/soft/elements/isotropic_batches.h"

#include <vector>

#include "server/physics/mechanics/soft/elements/fiber_kernel.h"

namespace prosector::soft {
namespace {

class IsotropicBatches final : public LawBatches {
 public:
  IsotropicBatches(IsotropicLaw law, bool fibers, std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
                   const Materials& materials, const Tet4Elements& elements)
      : LawBatches(make, materials, elements), law_(law), has_fibers_(fibers) {
    set_fibers();
  }

  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) override {
    LawBatches::follow(material, mesh, edit);
    set_fibers();
  }
  double energy(std::size_t batch) const override {
    double each[elements_per_batch], sum = 0;
    lane_energy(law_, rest_[batch], strain_[batch], each);
    if (has_fibers()) lane_add_fiber_energy(fibers_[batch], rest_[batch], strain_[batch], each);
    for (std::size_t e = 0; e < count(batch); ++e) sum += each[e];
    return sum;
  }
  void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const override {
    lane_forces(law_, rest_[batch], strain_[batch], f);
    if (has_fibers()) lane_add_fiber_forces(fibers_[batch], rest_[batch], strain_[batch], f);
  }
  void dilatations(std::size_t batch, std::span<double> theta) const override {
    lane_dilatations(law_, strain_[batch], theta);
  }
  void dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override {
    lane_dilatation_forces(law_, rest_[batch], strain_[batch], G);
  }

  bool has_point_tangents() const override { return true; }
  void point_tangents(std::size_t batch, double share, PointTangents& out) const override {
    const LaneStrain strain = rotated(batch);
    lane_point_tangents(law_, rest_[batch], strain, share, out);
    if (has_fibers()) lane_fiber_tangents(fibers_[batch], rest_[batch], strain, share, out);
  }
  bool has_fibers() const override { return has_fibers_; }

 private:
  void set_fibers() {
    if (!has_fibers_) return;
    fibers_.assign(rest_.size(), LaneFibers{});
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      LaneFibers& fibers = fibers_[e / elements_per_batch];
      const std::size_t lane = e % elements_per_batch;
      for (int k = 0; k < 3; ++k) fibers.direction[k][lane] = materials_.of(e).fiber[k];
      fibers.stiffness[lane] = materials_.of(e).fiber_stiffness;
    }
  }

  IsotropicLaw law_;
  bool has_fibers_;
  std::vector<LaneFibers> fibers_;  // by batch; empty: the law has none
};

}  // namespace

std::unique_ptr<ElementBatches> make_isotropic_batches(
    IsotropicLaw law, bool fibers, std::unique_ptr<ConstitutiveLaw> (*make)(const Material&),
    const Materials& materials, const Tet4Elements& elements) {
  return std::make_unique<IsotropicBatches>(law, fibers, make, materials, elements);
}

}  // namespace prosector::soft
