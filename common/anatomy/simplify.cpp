#include "common/anatomy/simplify.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class Collapser {
 public:
  Collapser(TriangleMesh& mesh, double edge, const std::function<Vec3(const Vec3&)>& project)
      : mesh_(mesh), edge_(edge), project_(project), around_(mesh.positions.size()) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const auto v : mesh_.triangles[t]) around_[v].push_back(t);
  }

  /// Sweeps once over the short edges, shortest first. Returns the number of collapsed edges.
  std::size_t sweep();

 private:
  struct Candidate {
    double length;
    std::uint32_t a, b;
  };
  std::vector<std::uint32_t> neighbors(std::uint32_t v) const;
  bool try_collapse(std::uint32_t a, std::uint32_t b);
  bool keeps_shape(std::uint32_t moved, std::uint32_t other, const Vec3& target) const;
  Vec3 area_vector(const Triangle& t) const {
    const auto& x = mesh_.positions;
    return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
  }
  static bool dead(const Triangle& t) { return t[0] == t[1]; }

  TriangleMesh& mesh_;
  double edge_;
  const std::function<Vec3(const Vec3&)>& project_;
  std::vector<std::vector<std::uint32_t>> around_;
};

std::vector<std::uint32_t> Collapser::neighbors(std::uint32_t v) const {
  std::vector<std::uint32_t> out;
  for (const auto t : around_[v])
    for (const auto w : mesh_.triangles[t])
      if (w != v) out.push_back(w);
  std::sort(out.begin(), out.end());
  return out;
}

bool Collapser::keeps_shape(std::uint32_t moved, std::uint32_t other, const Vec3& target) const {
  for (const auto t : around_[moved]) {
    const Triangle& tri = mesh_.triangles[t];
    if (std::find(tri.begin(), tri.end(), other) != tri.end()) continue;
    std::array<Vec3, 3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = tri[k] == moved ? target : mesh_.positions[tri[k]];
    const Vec3 after = (x[1] - x[0]).cross(x[2] - x[0]), before = area_vector(tri);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (x[(k + 1) % 3] - x[k]).norm());
    constexpr double max_turn_cos = 0.5;
    if (longest > 1.6 * edge_) return false;
    if (!(after.dot(before) > max_turn_cos * after.norm() * before.norm())) return false;
    if (after.norm() < 0.1 * longest * longest) return false;
  }
  return true;
}

bool Collapser::try_collapse(std::uint32_t a, std::uint32_t b) {
  const auto na = neighbors(a), nb = neighbors(b);
  // At an inner vertex each neighbour occurs in exactly two triangles; border vertices are not moved.
  const auto closed = [](const std::vector<std::uint32_t>& n) {
    for (std::size_t i = 0; i < n.size(); i += 2)
      if (i + 1 >= n.size() || n[i] != n[i + 1] || (i + 2 < n.size() && n[i + 2] == n[i])) return false;
    return true;
  };
  if (!closed(na) || !closed(nb)) return false;
  std::vector<std::uint32_t> common;
  std::set_intersection(na.begin(), na.end(), nb.begin(), nb.end(), std::back_inserter(common));
  common.erase(std::unique(common.begin(), common.end()), common.end());
  if (common.size() != 2 || na.size() + nb.size() < 2 * 7) return false;

  Vec3 target = 0.5 * (mesh_.positions[a] + mesh_.positions[b]);
  if (project_) target = project_(target);
  if (!keeps_shape(a, b, target) || !keeps_shape(b, a, target)) return false;

  mesh_.positions[a] = target;
  for (const auto t : around_[b]) {
    Triangle& tri = mesh_.triangles[t];
    if (std::find(tri.begin(), tri.end(), a) != tri.end()) {
      for (const auto v : tri)
        if (v != b) std::erase(around_[v], t);
      tri = {0, 0, 0};
    } else {
      std::replace(tri.begin(), tri.end(), b, a);
      around_[a].push_back(t);
    }
  }
  around_[b].clear();
  return true;
}

std::size_t Collapser::sweep() {
  std::vector<Candidate> candidates;
  for (const Triangle& t : mesh_.triangles) {
    if (dead(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      const double length = (mesh_.positions[a] - mesh_.positions[b]).norm();
      if (a < b && length < edge_) candidates.push_back({length, a, b});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return x.length != y.length ? x.length < y.length : x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  // A vertex moves at most once per sweep, so that short edges are removed evenly.
  std::vector<bool> used(mesh_.positions.size());
  std::size_t count = 0;
  for (const Candidate& c : candidates) {
    if (used[c.a] || used[c.b] || around_[c.a].empty() || around_[c.b].empty()) continue;
    if (!try_collapse(c.a, c.b)) continue;
    used[c.a] = used[c.b] = true;
    ++count;
  }
  return count;
}

}  // namespace

void drop_unused(TriangleMesh& mesh) {
  std::erase_if(mesh.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[0] == t[2]; });
  std::vector<std::uint32_t> number(mesh.positions.size(), UINT32_MAX);
  std::vector<Vec3> positions;
  for (Triangle& t : mesh.triangles)
    for (auto& v : t) {
      if (number[v] == UINT32_MAX) {
        number[v] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(mesh.positions[v]);
      }
      v = number[v];
    }
  mesh.positions = std::move(positions);
}

TriangleMesh simplify(const TriangleMesh& mesh, double edge,
                      const std::function<Vec3(const Vec3&)>& project) {
  TriangleMesh out = mesh;
  Collapser collapser(out, edge, project);
  constexpr int max_sweeps = 30;
  for (int k = 0; k < max_sweeps && collapser.sweep() > 0; ++k) {
  }
  drop_unused(out);
  return out;
}

}  // namespace prosector
