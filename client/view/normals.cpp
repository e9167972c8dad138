#include "client/view/normals.h"

#include <cmath>
#include <numeric>
#include <span>
#include <unordered_map>

namespace prosector {
namespace {

using TriangleSpan = std::span<const std::array<std::uint32_t, 3>>;

/// Union-find over triangle corners 3·t + k.
class CornerSets {
 public:
  explicit CornerSets(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

struct EdgeCorners {
  std::uint32_t triangle, low, high;  // corners at the edge's lower and higher vertex
};

/// Unites the corners of a vertex across edges with a small crease angle.
CornerSets smooth_corners(TriangleSpan triangles, const std::vector<Vec3>& face_normals, double cos_angle) {
  CornerSets sets(3 * triangles.size());
  std::unordered_map<std::uint64_t, EdgeCorners> first_at_edge;
  first_at_edge.reserve(2 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t low = 3 * t + k, high = 3 * t + (k + 1) % 3;
      std::uint32_t v = triangles[t][k], w = triangles[t][(k + 1) % 3];
      if (v > w) {
        std::swap(v, w);
        std::swap(low, high);
      }
      const auto [entry, is_first] =
          first_at_edge.try_emplace(std::uint64_t{v} << 32 | w, EdgeCorners{t, low, high});
      const EdgeCorners& other = entry->second;
      if (is_first || face_normals[t].dot(face_normals[other.triangle]) < cos_angle) continue;
      sets.unite(low, other.low);
      sets.unite(high, other.high);
    }
  return sets;
}

}  // namespace

CreasedMesh split_creases(const TriangleMesh& mesh, double angle) {
  std::vector<Vec3> face_normals;
  face_normals.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    face_normals.push_back((mesh.positions[t[1]] - mesh.positions[t[0]])
                               .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
                               .normalized());
  CornerSets sets = smooth_corners(mesh.triangles, face_normals, std::cos(angle));

  CreasedMesh out;
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> vertex_of(3 * mesh.triangles.size(), none);  // by the set's representative
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t& vertex = vertex_of[sets.find(3 * t + k)];
      if (vertex == none) {
        vertex = static_cast<std::uint32_t>(out.source.size());
        out.source.push_back(mesh.triangles[t][k]);
        out.positions.push_back(mesh.positions[mesh.triangles[t][k]].cast<float>());
      }
      triangle[k] = vertex;
    }
    out.triangles.push_back(triangle);
  }
  smooth_normals(out.positions, out.triangles, out.normals);
  return out;
}

}  // namespace prosector
