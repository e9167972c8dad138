#pragma once
// Ordered lists of springs and bends, and of the contributions of cells to them.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/soft/base/mesh_edit.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"

namespace prosector::soft {

using Edge = std::array<std::uint32_t, 2>;  // ascending

inline Edge edge(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Contribution of one cell or tetrahedron, such as a stiffness in N/m, to the spring along an edge or the
/// bending element of a line of nodes. `at`: the nodes of the edge or line.
template <class Nodes, class Value>
struct Part {
  Nodes at;
  Value value;
};
using StiffnessPart = Part<Edge, double>;  // N/m

/// Sorts contributions of cells to springs or bending elements by their nodes; those at the same nodes keep
/// their order. `nodes`: total number of nodes. Takes linear time if few parts have the same first node.
template <class Nodes, class Value>
void sort_parts(std::size_t nodes, std::vector<Part<Nodes, Value>>& parts) {
  std::vector<std::uint32_t> next(nodes + 1, 0);
  for (const auto& part : parts) ++next[part.at[0] + 1];
  for (std::size_t i = 0; i < nodes; ++i) next[i + 1] += next[i];
  const std::vector<std::uint32_t> begin = next;
  std::vector<Part<Nodes, Value>> out(parts.size());
  for (const auto& part : parts) {
    std::uint32_t at = next[part.at[0]]++;
    for (; at > begin[part.at[0]] && part.at < out[at - 1].at; --at) out[at] = out[at - 1];
    out[at] = part;
  }
  parts = std::move(out);
}

/// Calls f(first, last) with the iterators of each run of consecutive parts (contributions of cells) that
/// have the same nodes. `parts` must be sorted by nodes.
template <class Nodes, class Value, class F>
void for_each_place(const std::vector<Part<Nodes, Value>>& parts, const F& f) {
  for (auto first = parts.begin(), last = first; first != parts.end(); first = last) {
    while (last != parts.end() && last->at == first->at) ++last;
    f(first, last);
  }
}

/// Appends to `network` one spring for each edge in `parts`, in the order of its nodes. Its stiffness is the
/// sum of the parts at the edge, and its rest length the edge's length. `x`: rest positions, m.
void add_springs(std::span<const Vec3> x, std::vector<StiffnessPart> parts, SpringNetwork& network);

inline bool before(const Spring& a, const Spring& b) {
  return a.node < b.node;
}
inline bool before(const Bend& a, const Bend& b) {
  if (a.count != b.count) return a.count > b.count;  // bends about edges come first
  return a.node < b.node;
}

/// Replaces the springs or bending elements in `elements` for which `affected` is true by those in `fresh`
/// for which `affected` is true. Both lists must be in the order of before().
template <class Element, class Affected>
void replace(std::vector<Element>& elements, std::vector<Element> fresh, const Affected& affected) {
  std::erase_if(elements, affected);
  std::erase_if(fresh, [&](const Element& e) { return !affected(e); });
  std::vector<Element> out(elements.size() + fresh.size());
  std::merge(elements.begin(), elements.end(), fresh.begin(), fresh.end(), out.begin(),
             [](const Element& a, const Element& b) { return before(a, b); });
  elements = std::move(out);
}

/// Changes the node indices of springs or bending elements after an edit. now[i] is the new index of node i.
/// Elements with a removed node (Kept::none) are removed. The others keep their order, because nodes keep
/// theirs.
template <class Element>
void renumber(std::span<const std::uint32_t> now, std::vector<Element>& elements) {
  std::erase_if(elements, [&](const Element& e) {
    const auto nodes = e.nodes();
    return std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t n) { return now[n] == Kept::none; });
  });
  for (Element& e : elements)
    for (std::size_t k = 0; k < e.nodes().size(); ++k) e.node[k] = now[e.node[k]];
}

}  // namespace prosector::soft
