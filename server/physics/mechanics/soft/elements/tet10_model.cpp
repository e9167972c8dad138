#include "server/physics/mechanics/soft/elements/tet10_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "server/physics/mechanics/soft/base/scratch.h"
#include "server/physics/mechanics/soft/elements/batched_model.h"
#include "server/physics/mechanics/soft/elements/element_blocks.h"
#include "server/physics/mechanics/soft/elements/tet10.h"
#include "server/physics/mechanics/soft/laws/mean_dilatation.h"

namespace prosector::soft {
namespace {

constexpr std::size_t per_element = Tet10Elements::points_per_element;
constexpr std::size_t batch_elements_per_chunk = elements_per_batch / per_element;
constexpr std::size_t nodes = Tet10Elements::nodes_per_element;
constexpr std::size_t pairs = Connectivity::pair_count(nodes);

Connectivity connect(std::size_t node_count, const Tet10Elements& elements) {
  Connectivity out(node_count);
  out.append(elements.size(), nodes, [&](std::size_t e) { return std::span(elements.nodes(e)); });
  return out;
}

/// Members that must be constructed before BatchedModel.
struct Tet10Parts {
  explicit Tet10Parts(const TetMesh& mesh) : elements(mesh), points(elements.points()) {}
  Tet10Elements elements;
  Tet4Elements points;
};

class Tet10Model final : private Tet10Parts, public BatchedModel {
 public:
  Tet10Model(const std::string& law, const SplitMaterials& materials,
             const std::vector<RelaxationDesc>& relaxation, const TetMesh& mesh)
      : Tet10Parts(mesh),
        BatchedModel(
            mesh, connect(mesh.positions.size(), elements),
            make_relaxing_batches(law, materials.local.at(elements.point_source()), relaxation, points),
            batch_elements_per_chunk),
        mean_(materials.mean) {
    for (const Material& kind : materials.local.kinds) mu_.push_back(kind.lame.mu);
    make_room();
    for (std::size_t e = 0; e < mean_modulus_.size(); ++e)
      set_mean(e, materials.local.kind_of(elements.source(e)));
  }

  const VecX& volume() const override { return elements.lumped_volume(); }
  const VecX& shape_volume() const override { return elements.shape_volume(); }
  std::size_t dropped_elements() const override { return elements.dropped(); }
  bool can_follow(const MeshEdit& edit) const override {
    return batches().can_follow() && elements.can_follow(rest(), edit);
  }
  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) override {
    elements.follow(mesh, edit);
    points.follow_parted(elements.corners(), edit);
    follow_elements(material, mesh, edit);
    elements.follow_volume(mesh, edit, connectivity(), incidence());
    if (!mean_.empty()) {
      edit.kept_tets.carry(mean_modulus_);
      edit.kept_tets.carry(mean_share_);
      for (const std::uint32_t e : edit.tets) set_mean(e, batches().kind_of(per_element * e));
    }
    make_room();
  }
  double rest_trace() override {
    return Tet10Elements::squares_of_points / per_element * batches().rest_trace() + mean_trace();
  }

 private:
  /// Allocates memory that each step needs.
  void make_room() {
    fit_scratch(corners_, 12 * points.size());
    fit_scratch(point_forces_, points.size());
    fit_scratch(forces_, nodes * elements.size());
    if (!turns()) reserve_stiffness();
    if (mean_.empty()) return;
    mean_modulus_.resize(elements.size());
    mean_share_.resize(elements.size());
    mean_dilatation_.resize(elements.size());
  }
  void set_mean(std::size_t e, std::size_t kind) {
    mean_modulus_[e] = mean_[kind];
    mean_share_[e] = std::sqrt(mean_[kind] / (4 * mu_[kind]));
  }

  /// Returns the trace of λ''/V·G·Gᵀ at rest, of all elements.
  double mean_trace() const {
    double sum = 0;
    for (std::size_t e = 0; e < mean_modulus_.size(); ++e) {
      const Mat3& b = points.gradients(per_element * e);
      const double squares = b.squaredNorm() + b.rowwise().sum().squaredNorm();
      sum += mean_modulus_[e] * volume_of(e) * squares;
    }
    return Tet10Elements::squares_of_sums / (per_element * per_element) * sum;
  }
  /// Returns the element's volume; all its points have equal shares.
  double volume_of(std::size_t e) const { return per_element * points.volume(per_element * e); }

  void place(const ElementChunk& chunk, const double* x) override {
    for (std::size_t e = chunk.first; e < chunk.last; ++e)
      elements.move(e, x, &corners_[12 * per_element * e]);
    batches().move(chunk.batch, corners_.data());
    if (!mean_modulus_.empty()) average(chunk);
  }
  double energy_of(const ElementChunk& chunk) const override {
    double sum = batches().energy(chunk.batch);
    if (!mean_modulus_.empty()) {
      for (std::size_t e = chunk.first; e < chunk.last; ++e)
        sum += 0.5 * instant_share() * mean_modulus_[e] * volume_of(e) * mean_dilatation_[e] *
               mean_dilatation_[e];
    }
    return sum;
  }
  void find_forces(const ElementChunk& chunk) override {
    batches().forces(chunk.batch,
                     std::span(point_forces_).subspan(per_element * chunk.first, per_element * chunk.size()));
    for (std::size_t e = chunk.first; e < chunk.last; ++e)
      Tet10Elements::gather(&point_forces_[per_element * e], &forces_[nodes * e]);
  }
  std::span<const Vec3> forces() const override { return forces_; }

  void reserve_stiffness() override {
    fit_scratch(point_stiffness_, points.size());
    fit_scratch(stiffness_, pairs * elements.size());
  }
  void find_stiffness(const ElementChunk& chunk, bool warped) override {
    const auto K = std::span(point_stiffness_).subspan(per_element * chunk.first, per_element * chunk.size());
    if (warped)
      batches().warped_stiffness(chunk.batch, K);
    else
      batches().stiffness(chunk.batch, K);
    for (std::size_t e = chunk.first; e < chunk.last; ++e)
      Tet10Elements::gather(&point_stiffness_[per_element * e], &stiffness_[pairs * e]);
    if (!mean_modulus_.empty()) add_mean(chunk, warped);
  }
  std::span<const Mat3> stiffness() const override { return stiffness_; }

  /// Adds the coupling by the mean dilatation; the warped stiffness is that without relaxation.
  void add_mean(const ElementChunk& chunk, bool warped) {
    std::array<Tet4Elements::Forces, elements_per_batch> of_points;
    const std::span G(of_points.data(), per_element * chunk.size());
    if (warped)
      batches().warped_dilatation_forces(chunk.batch, G);
    else
      batches().dilatation_forces(chunk.batch, G);
    const double share = warped ? 1 : instant_share();
    for (std::size_t e = chunk.first; e < chunk.last; ++e)
      add_mean(share * mean_modulus_[e] / volume_of(e), &G[per_element * (e - chunk.first)],
               &stiffness_[pairs * e]);
  }
  /// Adds K += scale·G·Gᵀ, G gathered from the points.
  static void add_mean(double scale, const Tet4Elements::Forces* points, Mat3* K) {
    std::array<Vec3, nodes> G;
    Tet10Elements::gather(points, G.data());
    for (std::size_t a = 0; a < nodes; ++a)
      for (std::size_t b = a + 1; b < nodes; ++b) *K++ += scale * G[a] * G[b].transpose();
  }

  /// Computes to = share·(the sum of the points' gradients).
  static void average(double share, const CorotatedVector* points, CorotatedVector* to) {
    for (std::size_t n = 0; n < nodes; ++n)
      for (std::size_t k = 0; k < 4; ++k) {
        float sum = 0;
        for (std::size_t p = 0; p < per_element; ++p) sum += points[nodes * p + n].at[k];
        to[n].at[k] = static_cast<float>(share) * sum;
      }
  }

  /// Sets the pressures caused by the elements' mean dilatation.
  void average(const ElementChunk& chunk) {
    std::array<double, elements_per_batch> values;  // θ, then p
    const std::span<double> of_points(values.data(), per_element * chunk.size());
    batches().dilatations(chunk.batch, of_points);
    for (std::size_t e = chunk.first; e < chunk.last; ++e) {
      const std::span<double> own = of_points.subspan(per_element * (e - chunk.first), per_element);
      mean_dilatation_[e] = (own[0] + own[1] + own[2] + own[3]) / per_element;
      std::fill(own.begin(), own.end(), mean_modulus_[e] * mean_dilatation_[e]);
    }
    batches().set_pressures(chunk.batch, of_points);
  }

  void reserve(CorotatedElements& out) const override {
    fit_scratch(out.gradient, nodes * points.size());
    fit_scratch(out.twist, points.size());
    if (!mean_share_.empty()) fit_scratch(out.mean, nodes * elements.size());
    if (batches().has_fibers()) fit_scratch(out.fiber, points.size());
    if (batches().has_point_tangents()) fit_scratch(out.blocks, floats_per_tet10 * elements.size() + 3);
  }
  void turn(const ElementChunk& chunk, double share, CorotatedElements& out) const override {
    std::array<CorotatedVector, 4 * elements_per_batch> corner{};
    const std::size_t begin = per_element * chunk.first, count = per_element * chunk.size();
    const std::span gradients = std::span(corner.data(), 4 * count);
    const std::span twists = std::span(out.twist).subspan(begin, count);
    if (batches().has_point_tangents()) {
      PointTangents tangents;
      batches().point_tangents(chunk.batch, share, tangents);
      find_blocks(chunk, share, tangents, out);
      if (share == 1) return;  // no damping
      turned_points(tangents, gradients, twists);
      if (tangents.has_fibers) turned_fibers(tangents, std::span(out.fiber).subspan(begin, count));
    } else {
      batches().turn(chunk.batch, share, gradients, twists);
    }
    for (std::size_t e = chunk.first; e < chunk.last; ++e) {
      CorotatedVector* own = &out.gradient[per_element * nodes * e];
      Tet10Elements::spread(&corner[4 * per_element * (e - chunk.first)], own);
      if (!mean_share_.empty()) average(mean_share_[e], own, &out.mean[nodes * e]);
    }
  }
  void find_blocks(const ElementChunk& chunk, double share, const PointTangents& tangents,
                   CorotatedElements& out) const {
    const std::span<const double> mean = mean_share_.empty()
                                             ? std::span<const double>()
                                             : std::span(mean_share_).subspan(chunk.first, chunk.size());
    lane_tet10_blocks(
        tangents, mean, share,
        std::span(out.blocks).subspan(floats_per_tet10 * chunk.first, floats_per_tet10 * chunk.size()));
  }

  std::vector<double> mean_, mu_;  // by material: λ'', Pa, empty if no material has one; μ, Pa
  std::vector<double> mean_modulus_, mean_dilatation_;  // by element: λ'' (Pa) and θ̄; empty: none
  std::vector<double> mean_share_;                      // √(λ''/4μ), see corotated_elements.h
  std::vector<double> corners_;                         // 12 per point: its D_c
  std::vector<Tet4Elements::Forces> point_forces_;
  std::vector<Tet4Elements::Stiffness> point_stiffness_;
  std::vector<Vec3> forces_;
  std::vector<Mat3> stiffness_;
};

}  // namespace

std::unique_ptr<ElasticModel> make_tet10_model(const std::string& law, const Materials& materials,
                                               const std::vector<RelaxationDesc>& relaxation,
                                               const TetMesh& mesh) {
  return std::make_unique<Tet10Model>(law, split_volume(materials), relaxation, mesh);
}

}  // namespace prosector::soft
