#include "server/physics/soft/tet10_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "server/physics/parallel.h"
#include "server/physics/soft/element_batches.h"
#include "server/physics/soft/mean_dilatation.h"
#include "server/physics/soft/node_vectors.h"
#include "server/physics/soft/relaxation.h"
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
  Tet10Model(const std::string& law, const SplitMaterials& materials,
             const std::vector<RelaxationDesc>& relaxation, const TetMesh& mesh)
      : elements_(mesh),
        points_(elements_.points()),
        rest_(to_vector(mesh.positions)),
        connectivity_(connect(mesh.positions.size(), elements_)),
        incidence_(connectivity_),
        batches_(
            make_relaxing_batches(law, materials.local.at(elements_.point_source()), relaxation, points_)),
        relaxing_(dynamic_cast<RelaxingBatches*>(batches_.get())),
        corners_(12 * points_.size()),
        sums_(chunk_count(elements_.size(), elements_per_chunk)),
        point_forces_(points_.size()),
        point_stiffness_(points_.size()),
        forces_(nodes * elements_.size()),
        stiffness_(pairs * elements_.size()),
        moved_to_(VecX::Zero(rest_.size())) {
    if (materials.mean.empty()) return;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const std::size_t kind = materials.local.kind_of(elements_.point_source()[per_element * e]);
      mean_modulus_.push_back(materials.mean[kind]);
      mean_share_.push_back(std::sqrt(materials.mean[kind] / (4 * materials.local.kinds[kind].lame.mu)));
    }
    mean_dilatation_.resize(elements_.size());
  }

  const VecX& rest() const override { return rest_; }
  const VecX& volume() const override { return elements_.lumped_volume(); }
  const Connectivity& connectivity() const override { return connectivity_; }
  std::size_t dropped_elements() const override { return elements_.dropped(); }
  bool objective() const override { return batches_->objective(); }

  double energy(const double* x) override {
    move(x);
    if (!energy_known_) {
      for_chunks(
          [&](std::size_t chunk, std::size_t first, std::size_t last) { sum_energy(chunk, first, last); });
      energy_known_ = true;
    }
    return ordered_sum(sums_);
  }

  void add_gradient(const double* x, double* g) override {
    move(x);
    if (!forces_known_) {
      for_chunks(
          [&](std::size_t chunk, std::size_t first, std::size_t last) { find_forces(chunk, first, last); });
      forces_known_ = true;
    }
    incidence_.add(forces_, g);
  }

  std::span<const Mat3> tangent(const double* x) override {
    return stiffness(
        x, [this](std::size_t chunk, auto K) { batches_->stiffness(chunk, K); }, instant_share(),
        [this](std::size_t chunk, auto G) { batches_->dilatation_forces(chunk, G); });
  }
  std::span<const Mat3> warped_stiffness(const double* x) override {
    return stiffness(
        x, [this](std::size_t chunk, auto K) { batches_->warped_stiffness(chunk, K); }, 1,
        [this](std::size_t chunk, auto G) { batches_->warped_dilatation_forces(chunk, G); });
  }

  bool turns() const override { return batches_->turns(); }
  void linearise(const double* x, double share, TurnedElements& out) override {
    reserve(out);
    const bool there = take(x);
    for_chunks([&](std::size_t chunk, std::size_t first, std::size_t last) {
      if (!there) move(chunk, first, last, x);
      if (!energy_known_) sum_energy(chunk, first, last);
      if (!forces_known_) find_forces(chunk, first, last);
      turn(chunk, first, last, share, out);
    });
    energy_known_ = forces_known_ = true;
  }

  std::size_t history_size() const override { return relaxing_ ? relaxing_->history_size() : 0; }
  void begin_step(double h, const double* x, const double* history) override {
    if (!relaxing_) return;
    move(x);
    relaxing_->set_step(h);
    for_chunks([&](std::size_t batch, std::size_t, std::size_t) { relaxing_->begin_step(batch, history); });
    energy_known_ = forces_known_ = false;
  }
  void end_step(const double* x, double* history) override {
    if (!relaxing_) return;
    move(x);
    for_chunks([&](std::size_t batch, std::size_t, std::size_t) { relaxing_->end_step(batch, history); });
  }
  void relax_fully() override {
    if (!relaxing_) return;
    relaxing_->relax_fully();
    energy_known_ = forces_known_ = false;
  }

 private:
  /// Calls f(chunk, first, last) for all chunks of elements; a chunk's points are a batch.
  template <class F>
  void for_chunks(const F& f) const {
    parallel_chunks(elements_.size(), elements_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t chunk) { f(chunk, first, last); });
  }

  /// What of the mean's part a step stores, as of the points'.
  double instant_share() const { return relaxing_ ? relaxing_->instant_share() : 1; }
  /// All of an element's points have the same share of its volume.
  double volume_of(std::size_t e) const { return per_element * points_.volume(per_element * e); }

  void sum_energy(std::size_t chunk, std::size_t first, std::size_t last) {
    double sum = batches_->energy(chunk);
    if (!mean_modulus_.empty()) {
      for (std::size_t e = first; e < last; ++e)
        sum += 0.5 * instant_share() * mean_modulus_[e] * volume_of(e) * mean_dilatation_[e] *
               mean_dilatation_[e];
    }
    sums_[chunk] = sum;
  }
  void find_forces(std::size_t chunk, std::size_t first, std::size_t last) {
    batches_->forces(chunk,
                     std::span(point_forces_).subspan(per_element * first, per_element * (last - first)));
    for (std::size_t e = first; e < last; ++e)
      Tet10Elements::gather(&point_forces_[per_element * e], &forces_[nodes * e]);
  }
  void reserve(TurnedElements& out) const {
    out.gradient.resize(nodes * points_.size());
    out.twist.resize(points_.size());
    if (!mean_share_.empty()) out.mean.resize(nodes * elements_.size());
  }
  void turn(std::size_t chunk, std::size_t first, std::size_t last, double share, TurnedElements& out) const {
    std::array<TurnedVector, 4 * elements_per_batch> corner{};
    const std::size_t begin = per_element * first, count = per_element * (last - first);
    batches_->turn(chunk, share, std::span(corner.data(), 4 * count),
                   std::span(out.twist).subspan(begin, count));
    for (std::size_t e = first; e < last; ++e) {
      TurnedVector* own = &out.gradient[per_element * nodes * e];
      Tet10Elements::spread(&corner[4 * per_element * (e - first)], own);
      if (!mean_share_.empty()) average(mean_share_[e], own, &out.mean[nodes * e]);
    }
  }

  /// of_points(chunk, K), and of what the mean dilatation couples, dilatation(chunk, G).
  template <class F, class Dilatation>
  std::span<const Mat3> stiffness(const double* x, const F& of_points, double share,
                                  const Dilatation& dilatation) {
    move(x);
    for_chunks([&](std::size_t chunk, std::size_t first, std::size_t last) {
      of_points(chunk,
                std::span(point_stiffness_).subspan(per_element * first, per_element * (last - first)));
      for (std::size_t e = first; e < last; ++e)
        Tet10Elements::gather(&point_stiffness_[per_element * e], &stiffness_[pairs * e]);
      if (mean_modulus_.empty()) return;
      std::array<Tet4Elements::Forces, elements_per_batch> G;
      dilatation(chunk, std::span(G.data(), per_element * (last - first)));
      for (std::size_t e = first; e < last; ++e)
        add_mean(share * mean_modulus_[e] / volume_of(e), &G[per_element * (e - first)],
                 &stiffness_[pairs * e]);
    });
    return stiffness_;
  }

  /// K += scale·G·Gᵀ, G gathered from the points.
  static void add_mean(double scale, const Tet4Elements::Forces* points, Mat3* K) {
    std::array<Vec3, nodes> G;
    Tet10Elements::gather(points, G.data());
    for (std::size_t a = 0; a < nodes; ++a)
      for (std::size_t b = a + 1; b < nodes; ++b) *K++ += scale * G[a] * G[b].transpose();
  }

  /// to = share·(the sum of the points' gradients).
  static void average(double share, const TurnedVector* points, TurnedVector* to) {
    for (std::size_t n = 0; n < nodes; ++n)
      for (std::size_t k = 0; k < 4; ++k) {
        float sum = 0;
        for (std::size_t p = 0; p < per_element; ++p) sum += points[nodes * p + n].at[k];
        to[n].at[k] = static_cast<float>(share) * sum;
      }
  }

  /// Sets the pressures that the elements' mean dilatation raises.
  void average(std::size_t chunk, std::size_t first, std::size_t last) {
    std::array<double, elements_per_batch> values;  // θ, then p
    const std::span<double> of_points(values.data(), per_element * (last - first));
    batches_->dilatations(chunk, of_points);
    for (std::size_t e = first; e < last; ++e) {
      const std::span<double> own = of_points.subspan(per_element * (e - first), per_element);
      mean_dilatation_[e] = (own[0] + own[1] + own[2] + own[3]) / per_element;
      std::fill(own.begin(), own.end(), mean_modulus_[e] * mean_dilatation_[e]);
    }
    batches_->set_pressures(chunk, of_points);
  }

  /// As Tet4Model's, these two.
  bool take(const double* x) {
    const auto bytes = static_cast<std::size_t>(moved_to_.size()) * sizeof(double);
    if (moved_ && std::memcmp(x, moved_to_.data(), bytes) == 0) return true;
    std::memcpy(moved_to_.data(), x, bytes);
    moved_ = true;
    energy_known_ = forces_known_ = false;
    return false;
  }
  void move(const double* x) {
    if (take(x)) return;
    for_chunks([&](std::size_t chunk, std::size_t first, std::size_t last) {
      move(chunk, first, last, x);
      sum_energy(chunk, first, last);
    });
    energy_known_ = true;
  }
  void move(std::size_t chunk, std::size_t first, std::size_t last, const double* x) {
    for (std::size_t e = first; e < last; ++e) elements_.move(e, x, &corners_[12 * per_element * e]);
    batches_->move(chunk, corners_.data());
    if (!mean_modulus_.empty()) average(chunk, first, last);
  }

  Tet10Elements elements_;
  Tet4Elements points_;
  VecX rest_;
  Connectivity connectivity_;
  Incidence incidence_;
  std::unique_ptr<ElementBatches> batches_;
  RelaxingBatches* relaxing_ = nullptr;                 // batches_ where stress relaxes
  std::vector<double> mean_modulus_, mean_dilatation_;  // λ'' (Pa) and θ̄ of each element; empty: none
  std::vector<double> mean_share_;                      // √(λ''/4μ), see turned_elements.h
  std::vector<double> corners_;                         // 12 a point: its D_c
  std::vector<double> sums_;                            // J, one a chunk
  std::vector<Tet4Elements::Forces> point_forces_;
  std::vector<Tet4Elements::Stiffness> point_stiffness_;
  std::vector<Vec3> forces_;
  std::vector<Mat3> stiffness_;
  VecX moved_to_;  // 3n: where `batches_` are
  bool moved_ = false, energy_known_ = false, forces_known_ = false;
};

}  // namespace

std::unique_ptr<ElasticModel> make_tet10_model(const std::string& law, const Materials& materials,
                                               const std::vector<RelaxationDesc>& relaxation,
                                               const TetMesh& mesh) {
  return std::make_unique<Tet10Model>(law, split_volume(materials), relaxation, mesh);
}

}  // namespace prosector
