#include "server/physics/mechanics/organs/refined_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/anatomy/embedding.h"
#include "common/assert.h"
#include "common/error.h"
#include "server/physics/mechanics/organs/tet_lineage.h"
#include "server/physics/mechanics/soft/rungs.h"

namespace prosector::organs {
namespace {

// Slightly more than the longest edge of a cube's tetrahedra over its side.
constexpr double longest_share = 1.75;
constexpr double linger_seconds = 1;  // s: time for which refined elements stay after the last contact

cutting::RefinementLimits limits_of(const SoftDesc& desc, double tick_rate) {
  const double cell = desc.refinement.cell > 0 ? desc.refinement.cell : desc.geometry.cell / 2;
  return {.edge = longest_share * cell,
          .reach = desc.refinement.reach > 0 ? desc.refinement.reach : desc.geometry.cell,
          .most = static_cast<std::size_t>(desc.refinement.max_elements),
          .linger = static_cast<std::uint32_t>(std::ceil(linger_seconds * tick_rate))};
}

cutting::LocalRefinement refinement_of(const soft::SoftBody& compiled, double tick_rate) {
  const SoftDesc& desc = compiled.desc();
  const auto refusal = [&](const std::string& why) {
    return InputError(fmt::format("[[soft]] \"{}\": refine is \"touch\", {}", desc.name, why));
  };
  if (soft::mesh_kind(compiled.anatomy()) != soft::MeshKind::tets || desc.configuration.is_quadratic())
    throw refusal(
        "which is allowed only for solids of linear tetrahedra (element = \"tet4\"); set refine = \"none\"");
  if (compiled.dropped_elements() > 0)
    throw refusal(
        fmt::format("which needs tetrahedra with a volume, but {} of the body's are degenerate; set refine = "
                    "\"none\" or mesh the body again",
                    compiled.dropped_elements()));
  try {
    return {compiled.anatomy().tets, desc.material.density, limits_of(desc, tick_rate)};
  } catch (const InputError& error) {
    throw refusal(fmt::format("but its mesh does not allow it: {}; set refine = \"none\" or use another mesh",
                              error.what()));
  }
}

/// Returns by surface vertex the first tetrahedron that has all nodes of its embedding row.
std::vector<cutting::TetId> carriers(const Anatomy& anatomy, const cutting::TetComplex& complex) {
  std::vector<cutting::TetId> out;
  for (const SparseMap::Row& row : anatomy.embedding.rows) {
    const auto heaviest = std::max_element(row.weight.begin(), row.weight.end()) - row.weight.begin();
    const auto star = complex.star(row.node[static_cast<std::size_t>(heaviest)]);
    const auto has_all = [&](cutting::TetId tet) {
      for (std::size_t k = 0; k < row.node.size(); ++k)
        if (row.weight[k] != 0 && !cutting::has_corner(complex, tet, row.node[k])) return false;
      return true;
    };
    const auto found = std::find_if(star.begin(), star.end(), has_all);
    out.push_back(found == star.end() ? cutting::TetComplex::none : *found);
  }
  return out;
}

/// Returns the index of a node of the refined mesh.
std::uint32_t index_of(const PieceMesh& mesh, cutting::NodeId node) {
  PROSECTOR_ASSERT(std::ranges::binary_search(mesh.nodes, node));
  return static_cast<std::uint32_t>(std::lower_bound(mesh.nodes.begin(), mesh.nodes.end(), node) -
                                    mesh.nodes.begin());
}

double largest(const std::array<double, 4>& weights) {
  double out = 0;
  for (const double weight : weights) out = std::max(out, std::abs(weight));
  return out;
}

/// Returns the weights of a point of a compiled tetrahedron by the corners of the current tetrahedron there.
/// A point far outside is embedded in a larger ancestor of that tetrahedron, whose corners are still nodes.
SparseMap::Row hung_within(const cutting::TetComplex& complex, cutting::TetId tet,
                           const SparseMap::Row& compiled, const PieceMesh& now) {
  std::array<double, 4> weight{};
  for (std::size_t k = 0; k < compiled.node.size(); ++k)
    if (compiled.weight[k] != 0) weight[complex.corner_index(tet, compiled.node[k])] += compiled.weight[k];
  while (!complex.has_tet(tet)) {
    const cutting::TetId with_a = complex.lineage(tet).child, with_b = with_a + 1;
    PROSECTOR_ASSERT(with_a != cutting::TetComplex::none && complex.lineage(with_a).parent == tet);
    const auto corners = complex.corners(tet), of_a = complex.corners(with_a), of_b = complex.corners(with_b);
    std::size_t a = 0, b = 0;  // corners of the edge that was bisected
    for (std::size_t k = 0; k < 4; ++k) {
      if (of_a[k] != corners[k]) b = k;
      if (of_b[k] != corners[k]) a = k;
    }
    const bool nearer_a = weight[a] >= weight[b];
    const std::size_t kept_corner = nearer_a ? a : b, moved = nearer_a ? b : a;
    std::array<double, 4> in_half = weight;
    in_half[kept_corner] -= weight[moved];
    in_half[moved] *= 2;
    if (largest(in_half) > std::max(max_embedding_weight, largest(weight))) break;
    weight = in_half;
    tet = nearer_a ? with_a : with_b;
  }
  SparseMap::Row out;
  for (std::size_t k = 0; k < 4; ++k) {
    out.node[k] = index_of(now, complex.corners(tet)[k]);
    out.weight[k] = weight[k];
  }
  return out;
}

/// Copies a field to vectors by node id; nodes without values get zero.
std::vector<Vec3> by_id(const VecX& field, const PieceMesh& mesh, std::size_t end) {
  PROSECTOR_ASSERT(field.size() == 3 * std::ssize(mesh.nodes));
  std::vector<Vec3> out(end, Vec3::Zero());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    out[mesh.nodes[i]] = field.segment<3>(3 * static_cast<Eigen::Index>(i));
  return out;
}

VecX by_index(const std::vector<Vec3>& values, const PieceMesh& mesh) {
  VecX out(3 * static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    out.segment<3>(3 * static_cast<Eigen::Index>(i)) = values[mesh.nodes[i]];
  return out;
}

Vec3 between(const std::vector<Vec3>& values, const cutting::SplitEdge& op) {
  return values[op.a] + (values[op.b] - values[op.a]) * op.t;
}

}  // namespace

RefinedBody::RefinedBody(const soft::SoftBody& compiled, double tick_rate)
    : whole(compiled.anatomy()),
      content_hash(compiled.content_hash()),
      mesh(refinement_of(compiled, tick_rate)) {
  carrier = carriers(whole, mesh.complex());
  piece = refined_mesh(*this);
}

RefinedBody::RefinedBody(Anatomy anatomy, double density, const cutting::RefinementLimits& limits)
    : whole(std::move(anatomy)), mesh(whole.tets, density, limits) {
  carrier = carriers(whole, mesh.complex());
}

PieceMesh refined_mesh(const RefinedBody& body) {
  const cutting::TetComplex& complex = body.mesh.complex();
  const auto compiled = static_cast<cutting::NodeId>(body.whole.tets.positions.size());
  PieceMesh out;
  for (cutting::NodeId node = 0; node < complex.node_end(); ++node)
    if (node < compiled || complex.has_node(node)) {
      out.nodes.push_back(node);
      out.mesh.positions.push_back(complex.rest(node));
    }
  std::vector<cutting::TetId> at_place(complex.tet_end(), cutting::TetComplex::none);
  for (cutting::TetId tet = 0; tet < complex.tet_end(); ++tet)
    if (complex.has_tet(tet)) at_place[complex.lineage(tet).place] = tet;
  for (cutting::TetId place = 0; place < at_place.size(); ++place) {
    const cutting::TetId tet = at_place[place];
    if (tet == cutting::TetComplex::none) continue;
    out.tets.push_back(tet);
    out.places.push_back(place);
    const auto c = complex.corners(tet);
    const auto index = [&](cutting::NodeId node) { return node < compiled ? node : index_of(out, node); };
    out.mesh.tets.push_back({index(c[0]), index(c[1]), index(c[2]), index(c[3])});
  }
  return out;
}

SparseMap refined_embedding(const RefinedBody& body, const PieceMesh& now) {
  PROSECTOR_ASSERT(body.carrier.size() == body.whole.embedding.rows.size());
  const cutting::TetComplex& complex = body.mesh.complex();
  SparseMap out = body.whole.embedding;
  for (std::size_t vertex = 0; vertex < out.rows.size(); ++vertex)
    if (const cutting::TetId tet = body.carrier[vertex];
        tet != cutting::TetComplex::none && !complex.has_tet(tet))
      out.rows[vertex] = hung_within(complex, tet, out.rows[vertex], now);
  return out;
}

Anatomy refined_anatomy(const RefinedBody& body, const PieceMesh& now) {
  return {{now.mesh.positions, now.mesh.tets, body.whole.tets.stretch},
          body.whole.surface,
          refined_embedding(body, now)};
}

VecX refined_field(const RefinedBody& body, const PieceMesh& now, const VecX& compiled) {
  const cutting::TetComplex& complex = body.mesh.complex();
  const std::size_t count = body.whole.tets.positions.size();
  PROSECTOR_ASSERT(compiled.size() == 3 * std::ssize(body.whole.tets.positions) && now.nodes.size() >= count);
  std::vector<Vec3> values(complex.node_end(), Vec3::Zero());
  for (std::size_t node = 0; node < count; ++node)
    values[node] = compiled.segment<3>(3 * static_cast<Eigen::Index>(node));
  for (const cutting::NodeId node :
       std::span(now.nodes).subspan(count)) {  // ends of an edge precede its midpoint
    const cutting::TetTables::Origin& from = complex.tables().origin[node];
    values[node] = values[from.a] + (values[from.b] - values[from.a]) * from.t;
  }
  return by_index(values, now);
}

VecX carried(const VecX& field, const PieceMesh& before, const PieceMesh& now,
             std::span<const cutting::RefinementStep> steps, Leaving leaving) {
  PROSECTOR_ASSERT(!before.nodes.empty());
  std::size_t end = before.nodes.back() + 1u;
  for (const cutting::RefinementStep& step : steps) end = std::max<std::size_t>(end, step.split.node + 1u);
  std::vector<Vec3> values = by_id(field, before, end);
  for (const cutting::RefinementStep& step : steps) {
    const cutting::SplitEdge& op = step.split;
    const Vec3 middle = between(values, op);
    if (step.made) {
      values[op.node] = middle;
    } else if (leaving == Leaving::momentum) {
      PROSECTOR_ASSERT(step.a_mass > 0 && step.b_mass > 0);
      const Vec3 more = step.node_mass * (values[op.node] - middle);
      values[op.a] += (1 - op.t) / step.a_mass * more;
      values[op.b] += op.t / step.b_mass * more;
    }
  }
  return by_index(values, now);
}

VecX refined_history(const VecX& history, const cutting::TetComplex& complex, const PieceMesh& before,
                     const PieceMesh& now, std::span<const cutting::RefinementStep> steps) {
  const Eigen::Index numbers = history_per_tet(history, before);
  if (numbers == 0) return {};
  std::map<cutting::TetId, VecX> changed;
  const auto of = [&](cutting::TetId tet) -> VecX {
    if (const auto found = changed.find(tet); found != changed.end()) return found->second;
    const cutting::TetId place = complex.lineage(tet).place;
    const auto at = std::lower_bound(before.places.begin(), before.places.end(), place);
    return history.segment(numbers * static_cast<Eigen::Index>(at - before.places.begin()), numbers);
  };
  for (const cutting::RefinementStep& step : steps)
    for (cutting::TetId half = step.split.first; half < step.split.first + 2 * step.split.count; half += 2) {
      const cutting::TetId whole = complex.lineage(half).parent;
      if (step.made)
        changed[half] = changed[half + 1] = of(whole);
      else
        changed[whole] = (of(half) + of(half + 1)) / 2;
    }
  VecX out(numbers * static_cast<Eigen::Index>(now.tets.size()));
  for (std::size_t i = 0; i < now.tets.size(); ++i)
    out.segment(numbers * static_cast<Eigen::Index>(i), numbers) = of(now.tets[i]);
  return out;
}

}  // namespace prosector::organs
