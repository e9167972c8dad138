#include "server/physics/mechanics/soft/springs/tet_springs.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "common/anatomy/rest_stretch.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/springs/spring_parts.h"

namespace prosector::soft {
namespace {

bool needs_volume_springs(const SoftMaterial& material, const Lame& c) {
  return material.hold_volume && c.lambda > c.mu;
}

/// Contributions of tetrahedra to the springs along their edges.
class TetSprings {
 public:
  TetSprings(const SoftMaterial& material, const TetMesh& mesh) : material_(material), mesh_(mesh) {
    for (const Material& kind : make_materials(material, {}).kinds) {
      const auto [lambda, mu] = kind.lame;
      // Without volume springs, the springs get the tensile stiffness of E at ν = ¼, the ratio of a spring
      // network.
      const double E = mu * (3 * lambda + 2 * mu) / (lambda + mu);
      modulus_.push_back(needs_volume_springs(material, kind.lame) ? mu : E / 2.5);
    }
  }

  /// Adds the contributions of tetrahedron `t` to springs between nodes for which `wanted` holds.
  template <class Wanted>
  void add(std::size_t t, const Wanted& wanted) {
    const auto& tet = mesh_.tets[t];
    const auto& x = mesh_.positions;
    const double mu = modulus_[kind_of(material_, mesh_, t)];
    const Vec3 u = x[tet[1]] - x[tet[0]], v = x[tet[2]] - x[tet[0]], w = x[tet[3]] - x[tet[0]];
    const double V = std::abs(u.cross(v).dot(w)) / 6;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) {
        if (!wanted(tet[a]) || !wanted(tet[b])) continue;
        const double l = (x[tet[a]] - x[tet[b]]).norm();
        parts_.push_back({edge(tet[a], tet[b]), l > 0 ? 2.5 * mu * V / (l * l) : 0});
        if (mesh_.stretch) by_itself_.push_back({parts_.back().at, length_by_itself(t, tet[a], tet[b])});
      }
  }

  void add_to(SpringNetwork& network) {
    const double given = material_.spring_stiffness;
    if (given > 0)
      for (StiffnessPart& part : parts_) part.value = given;
    for (std::size_t i = 0; i < by_itself_.size(); ++i) by_itself_[i].value *= parts_[i].value;
    add_springs(mesh_.positions, std::move(parts_), network);
    shorten(network);
    if (given > 0)
      for (Spring& spring : network.springs) spring.stiffness = given;
  }
  void reserve(std::size_t tets) { parts_.reserve(6 * tets); }

 private:
  /// Returns the length of an edge of tetrahedron t without prestretch, m.
  double length_by_itself(std::size_t t, std::uint32_t a, std::uint32_t b) const {
    const Mat3& V = mesh_.stretch->at(middle_of(mesh_, mesh_.tets[t]));
    return (V.inverse() * (mesh_.positions[a] - mesh_.positions[b])).norm();
  }

  /// Sets the rest lengths of prestretched springs to the mean over their tetrahedra, weighted by their
  /// contributions to the stiffness.
  void shorten(SpringNetwork& network) {
    sort_parts(mesh_.positions.size(), by_itself_);
    auto spring = network.springs.begin();
    for_each_place(by_itself_, [&](auto first, auto last) {
      while (spring != network.springs.end() && spring->node < first->at) ++spring;
      if (spring == network.springs.end() || spring->node != first->at) return;
      double sum = 0;
      for (auto part = first; part != last; ++part) sum += part->value;
      spring->rest = sum / spring->stiffness;
    });
  }

  const SoftMaterial& material_;
  const TetMesh& mesh_;
  std::vector<double> modulus_;  // Pa, by material: modulus of the springs
  std::vector<StiffnessPart> parts_;
  std::vector<Part<Edge, double>> by_itself_;  // prestretched: rest lengths, then times stiffness
};

}  // namespace

std::optional<Materials> volume_springs(const SoftMaterial& material, const TetMesh& mesh) {
  Materials out = make_materials(material, mesh);
  bool needed = false;
  for (Material& kind : out.kinds) {
    const bool held = needs_volume_springs(material, kind.lame);
    kind.lame = {held ? kind.lame.lambda - kind.lame.mu : 0, 0};
    needed = needed || held;
  }
  return needed ? std::optional(out) : std::nullopt;
}

SpringNetwork make_tet_springs(const SoftMaterial& material, const TetMesh& mesh) {
  SpringNetwork out;
  out.rest = to_vector(mesh.positions);
  out.volume = Tet4Elements::lumped_volume(mesh);
  TetSprings parts(material, mesh);
  parts.reserve(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) parts.add(t, [](std::uint32_t) { return true; });
  parts.add_to(out);
  return out;
}

// A spring with a contribution of a changed tetrahedron has both nodes in the edit. These springs, and the
// volumes of the edit's nodes, are recomputed from all tetrahedra at them, in their order.
void follow_tet_springs(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit,
                        SpringNetwork& springs) {
  if (!edit.kept_nodes.all_unmoved()) renumber(edit.kept_nodes.destinations(), springs.springs);
  edit.kept_nodes.carry(springs.volume);
  std::vector<char> is_touched(mesh.positions.size(), 0);
  for (const std::uint32_t node : edit.nodes) {
    is_touched[node] = 1;
    springs.volume[node] = 0;
  }
  const auto touched = [&](std::uint32_t node) { return is_touched[node] != 0; };
  TetSprings parts(material, mesh);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& tet = mesh.tets[t];
    const auto corners = std::count_if(tet.begin(), tet.end(), touched);
    if (corners == 0) continue;
    const double share = Tet4Elements::lumped_share(mesh, t);
    for (const std::uint32_t node : tet)
      if (touched(node)) springs.volume[node] += share;
    if (corners > 1) parts.add(t, touched);
  }
  SpringNetwork fresh;
  parts.add_to(fresh);
  replace(springs.springs, std::move(fresh.springs),
          [&](const Spring& s) { return touched(s.node[0]) && touched(s.node[1]); });
  springs.dropped = fresh.dropped;
  springs.rest = to_vector(mesh.positions);
}

}  // namespace prosector::soft
