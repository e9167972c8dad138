#include "server/physics/mechanics/soft/springs/spring_model.h"

#include <algorithm>
#include <optional>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"
#include "server/physics/mechanics/soft/base/scratch.h"
#include "server/physics/mechanics/soft/springs/sheet_springs.h"
#include "server/physics/mechanics/soft/springs/tet_springs.h"

namespace prosector::soft {
namespace {

constexpr std::size_t spring_elements_per_chunk = 512;

/// Returns the bend with its nodes in ascending order.
Bend sorted(const Bend& bend) {
  Bend out = bend;
  for (std::size_t i = 1; i < out.count; ++i)
    for (std::size_t k = i; k > 0 && out.node[k] < out.node[k - 1]; --k) {
      std::swap(out.node[k], out.node[k - 1]);
      std::swap(out.weight[k], out.weight[k - 1]);
    }
  return out;
}

Eigen::Map<const Vec3> at(const double* x, std::uint32_t node) {
  return Eigen::Map<const Vec3>(x + 3 * std::size_t{node});
}

class SpringModel final : public ElasticModel {
 public:
  explicit SpringModel(SpringNetwork network) : network_(std::move(network)), connectivity_(0) { fit(); }

  const VecX& rest() const override { return network_.rest; }
  const VecX& volume() const override { return network_.volume; }
  const Connectivity& connectivity() const override { return connectivity_; }
  std::size_t dropped_elements() const override { return network_.dropped; }

  const SpringNetwork* springs() const override { return &network_; }
  bool can_follow(const MeshEdit&) const override { return network_.dropped == 0; }
  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) override {
    follow_tet_springs(material, mesh, edit, network_);
    fit();
  }
  bool can_follow_sheet() const override { return network_.dropped == 0; }
  std::vector<std::uint32_t> follow_sheet(const SoftMaterial& material, const Anatomy& sheet,
                                          const Kept& nodes,
                                          std::span<const std::uint32_t> touched) override {
    std::vector<std::uint32_t> met = soft::follow_sheet(material, sheet, nodes, touched, network_);
    fit();
    return met;
  }

  double energy(const double* x) override {
    parallel_chunks(connectivity_.size(), spring_elements_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t chunk) {
                      double sum = 0;
                      for (std::size_t e = first; e < last; ++e) sum += energy_of(e, x);
                      sums_[chunk] = sum;
                    });
    return ordered_sum(sums_);
  }

  void add_gradient(const double* x, double* g) override {
    parallel_chunks(connectivity_.size(), spring_elements_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t) {
                      for (std::size_t e = first; e < last; ++e) force_of(e, x);
                    });
    incidence_->add(forces_, g);
  }

  std::span<const Mat3> tangent(const double* x) override { return stiffness(x, true); }
  std::span<const Mat3> warped_stiffness(const double* x) override { return stiffness(x, false); }
  double rest_trace() override {
    double sum = 0;
    for (const Spring& s : network_.springs) sum += 2 * s.stiffness;
    for (const Bend& b : network_.bends)
      for (std::size_t i = 0; i < b.count; ++i) sum += 3 * b.stiffness * b.weight[i] * b.weight[i];
    return sum;
  }

 private:
  /// Updates the model for the present network.
  void fit() {
    connectivity_.clear(static_cast<std::size_t>(network_.volume.size()));
    connectivity_.append(network_.springs.size(), 2,
                         [&](std::size_t e) { return network_.springs[e].nodes(); });
    bends_.clear();
    bends_.reserve(network_.bends.size());
    for (const Bend& b : network_.bends) {
      bends_.push_back(sorted(b));
      connectivity_.add(bends_.back().nodes());
    }
    incidence_.emplace(connectivity_);
    sums_.resize(chunk_count(connectivity_.size(), spring_elements_per_chunk));
    fit_scratch(forces_, connectivity_.corners());
    fit_scratch(blocks_, connectivity_.blocks());
  }

  bool is_spring(std::size_t e) const { return e < network_.springs.size(); }
  const Bend& bend(std::size_t e) const { return bends_[e - network_.springs.size()]; }

  static Vec3 curvature(const Bend& b, const double* x) {
    Vec3 sum =
        b.weight[0] * at(x, b.node[0]) + b.weight[1] * at(x, b.node[1]) + b.weight[2] * at(x, b.node[2]);
    if (b.count > 3) sum += b.weight[3] * at(x, b.node[3]);
    return sum;
  }

  double energy_of(std::size_t e, const double* x) const {
    if (!is_spring(e)) return bend(e).stiffness / 2 * curvature(bend(e), x).squaredNorm();
    const Spring& s = network_.springs[e];
    const double stretch = (at(x, s.node[1]) - at(x, s.node[0])).norm() - s.rest;
    return s.stiffness / 2 * stretch * stretch;
  }

  void force_of(std::size_t e, const double* x) {
    Vec3* f = &forces_[connectivity_.first_corner(e)];
    if (!is_spring(e)) {
      const Bend& b = bend(e);
      const Vec3 k = b.stiffness * curvature(b, x);
      for (std::size_t a = 0; a < b.count; ++a) f[a] = b.weight[a] * k;
      return;
    }
    const Spring& s = network_.springs[e];
    const Vec3 d = at(x, s.node[1]) - at(x, s.node[0]);
    const double length = d.norm();
    f[1] = length > 0 ? Vec3(s.stiffness * (1 - s.rest / length) * d) : Vec3(Vec3::Zero());
    f[0] = -f[1];
  }

  /// Returns the off-diagonal blocks: minus the spring's 3×3 matrix k·nnᵀ + max(0, k(1 − l₀/l))(I − nnᵀ).
  /// Without the second part, the stress stiffness, the matrix is the warped stiffness: linear, rotated with
  /// the spring.
  std::span<const Mat3> stiffness(const double* x, bool stress_part) {
    parallel_chunks(connectivity_.size(), spring_elements_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t) {
                      for (std::size_t e = first; e < last; ++e) stiffness_of(e, x, stress_part);
                    });
    return blocks_;
  }

  void stiffness_of(std::size_t e, const double* x, bool stress_part) {
    Mat3* K = &blocks_[connectivity_.first_block(e)];
    if (!is_spring(e)) {
      const Bend& b = bend(e);
      for (std::size_t i = 0; i < b.count; ++i)
        for (std::size_t j = i + 1; j < b.count; ++j)
          K[Connectivity::pair_index(i, j, b.count)] =
              b.stiffness * b.weight[i] * b.weight[j] * Mat3::Identity();
      return;
    }
    const Spring& s = network_.springs[e];
    const Vec3 d = at(x, s.node[1]) - at(x, s.node[0]);
    const double length = d.norm();
    const Vec3 n = length > 0 ? Vec3(d / length) : Vec3(Vec3::UnitX());
    const Mat3 nn = n * n.transpose();
    *K = -s.stiffness * nn;
    if (stress_part && length > s.rest) *K -= s.stiffness * (1 - s.rest / length) * (Mat3::Identity() - nn);
  }

  SpringNetwork network_;
  std::vector<Bend> bends_;
  Connectivity connectivity_;
  std::optional<Incidence> incidence_;
  std::vector<double> sums_;
  std::vector<Vec3> forces_;  // by corner
  std::vector<Mat3> blocks_;
};

class SumModel final : public ElasticModel {
 public:
  SumModel(std::unique_ptr<ElasticModel> a, std::unique_ptr<ElasticModel> b)
      : a_(std::move(a)), b_(std::move(b)), connectivity_(0) {
    fit();
  }

  const VecX& rest() const override { return a_->rest(); }
  const VecX& volume() const override { return a_->volume(); }
  const Connectivity& connectivity() const override { return connectivity_; }
  std::size_t dropped_elements() const override { return a_->dropped_elements() + b_->dropped_elements(); }
  double energy(const double* x) override { return a_->energy(x) + b_->energy(x); }
  void add_gradient(const double* x, double* g) override {
    a_->add_gradient(x, g);
    b_->add_gradient(x, g);
  }
  std::span<const Mat3> tangent(const double* x) override { return joined(a_->tangent(x), b_->tangent(x)); }
  std::span<const Mat3> warped_stiffness(const double* x) override {
    return joined(a_->warped_stiffness(x), b_->warped_stiffness(x));
  }
  double rest_trace() override { return a_->rest_trace() + b_->rest_trace(); }

  bool can_follow(const MeshEdit& edit) const override {
    return a_->can_follow(edit) && b_->can_follow(edit);
  }
  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) override {
    parallel_both([&] { a_->follow(material, mesh, edit); }, [&] { b_->follow(material, mesh, edit); });
    fit();
  }

 private:
  /// Updates the model for the present parts.
  void fit() {
    connectivity_.clear(a_->connectivity().nodes());
    for (const ElasticModel* part : {a_.get(), b_.get()}) connectivity_.append(part->connectivity());
    fit_scratch(blocks_, connectivity_.blocks());
  }

  std::span<const Mat3> joined(std::span<const Mat3> a, std::span<const Mat3> b) {
    std::copy(b.begin(), b.end(), std::copy(a.begin(), a.end(), blocks_.begin()));
    return blocks_;
  }

  std::unique_ptr<ElasticModel> a_, b_;
  Connectivity connectivity_;
  std::vector<Mat3> blocks_;
};

}  // namespace

std::unique_ptr<ElasticModel> make_spring_model(SpringNetwork network) {
  return std::make_unique<SpringModel>(std::move(network));
}

std::unique_ptr<ElasticModel> make_sum_model(std::unique_ptr<ElasticModel> a,
                                             std::unique_ptr<ElasticModel> b) {
  return std::make_unique<SumModel>(std::move(a), std::move(b));
}

}  // namespace prosector::soft
