#include "server/physics/mechanics/organs/surface_follow.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector::organs {
namespace {

using Numbers = std::vector<std::uint32_t>;

void sort_unique(Numbers& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Returns how many of the ascending numbers are less than `number`.
std::uint32_t count_below(const Numbers& numbers, std::uint32_t number) {
  return static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), number) -
                                    numbers.begin());
}

bool has(const Numbers& numbers, std::uint32_t number) {
  return std::binary_search(numbers.begin(), numbers.end(), number);
}

/// Returns the edit of a numbered list. `gone`: ascending indices; `come`: ascending numbers that are not
/// among the remaining ones.
ListEdit edit_of(const Numbers& before, Numbers gone, const Numbers& come) {
  PROSECTOR_ASSERT(is_ascending(before) && is_ascending(come));
  Numbers come_before;
  come_before.reserve(come.size());
  for (const std::uint32_t number : come) come_before.push_back(count_below(before, number));
  return ListEdit(before.size(), std::move(gone), come_before);
}

/// Returns those of these vertices that are used by removed triangles only; ascending.
Numbers unused(const TriangleMesh& surface, const Numbers& gone_triangles, Numbers vertices) {
  if (vertices.empty()) return vertices;
  std::vector<std::uint8_t> used(surface.positions.size(), 0);
  auto gone = gone_triangles.begin();
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    if (gone != gone_triangles.end() && *gone == i) {
      ++gone;
      continue;
    }
    for (const std::uint32_t corner : surface.triangles[i]) used[corner] = 1;
  }
  std::erase_if(vertices, [&](std::uint32_t vertex) { return used[vertex] != 0; });
  return vertices;
}

/// Returns an entry's number; in a list that was never cut, its index.
std::uint32_t number_of(const Numbers& numbers, std::uint32_t index) {
  return numbers.empty() ? index : numbers[index];
}

/// Returns the edit between lists of `before` and `now` entries. `is_same(i, j)`: whether entries of the same
/// number, with old index i and new index j, are equal.
template <class F>
ListEdit edit_between(std::size_t before, const Numbers& numbered_before, std::size_t now,
                      const Numbers& numbered, const F& is_same) {
  PROSECTOR_ASSERT((numbered_before.empty() || numbered_before.size() == before) &&
                   (numbered.empty() || numbered.size() == now));
  Numbers gone, come_before;
  std::uint32_t i = 0;
  for (std::uint32_t j = 0; j < now; ++j) {
    const std::uint32_t number = number_of(numbered, j);
    while (i < before && number_of(numbered_before, i) < number) gone.push_back(i++);
    if (i < before && number_of(numbered_before, i) == number) {
      if (is_same(i, j)) {
        ++i;
        continue;
      }
      gone.push_back(i++);
    }
    come_before.push_back(i);
  }
  while (i < before) gone.push_back(i++);
  return ListEdit(before, std::move(gone), come_before);
}

/// Returns the current vertices of removed and added triangles.
Numbers touched_by(const SurfaceEdit& edit, const TriangleMesh& before) {
  Numbers out;
  for (const std::uint32_t triangle : edit.triangles.gone)
    for (const std::uint32_t vertex : before.triangles[triangle])
      if (edit.vertices.now[vertex] != ListEdit::none) out.push_back(edit.vertices.now[vertex]);
  for (const auto& corners : edit.corners) out.insert(out.end(), corners.begin(), corners.end());
  sort_unique(out);
  return out;
}

}  // namespace

SurfaceEdit edit_of_surface(const cutting::TetComplex& complex, const cutting::Skin& skin,
                            std::span<const cutting::NodeId> nodes,
                            const std::function<bool(cutting::TetId)>& in_piece,
                            std::vector<std::uint32_t> slots, const TriangleMesh& before,
                            const Numbering& numbering, std::uint32_t first_vertex,
                            std::uint32_t first_triangle) {
  PROSECTOR_ASSERT(numbering.triangles.size() == before.triangles.size() &&
                   numbering.vertices.size() == before.positions.size());
  PROSECTOR_ASSERT(is_ascending(nodes));
  SurfaceEdit out;
  sort_unique(slots);
  // Triangles by index; vertices of these, by index; numbers of vertices of new triangles.
  Numbers gone, left, met;
  for (const std::uint32_t slot : slots) {
    const std::uint32_t number = first_triangle + slot, index = count_below(numbering.triangles, number);
    if (index < numbering.triangles.size() && numbering.triangles[index] == number) {
      gone.push_back(index);
      left.insert(left.end(), before.triangles[index].begin(), before.triangles[index].end());
    }
    const cutting::Skin::Triangle& triangle = skin.triangles()[slot];
    if (triangle.gone() || !in_piece(skin.tet(slot))) continue;
    out.triangle_numbers.push_back(number);
    out.inner.push_back(triangle.inner ? 1 : 0);
    for (const std::uint32_t corner : triangle.corners) met.push_back(first_vertex + corner);
  }
  out.triangles = edit_of(numbering.triangles, gone, out.triangle_numbers);
  sort_unique(left);
  Numbers come = met;
  sort_unique(come);
  Numbers may_go = left;
  std::erase_if(may_go, [&](std::uint32_t vertex) { return has(come, numbering.vertices[vertex]); });
  std::erase_if(come, [&](std::uint32_t number) { return has(numbering.vertices, number); });
  out.vertices = edit_of(numbering.vertices, unused(before, gone, std::move(may_go)), come);
  out.vertex_numbers = std::move(come);

  const auto index_of = [&](cutting::NodeId node) {
    return static_cast<std::uint32_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  };
  for (const std::uint32_t number : out.vertex_numbers) {
    const auto hung = hang(complex, skin.vertices()[number - first_vertex], index_of);
    out.rows.push_back(hung.row);
    out.positions.push_back(hung.rest);
  }
  const auto vertex_now = [&](std::uint32_t number) {
    const std::uint32_t index = count_below(numbering.vertices, number);
    if (index < numbering.vertices.size() && numbering.vertices[index] == number)
      return out.vertices.now[index];
    return out.vertices.come[count_below(out.vertex_numbers, number)];
  };
  for (std::size_t i = 0; i < met.size(); i += 3)
    out.corners.push_back({vertex_now(met[i]), vertex_now(met[i + 1]), vertex_now(met[i + 2])});
  out.touched = touched_by(out, before);
  return out;
}

SurfaceEdit edit_between(const TriangleMesh& before, const Numbering& numbered_before,
                         const TriangleMesh& now, const SparseMap& hung, const Numbering& numbered) {
  SurfaceEdit out;
  out.vertices =
      edit_between(before.positions.size(), numbered_before.vertices, now.positions.size(), numbered.vertices,
                   [&](std::uint32_t i, std::uint32_t j) { return before.positions[i] == now.positions[j]; });
  for (const std::uint32_t vertex : out.vertices.come) {
    out.positions.push_back(now.positions[vertex]);
    out.rows.push_back(hung.rows[vertex]);
    out.vertex_numbers.push_back(number_of(numbered.vertices, vertex));
  }
  out.triangles = edit_between(
      before.triangles.size(), numbered_before.triangles, now.triangles.size(), numbered.triangles,
      [&](std::uint32_t i, std::uint32_t j) {
        const auto &were = before.triangles[i], &are = now.triangles[j];
        return std::equal(were.begin(), were.end(), are.begin(),
                          [&](std::uint32_t a, std::uint32_t b) { return out.vertices.now[a] == b; });
      });
  for (const std::uint32_t triangle : out.triangles.come) {
    out.corners.push_back(now.triangles[triangle]);
    out.inner.push_back(0);
    out.triangle_numbers.push_back(number_of(numbered.triangles, triangle));
  }
  out.touched = touched_by(out, before);
  return out;
}

}  // namespace prosector::organs
