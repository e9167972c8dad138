#include "server/physics/soft/tet10_model.h"

#include <cstring>

#include "server/physics/parallel.h"
#include "server/physics/soft/element_batches.h"
#include "server/physics/soft/node_vectors.h"
#include "server/physics/soft/tet10.h"

namespace prosector {
namespace {

constexpr std::size_t per_element = Tet10Elements::points_per_element;
constexpr std::size_t elements_per_chunk = elements_per_batch / per_element;
constexpr std::size_t nodes = Tet10Elements::nodes_per_element;
constexpr std::size_t pairs = Connectivity::pair_count(nodes);

Connectivity connect(std::size_t node_count, const Tet10Elements& elements) {
  Connectivity out(node_count);
  for (std::size_t e = 0; e < elements.size(); ++e) out.add(elements.nodes(e));
  return out;
}

class Tet10Model final : public ElasticModel {
 public:
  Tet10Model(const std::string& law, const Materials& materials, const TetMesh& mesh)
      : elements_(mesh),
        points_(elements_.points()),
        rest_(to_vector(mesh.positions)),
        connectivity_(connect(mesh.positions.size(), elements_)),
        incidence_(connectivity_),
        batches_(make_batches(law, materials.at(elements_.point_source()), points_)),
        corners_(12 * points_.size()),
        sums_(chunk_count(elements_.size(), elements_per_chunk)),
        point_forces_(points_.size()),
        point_stiffness_(points_.size()),
        forces_(nodes * elements_.size()),
        stiffness_(pairs * elements_.size()),
        moved_to_(VecX::Zero(rest_.size())) {}

  const VecX& rest() const override { return rest_; }
  const VecX& volume() const override { return elements_.lumped_volume(); }
  const Connectivity& connectivity() const override { return connectivity_; }
  std::size_t dropped_elements() const override { return elements_.dropped(); }
  bool objective() const override { return batches_->objective(); }

  double energy(const double* x) override {
    move(x);
    for_chunks([&](std::size_t chunk, std::size_t, std::size_t) { sums_[chunk] = batches_->energy(chunk); });
    return ordered_sum(sums_);
  }

  void add_gradient(const double* x, double* g) override {
    move(x);
    for_chunks([&](std::size_t chunk, std::size_t first, std::size_t last) {
      batches_->forces(chunk,
                       std::span(point_forces_).subspan(per_element * first, per_element * (last - first)));
      for (std::size_t e = first; e < last; ++e)
        Tet10Elements::gather(&point_forces_[per_element * e], &forces_[nodes * e]);
    });
    incidence_.add(forces_, g);
  }

  std::span<const Mat3> tangent(const double* x) override {
    return stiffness(x, [this](std::size_t chunk, auto K) { batches_->stiffness(chunk, K); });
  }
  std::span<const Mat3> warped_stiffness(const double* x) override {
    return stiffness(x, [this](std::size_t chunk, auto K) { batches_->warped_stiffness(chunk, K); });
  }

 private:
  /// Calls f(chunk, first, last) for all chunks of elements; a chunk's points are a batch.
  template <class F>
  void for_chunks(const F& f) const {
    parallel_chunks(elements_.size(), elements_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t chunk) { f(chunk, first, last); });
  }

  template <class F>
  std::span<const Mat3> stiffness(const double* x, const F& of_points) {
    move(x);
    for_chunks([&](std::size_t chunk, std::size_t first, std::size_t last) {
      of_points(chunk,
                std::span(point_stiffness_).subspan(per_element * first, per_element * (last - first)));
      for (std::size_t e = first; e < last; ++e)
        Tet10Elements::gather(&point_stiffness_[per_element * e], &stiffness_[pairs * e]);
    });
    return stiffness_;
  }

  /// As Tet4Model's.
  void move(const double* x) {
    const auto bytes = static_cast<std::size_t>(moved_to_.size()) * sizeof(double);
    if (moved_ && std::memcmp(x, moved_to_.data(), bytes) == 0) return;
    std::memcpy(moved_to_.data(), x, bytes);
    moved_ = true;
    for_chunks([&](std::size_t chunk, std::size_t first, std::size_t last) {
      for (std::size_t e = first; e < last; ++e) elements_.move(e, x, &corners_[12 * per_element * e]);
      batches_->move(chunk, corners_.data());
    });
  }

  Tet10Elements elements_;
  Tet4Elements points_;
  VecX rest_;
  Connectivity connectivity_;
  Incidence incidence_;
  std::unique_ptr<ElementBatches> batches_;
  std::vector<double> corners_;  // 12 a point: its D_c
  std::vector<double> sums_;     // J, one a chunk
  std::vector<Tet4Elements::Forces> point_forces_;
  std::vector<Tet4Elements::Stiffness> point_stiffness_;
  std::vector<Vec3> forces_;
  std::vector<Mat3> stiffness_;
  VecX moved_to_;  // 3n: where `batches_` are
  bool moved_ = false;
};

}  // namespace

std::unique_ptr<ElasticModel> make_tet10_model(const std::string& law, const Materials& materials,
                                               const TetMesh& mesh) {
  return std::make_unique<Tet10Model>(law, materials, mesh);
}

}  // namespace prosector
