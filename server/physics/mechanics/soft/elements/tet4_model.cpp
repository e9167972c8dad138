#include "server/physics/mechanics/soft/elements/tet4_model.h"

#include "server/physics/mechanics/soft/base/scratch.h"
#include "server/physics/mechanics/soft/elements/batched_model.h"
#include "server/physics/mechanics/soft/elements/element_blocks.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/laws/fem_laws.h"

namespace prosector::soft {
namespace {

using Forces = Tet4Elements::Forces;
using Stiffness = Tet4Elements::Stiffness;

Connectivity connect(const TetMesh& mesh, const Tet4Elements& elements) {
  Connectivity out(mesh.positions.size());
  out.append(elements.size(), Tet4Elements::nodes_per_element,
             [&](std::size_t e) { return std::span(elements.nodes(e)); });
  return out;
}

/// Returns the concatenated arrays of a vector of std::array<T, n>.
template <class Array>
std::span<const typename Array::value_type> flat(const std::vector<Array>& arrays) {
  static_assert(sizeof(Array) == std::tuple_size_v<Array> * sizeof(typename Array::value_type));
  return {arrays.data()->data(), arrays.size() * std::tuple_size_v<Array>};
}

/// Members that must be constructed before BatchedModel.
struct Tet4Parts {
  Tet4Elements elements;
};

class Tet4Model final : private Tet4Parts, public BatchedModel {
 public:
  /// Builds the model; make(elements) creates their batches.
  template <class Make>
  Tet4Model(const TetMesh& mesh, const Make& make)
      : Tet4Parts{Tet4Elements(mesh)},
        BatchedModel(mesh, connect(mesh, elements), make(elements), elements_per_batch),
        volume_(Tet4Elements::lumped_volume(mesh)) {
    make_room();
  }

  const VecX& volume() const override { return volume_; }
  std::size_t dropped_elements() const override { return elements.dropped(); }
  bool can_follow(const MeshEdit& edit) const override {
    return batches().can_follow() && elements.can_follow(rest(), edit);
  }
  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) override;
  double rest_trace() override { return batches().rest_trace(); }

 private:
  /// Allocates memory that each step needs.
  void make_room() {
    fit_scratch(forces_, elements.size());
    if (!turns()) fit_scratch(stiffness_, elements.size());
  }
  void place(const ElementChunk& chunk, const double* x) override { batches().move(chunk.batch, x); }
  double energy_of(const ElementChunk& chunk) const override { return batches().energy(chunk.batch); }
  void find_forces(const ElementChunk& chunk) override {
    batches().forces(chunk.batch, std::span(forces_).subspan(chunk.first, chunk.size()));
  }
  std::span<const Vec3> forces() const override { return flat(forces_); }
  void reserve_stiffness() override { fit_scratch(stiffness_, elements.size()); }
  void find_stiffness(const ElementChunk& chunk, bool warped) override {
    const std::span<Stiffness> K = std::span(stiffness_).subspan(chunk.first, chunk.size());
    if (warped)
      batches().warped_stiffness(chunk.batch, K);
    else
      batches().stiffness(chunk.batch, K);
  }
  std::span<const Mat3> stiffness() const override { return flat(stiffness_); }

  void reserve(CorotatedElements& out) const override {
    fit_scratch(out.gradient, 4 * elements.size());
    fit_scratch(out.twist, elements.size());
    if (batches().has_fibers()) fit_scratch(out.fiber, elements.size());
    if (batches().has_point_tangents()) fit_scratch(out.blocks, floats_per_tet4 * elements.size() + 3);
  }
  void turn(const ElementChunk& chunk, double share, CorotatedElements& out) const override {
    const std::span gradients = std::span(out.gradient).subspan(4 * chunk.first, 4 * chunk.size());
    const std::span twists = std::span(out.twist).subspan(chunk.first, chunk.size());
    if (!batches().has_point_tangents()) return batches().turn(chunk.batch, share, gradients, twists);
    PointTangents points;
    batches().point_tangents(chunk.batch, share, points);
    lane_tet4_blocks(
        points, std::span(out.blocks).subspan(floats_per_tet4 * chunk.first, floats_per_tet4 * chunk.size()));
    if (share == 1) return;  // no damping
    turned_points(points, gradients, twists);
    if (points.has_fibers) turned_fibers(points, std::span(out.fiber).subspan(chunk.first, chunk.size()));
  }

  VecX volume_;
  std::vector<Forces> forces_;
  std::vector<Stiffness> stiffness_;
};

void Tet4Model::follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) {
  elements.follow(mesh, edit);
  follow_elements(material, mesh, edit);
  edit.kept_nodes.carry(volume_);
  for (const std::uint32_t node : edit.nodes) {
    double sum = 0;  // in the order of the elements, as in lumped_volume()
    for (const std::uint32_t corner : incidence().corners(node))
      sum += Tet4Elements::lumped_share(mesh, connectivity().element_of(corner));
    volume_[node] = sum;
  }
  make_room();
}

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

}  // namespace prosector::soft
