#include "server/physics/soft/tet4_model.h"

#include <cstring>

#include "server/physics/parallel.h"
#include "server/physics/soft/element_batches.h"
#include "server/physics/soft/fem_laws.h"
#include "server/physics/soft/node_vectors.h"
#include "server/physics/soft/relaxation.h"
#include "server/physics/soft/tet4.h"

namespace prosector {
namespace {

using Forces = Tet4Elements::Forces;
using Stiffness = Tet4Elements::Stiffness;

Connectivity connect(const TetMesh& mesh, const Tet4Elements& elements) {
  Connectivity out(mesh.positions.size());
  for (std::size_t e = 0; e < elements.size(); ++e) out.add(elements.nodes(e));
  return out;
}

/// The arrays of a vector of std::array<T, n>, end to end.
template <class Array>
std::span<const typename Array::value_type> flat(const std::vector<Array>& arrays) {
  static_assert(sizeof(Array) == std::tuple_size_v<Array> * sizeof(typename Array::value_type));
  return {arrays.data()->data(), arrays.size() * std::tuple_size_v<Array>};
}

class Tet4Model final : public ElasticModel {
 public:
  /// make(elements): batches of them.
  template <class Make>
  Tet4Model(const TetMesh& mesh, const Make& make)
      : elements_(mesh),
        rest_(to_vector(mesh.positions)),
        volume_(Tet4Elements::lumped_volume(mesh)),
        connectivity_(connect(mesh, elements_)),
        incidence_(connectivity_),
        batches_(make(elements_)),
        sums_(chunk_count(elements_.size(), elements_per_batch)),
        forces_(elements_.size()),
        stiffness_(elements_.size()),
        moved_to_(VecX::Zero(rest_.size())) {
    relaxing_ = dynamic_cast<RelaxingBatches*>(batches_.get());
  }

  const VecX& rest() const override { return rest_; }
  const VecX& volume() const override { return volume_; }
  const Connectivity& connectivity() const override { return connectivity_; }
  std::size_t dropped_elements() const override { return elements_.dropped(); }

  bool objective() const override { return batches_->objective(); }

  double energy(const double* x) override {
    move(x);
    if (!energy_known_) {
      for_batches(
          [&](std::size_t batch, std::size_t, std::size_t) { sums_[batch] = batches_->energy(batch); });
      energy_known_ = true;
    }
    return ordered_sum(sums_);
  }

  void add_gradient(const double* x, double* g) override {
    move(x);
    if (!forces_known_) {
      for_batches([&](std::size_t batch, std::size_t first, std::size_t count) {
        batches_->forces(batch, std::span(forces_).subspan(first, count));
      });
      forces_known_ = true;
    }
    incidence_.add(flat(forces_), g);
  }

  std::span<const Mat3> tangent(const double* x) override {
    move(x);
    for_batches([&](std::size_t batch, std::size_t first, std::size_t count) {
      batches_->stiffness(batch, std::span(stiffness_).subspan(first, count));
    });
    return flat(stiffness_);
  }

  std::span<const Mat3> warped_stiffness(const double* x) override {
    move(x);
    for_batches([&](std::size_t batch, std::size_t first, std::size_t count) {
      batches_->warped_stiffness(batch, std::span(stiffness_).subspan(first, count));
    });
    return flat(stiffness_);
  }

  bool turns() const override { return batches_->turns(); }
  void linearise(const double* x, double share, TurnedElements& out) override {
    reserve(out);
    const bool there = take(x);
    for_batches([&](std::size_t batch, std::size_t first, std::size_t count) {
      if (!there) batches_->move(batch, x);
      if (!energy_known_) sums_[batch] = batches_->energy(batch);
      if (!forces_known_) batches_->forces(batch, std::span(forces_).subspan(first, count));
      turn(batch, first, count, share, out);
    });
    energy_known_ = forces_known_ = true;
  }

  std::size_t history_size() const override { return relaxing_ ? relaxing_->history_size() : 0; }
  void begin_step(double h, const double* x, const double* history) override {
    if (!relaxing_) return;
    move(x);
    relaxing_->set_step(h);
    for_batches([&](std::size_t batch, std::size_t, std::size_t) { relaxing_->begin_step(batch, history); });
    energy_known_ = forces_known_ = false;
  }
  void end_step(const double* x, double* history) override {
    if (!relaxing_) return;
    move(x);
    for_batches([&](std::size_t batch, std::size_t, std::size_t) { relaxing_->end_step(batch, history); });
  }
  void relax_fully() override {
    if (!relaxing_) return;
    relaxing_->relax_fully();
    energy_known_ = forces_known_ = false;
  }

 private:
  /// Calls f(batch, first, count) for all batches of elements.
  template <class F>
  void for_batches(const F& f) const {
    parallel_chunks(
        elements_.size(), elements_per_batch,
        [&](std::size_t first, std::size_t last, std::size_t batch) { f(batch, first, last - first); });
  }

  void reserve(TurnedElements& out) const {
    out.gradient.resize(4 * elements_.size());
    out.twist.resize(elements_.size());
  }
  void turn(std::size_t batch, std::size_t first, std::size_t count, double share,
            TurnedElements& out) const {
    batches_->turn(batch, share, std::span(out.gradient).subspan(4 * first, 4 * count),
                   std::span(out.twist).subspan(first, count));
  }

  /// Whether the elements are at x: Newton asks for energy, gradient and Hessian at the same place, and the
  /// next step starts where the last one ended. Otherwise the caller puts them there.
  bool take(const double* x) {
    const auto bytes = static_cast<std::size_t>(moved_to_.size()) * sizeof(double);
    if (moved_ && std::memcmp(x, moved_to_.data(), bytes) == 0) return true;
    std::memcpy(moved_to_.data(), x, bytes);
    moved_ = true;
    energy_known_ = forces_known_ = false;
    return false;
  }
  /// Finds the energy on the way, which nearly everyone wants.
  void move(const double* x) {
    if (take(x)) return;
    for_batches([&](std::size_t batch, std::size_t, std::size_t) {
      batches_->move(batch, x);
      sums_[batch] = batches_->energy(batch);
    });
    energy_known_ = true;
  }

  Tet4Elements elements_;
  VecX rest_, volume_;
  Connectivity connectivity_;
  Incidence incidence_;
  std::unique_ptr<ElementBatches> batches_;
  RelaxingBatches* relaxing_ = nullptr;  // batches_ where stress relaxes
  std::vector<double> sums_;             // J, one a batch
  std::vector<Forces> forces_;
  std::vector<Stiffness> stiffness_;
  VecX moved_to_;  // 3n: where `batches_` are
  bool moved_ = false, energy_known_ = false, forces_known_ = false;
};

}  // namespace

std::unique_ptr<ElasticModel> make_tet4_model(const std::string& law, const Materials& materials,
                                              const std::vector<RelaxationDesc>& relaxation,
                                              const TetMesh& mesh) {
  return std::make_unique<Tet4Model>(mesh, [&](const Tet4Elements& elements) {
    return make_relaxing_batches(law, materials.at(elements.source()), relaxation, elements);
  });
}

std::unique_ptr<ElasticModel> make_tet4_volume_model(const Materials& materials, const TetMesh& mesh) {
  return std::make_unique<Tet4Model>(mesh, [&](const Tet4Elements& elements) {
    return make_law_batches(make_volume_law, materials.at(elements.source()), elements);
  });
}

}  // namespace prosector
