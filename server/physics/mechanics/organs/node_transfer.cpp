#include "server/physics/mechanics/organs/node_transfer.h"

#include <algorithm>

#include "common/assert.h"
#include "server/physics/mechanics/organs/tet_lineage.h"

namespace prosector::organs {
namespace {

/// Returns the barycentric weights of a point with offset r from a triangle's corner, in its plane. u and v:
/// edges from that corner to the others.
Vec3 triangle_weights(const Vec3& u, const Vec3& v, const Vec3& r) {
  const Vec3 n = u.cross(v);
  const double b = r.cross(v).dot(n) / n.squaredNorm(), c = u.cross(r).dot(n) / n.squaredNorm();
  return {1 - b - c, b, c};
}

/// Returns the barycentric weights of a point of the rest shape.
std::array<double, 4> weights_at(const TetMesh& mesh, std::size_t tet, const Vec3& point) {
  const auto& c = mesh.tets[tet];
  const Vec3 origin = mesh.positions[c[0]];
  if (c[2] == c[3]) {
    const Vec3 w =
        triangle_weights(mesh.positions[c[1]] - origin, mesh.positions[c[2]] - origin, point - origin);
    return {w[0], w[1], w[2], 0};
  }
  Mat3 edges;
  edges << mesh.positions[c[1]] - origin, mesh.positions[c[2]] - origin, mesh.positions[c[3]] - origin;
  const Vec3 w = edges.inverse() * (point - origin);
  return {1 - w.sum(), w[0], w[1], w[2]};
}

}  // namespace

/// Returns the source of the position `rest` in the old tetrahedron there; none: there was no tetrahedron.
std::optional<NodeTransfer::Source> NodeTransfer::within(const cutting::TetComplex& complex,
                                                         std::span<const PieceMesh* const> before,
                                                         std::span<const soft::EdgeNodes> edges,
                                                         cutting::TetId tet, const Vec3& rest) {
  const auto found = find_old(complex, before, tet);
  if (!found) return std::nullopt;
  const auto& [p, i] = *found;
  const TetMesh& mesh = before[p]->mesh;
  const auto w = weights_at(mesh, i, rest);
  const auto& corner = mesh.tets[i];
  Source source;
  const bool quadratic = !edges.empty();
  for (std::size_t k = 0; k < 4; ++k)
    source.terms[source.count++] = {p, corner[k], quadratic ? w[k] * (2 * w[k] - 1) : w[k]};
  if (quadratic)
    for (const auto& [a, b] : soft::EdgeNodes::edges_of_tet)
      source.terms[source.count++] = {p, edges[p].find(corner[a], corner[b]), 4 * w[a] * w[b]};
  return source;
}

NodeTransfer::NodeTransfer(const cutting::TetComplex& complex, std::span<const PieceMesh* const> before,
                           const PieceMesh& now, bool quadratic) {
  std::vector<soft::EdgeNodes> edges_before;
  if (quadratic)
    for (const PieceMesh* piece : before) edges_before.emplace_back(piece->mesh.tets, piece->nodes.size());

  PROSECTOR_ASSERT(is_ascending(now.nodes));
  // Positions in each piece's nodes, which ascend like those of `now`.
  std::vector<std::size_t> reached(before.size(), 0);
  const auto itself = [&](cutting::NodeId id) -> std::optional<Source> {
    for (std::uint32_t p = 0; p < before.size(); ++p) {
      const std::vector<cutting::NodeId>& nodes = before[p]->nodes;
      std::size_t& i = reached[p];
      while (i < nodes.size() && nodes[i] < id) ++i;
      if (i == nodes.size() || nodes[i] != id) continue;
      Source source;
      source.terms[source.count++] = {p, static_cast<std::uint32_t>(i), 1};
      return source;
    }
    return std::nullopt;
  };
  sources_.reserve(now.mesh.positions.size());
  for (const cutting::NodeId id : now.nodes) {
    std::optional<Source> source = itself(id);
    if (!source) source = within(complex, before, edges_before, complex.star(id).front(), complex.rest(id));
    sources_.push_back(source.value_or(Source{}));
  }
  if (!quadratic) return;
  const soft::EdgeNodes edges(now.mesh.tets, now.nodes.size());
  sources_.resize(now.nodes.size() + edges.size());
  for (std::size_t k = 0; k < edges.size(); ++k) {  // edges that existed before
    const Source &a = sources_[edges.edges()[k][0]], &b = sources_[edges.edges()[k][1]];
    if (a.count != 1 || b.count != 1 || a.terms[0].piece != b.terms[0].piece) continue;
    const std::uint32_t p = a.terms[0].piece, node = edges_before[p].find(a.terms[0].node, b.terms[0].node);
    if (node != soft::EdgeNodes::none) sources_[now.nodes.size() + k] = {1, {{{p, node, 1}}}};
  }
  for (std::size_t t = 0; t < now.mesh.tets.size(); ++t)
    for (const auto& [a, b] : soft::EdgeNodes::edges_of_tet) {
      const std::uint32_t i = now.mesh.tets[t][a], j = now.mesh.tets[t][b];
      Source& to = sources_[edges.find(i, j)];
      if (to.count > 0) continue;
      const Vec3 middle = (now.mesh.positions[i] + now.mesh.positions[j]) / 2;
      if (auto source = within(complex, before, edges_before, now.tets[t], middle)) {
        to = *source;
        continue;
      }
      // The cut was undone: interpolates halfway between the ends, which both existed.
      for (const std::uint32_t end : {i, j}) {
        to.terms[to.count] = sources_[end].terms[0];
        to.terms[to.count++].weight = 0.5;
      }
    }
}

NodeTransfer::NodeTransfer(const cutting::TetComplex& complex, const PieceMesh& before,
                           std::span<const cutting::NodeId> made, std::span<const cutting::TetId> tets,
                           const soft::MeshEdit& edit, const soft::EdgeNodes* edges)
    : sources_(edit.made_nodes.size()) {
  PROSECTOR_ASSERT(made.size() <= edit.made_nodes.size() && edit.middles.size() <= 6 * tets.size());
  const PieceMesh* const pieces[] = {&before};
  const std::span<const soft::EdgeNodes> edges_before(edges, edges ? 1 : 0);
  const auto find = [&](cutting::TetId tet, const Vec3& rest) {
    return within(complex, pieces, edges_before, tet, rest).value_or(Source{});
  };
  for (std::size_t i = 0; i < made.size(); ++i)
    sources_[i] = find(complex.star(made[i]).front(), complex.rest(made[i]));
  for (std::size_t i = 0; i < edit.middles.size(); ++i) {
    const auto at = std::lower_bound(edit.made_nodes.begin(), edit.made_nodes.end(), edit.middles[i]);
    if (at == edit.made_nodes.end() || *at != edit.middles[i]) continue;
    const auto node = static_cast<std::size_t>(at - edit.made_nodes.begin());
    if (sources_[node].count == 0) sources_[node] = find(tets[i / 6], edit.positions[node]);
  }
}

VecX NodeTransfer::operator()(std::span<const VecX* const> fields) const {
  VecX out(3 * static_cast<Eigen::Index>(sources_.size()));
  for (std::size_t n = 0; n < sources_.size(); ++n) {
    const Source& source = sources_[n];
    if (source.count == 1) {  // the same node
      const Term& term = source.terms[0];
      out.segment<3>(3 * static_cast<Eigen::Index>(n)) =
          fields[term.piece]->segment<3>(3 * Eigen::Index{term.node});
      continue;
    }
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < source.count; ++k) {
      const Term& term = source.terms[k];
      sum += term.weight * fields[term.piece]->segment<3>(3 * Eigen::Index{term.node});
    }
    out.segment<3>(3 * static_cast<Eigen::Index>(n)) = sum;
  }
  return out;
}

VecX NodeTransfer::carried(const VecX& field, const soft::MeshEdit& edit) const {
  PROSECTOR_ASSERT(sources_.size() == edit.made_nodes.size());
  const VecX* const fields[] = {&field};
  const VecX made = (*this)(fields);
  VecX out(3 * static_cast<Eigen::Index>(edit.kept_nodes.now));
  for (const soft::Kept::Run& run : edit.kept_nodes.runs)
    out.segment(3 * Eigen::Index{run.to}, 3 * Eigen::Index{run.count}) =
        field.segment(3 * Eigen::Index{run.from}, 3 * Eigen::Index{run.count});
  for (std::size_t i = 0; i < edit.made_nodes.size(); ++i)
    out.segment<3>(3 * Eigen::Index{edit.made_nodes[i]}) = made.segment<3>(3 * static_cast<Eigen::Index>(i));
  return out;
}

}  // namespace prosector::organs
