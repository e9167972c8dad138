#include "common/anatomy/mesh_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace prosector {
namespace {

using Face = std::array<std::uint32_t, 3>;

// Faces opposite node 0..3, counter-clockwise from outside if the tetrahedron's volume is positive.
constexpr std::array<std::array<std::size_t, 3>, 4> face_nodes = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

struct FaceOfTet {
  Face key;  // sorted
  Face face;
  std::uint32_t tet;
};

std::vector<FaceOfTet> sorted_faces(const TetMesh& mesh) {
  std::vector<FaceOfTet> faces;
  faces.reserve(4 * mesh.tets.size());
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t)
    for (const auto& local : face_nodes) {
      FaceOfTet f{.key = {}, .face = {}, .tet = t};
      for (std::size_t k = 0; k < 3; ++k) f.face[k] = mesh.tets[t][local[k]];
      f.key = f.face;
      std::sort(f.key.begin(), f.key.end());
      faces.push_back(f);
    }
  std::sort(faces.begin(), faces.end(), [](const FaceOfTet& a, const FaceOfTet& b) {
    return a.key != b.key ? a.key < b.key : a.tet < b.tet;
  });
  return faces;
}

}  // namespace

double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).dot((c - a).cross(d - a)) / 6;
}

std::vector<Face> boundary_faces(const TetMesh& mesh) {
  const auto faces = sorted_faces(mesh);
  std::vector<Face> out;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].key == faces[i].key) ++end;
    if (end == i + 1) out.push_back(faces[i].face);
    i = end;
  }
  return out;
}

std::vector<std::uint32_t> tet_components(const TetMesh& mesh) {
  std::vector<std::uint32_t> root(mesh.tets.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  const auto faces = sorted_faces(mesh);
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].key == faces[i - 1].key) root[find(faces[i].tet)] = find(faces[i - 1].tet);
  std::vector<std::uint32_t> number(mesh.tets.size(), UINT32_MAX), out(mesh.tets.size());
  std::uint32_t next = 0;
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
    const std::uint32_t r = find(t);
    if (number[r] == UINT32_MAX) number[r] = next++;
    out[t] = number[r];
  }
  return out;
}

TetMesh subset(const TetMesh& mesh, const std::vector<bool>& keep) {
  TetMesh out;
  std::vector<std::uint32_t> number(mesh.positions.size(), UINT32_MAX);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!keep[t]) continue;
    auto tet = mesh.tets[t];
    for (auto& node : tet) {
      if (number[node] == UINT32_MAX) {
        number[node] = static_cast<std::uint32_t>(out.positions.size());
        out.positions.push_back(mesh.positions[node]);
      }
      node = number[node];
    }
    out.tets.push_back(tet);
  }
  return out;
}

std::size_t non_manifold_edges(const std::vector<Face>& triangles) {
  struct Edge {
    std::uint32_t a, b;
    int direction;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Face& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      edges.push_back(a < b ? Edge{a, b, 1} : Edge{b, a, -1});
    }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& x, const Edge& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  std::size_t bad = 0;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    int sum = 0;
    while (end < edges.size() && edges[end].a == edges[i].a && edges[end].b == edges[i].b)
      sum += edges[end++].direction;
    if (end - i != 2 || sum != 0) ++bad;
    i = end;
  }
  return bad;
}

DihedralRange dihedral_range(const std::array<Vec3, 4>& x) {
  DihedralRange out;
  std::array<Vec3, 4> normal;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& n = face_nodes[f];
    normal[f] = (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]).normalized();
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double angle =
          std::acos(std::clamp(-normal[i].dot(normal[j]), -1.0, 1.0)) * 180 / std::numbers::pi;
      out.least_deg = std::min(out.least_deg, angle);
      out.most_deg = std::max(out.most_deg, angle);
    }
  return out;
}

TetQuality tet_quality(const TetMesh& mesh) {
  TetQuality q;
  q.nodes = mesh.positions.size();
  q.tets = mesh.tets.size();
  for (const auto& tet : mesh.tets) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = mesh.positions[tet[k]];
    q.volume += tet_volume(x[0], x[1], x[2], x[3]);
    const DihedralRange angles = dihedral_range(x);
    q.min_dihedral_deg = std::min(q.min_dihedral_deg, angles.least_deg);
    q.max_dihedral_deg = std::max(q.max_dihedral_deg, angles.most_deg);
  }
  q.non_manifold_edges = non_manifold_edges(boundary_faces(mesh));
  for (const std::uint32_t c : tet_components(mesh))
    q.components = std::max<std::size_t>(q.components, c + 1);
  return q;
}

std::string describe(const TetQuality& q) {
  return fmt::format(
      "{} tets, {} nodes, {:.4g} ml, dihedral angles {:.1f} to {:.1f} deg{}", q.tets, q.nodes, q.volume * 1e6,
      q.min_dihedral_deg, q.max_dihedral_deg,
      q.non_manifold_edges ? fmt::format(", {} non-manifold edges", q.non_manifold_edges) : "");
}

}  // namespace prosector
