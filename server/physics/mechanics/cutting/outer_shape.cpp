#include "server/physics/mechanics/cutting/outer_shape.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector::cutting {

OuterShape::Place OuterShape::place(NodeId node) const {
  if (node >= outer_.size() || outer_[node] == 0) return {};
  return {{node}, {1}, 1};
}

const OuterShape::Edge* OuterShape::edge(NodeId a, NodeId b) const {
  PROSECTOR_ASSERT(std::max(a, b) + std::size_t{1} < begin_.size());
  const auto [low, high] = std::minmax(a, b);
  for (std::uint32_t i = begin_[low]; i < begin_[low + 1u]; ++i)
    if (edges_[i].high == high) return &edges_[i];
  return nullptr;
}

OuterShape::Place OuterShape::between(const Place& a, const Place& b, double t) const {
  PROSECTOR_ASSERT(t >= 0 && t <= 1 && a.nodes <= 3 && b.nodes <= 3);
  if (a.nodes == 0 || b.nodes == 0) return {};
  Place out = a;
  for (std::uint32_t i = 0; i < a.nodes; ++i) out.weight[i] *= 1 - t;
  for (std::uint32_t i = 0; i < b.nodes; ++i) {
    std::uint32_t at = 0;
    while (at < out.nodes && out.node[at] != b.node[i]) ++at;
    if (at == 3) return {};
    if (at == out.nodes) out.node[out.nodes++] = b.node[i];
    out.weight[at] += t * b.weight[i];
  }
  if (out.nodes == 1) return out;
  const Edge* const side = edge(out.node[0], out.node[1]);
  if (side == nullptr) return {};
  if (out.nodes == 3 && side->beyond[0] != out.node[2] && side->beyond[1] != out.node[2]) return {};
  return out;
}

Vec3 OuterShape::offset(const Place& place) const {
  PROSECTOR_ASSERT(place.nodes <= 3);
  Vec3 out = Vec3::Zero();
  for (std::uint32_t i = 0; i < place.nodes; ++i) out += place.weight[i] * offset_[place.node[i]];
  for (std::uint32_t i = 0; i < place.nodes; ++i)
    for (std::uint32_t j = i + 1; j < place.nodes; ++j)
      out += 4 * place.weight[i] * place.weight[j] * edge(place.node[i], place.node[j])->sag;
  return out;
}

bool OuterShape::has_middle(const Place& a, const Place& b) const {
  if (a.nodes != 1 || b.nodes != 1) return false;
  const Edge* const found = edge(a.node[0], b.node[0]);
  return found != nullptr && found->middle;
}

}  // namespace prosector::cutting
