#include "common/anatomy/surface_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include "common/anatomy/winding_tree.h"
#include "common/error.h"

namespace prosector {
namespace {

using Edge = std::array<std::uint32_t, 2>;  // of two vertices, the smaller index first

Edge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The point of a triangle nearest to a given point, and the feature that it is on.
struct Nearest {
  Vec3 at = Vec3::Zero();
  int corners = 3;  // 3: in the face, 2: on the edge from corner `first` to the next, 1: at corner `first`
  std::size_t first = 0;
};

/// Finds the nearest point of a triangle (Ericson 2005, 5.1.5).
Nearest nearest_point_on_triangle(const std::array<Vec3, 3>& t, const Vec3& x) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0];
  const Vec3 from_a = x - t[0], from_b = x - t[1], from_c = x - t[2];
  const double d1 = ab.dot(from_a), d2 = ac.dot(from_a), d3 = ab.dot(from_b), d4 = ac.dot(from_b),
               d5 = ab.dot(from_c), d6 = ac.dot(from_c);
  if (d1 <= 0 && d2 <= 0) return {t[0], 1, 0};
  if (d3 >= 0 && d4 <= d3) return {t[1], 1, 1};
  if (d6 >= 0 && d5 <= d6) return {t[2], 1, 2};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {t[0] + d1 / (d1 - d3) * ab, 2, 0};
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return {t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]), 2, 1};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {t[0] + d2 / (d2 - d6) * ac, 2, 2};
  return {t[0] + (vb * ab + vc * ac) / (va + vb + vc), 3, 0};
}

/// Signed distances to a closed surface, by a bounding-box tree over its triangles.
class DistanceTree {
 public:
  explicit DistanceTree(TriangleMesh surface)
      : surface_(std::move(surface)), order_(surface_.triangles.size()) {
    add_normals();
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(2 * order_.size());
    grow(0, order_.size());
  }

  double operator()(const Vec3& x) const {
    Nearest best;
    std::uint32_t triangle = 0;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (node.box.squaredExteriorDistance(x) >= least) continue;
      for (std::size_t i = node.begin; i < node.end; ++i) {
        const Nearest here = nearest_point_on_triangle(corners(order_[i]), x);
        if (const double d = (x - here.at).squaredNorm(); d < least)
          least = d, best = here, triangle = order_[i];
      }
      if (node.begin < node.end) continue;
      const auto self = static_cast<std::uint32_t>(&node - nodes_.data());
      const bool left_first =
          nodes_[self + 1].box.squaredExteriorDistance(x) < nodes_[node.right].box.squaredExteriorDistance(x);
      open.push_back(left_first ? node.right : self + 1);
      open.push_back(left_first ? self + 1 : node.right);
    }
    const bool inside = (x - best.at).dot(normal(triangle, best)) < 0;
    return inside ? -std::sqrt(least) : std::sqrt(least);
  }

  Eigen::AlignedBox3d box() const { return nodes_.front().box; }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::size_t begin = 0, end = 0;  // range in order_, leaves only; both 0: an inner node
    std::uint32_t right = 0;         // index of the right child; the left one is the next node
  };
  static constexpr std::size_t leaf_size = 4;

  std::array<Vec3, 3> corners(std::uint32_t triangle) const {
    const auto& t = surface_.triangles[triangle];
    return {surface_.positions[t[0]], surface_.positions[t[1]], surface_.positions[t[2]]};
  }

  void add_normals() {
    at_vertex_.assign(surface_.positions.size(), Vec3::Zero());
    for (std::uint32_t i = 0; i < surface_.triangles.size(); ++i) {
      const auto& t = surface_.triangles[i];
      const std::array<Vec3, 3> x = corners(i);
      const Vec3 n = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
      at_face_.push_back(n);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 a = (x[(k + 1) % 3] - x[k]).normalized(), b = (x[(k + 2) % 3] - x[k]).normalized();
        at_vertex_[t[k]] += std::acos(std::clamp(a.dot(b), -1., 1.)) * n;
        at_edge_.try_emplace(edge_of(t[k], t[(k + 1) % 3]), Vec3::Zero()).first->second += n;
      }
    }
  }

  const Vec3& normal(std::uint32_t triangle, const Nearest& nearest) const {
    const auto& t = surface_.triangles[triangle];
    if (nearest.corners == 3) return at_face_[triangle];
    if (nearest.corners == 1) return at_vertex_[t[nearest.first]];
    return at_edge_.at(edge_of(t[nearest.first], t[(nearest.first + 1) % 3]));
  }

  std::uint32_t grow(std::size_t begin, std::size_t end) {
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Eigen::AlignedBox3d box, middles;
    for (std::size_t i = begin; i < end; ++i) {
      const std::array<Vec3, 3> x = corners(order_[i]);
      for (const Vec3& corner : x) box.extend(corner);
      middles.extend(middle(order_[i]));
    }
    nodes_[self].box = box;
    if (end - begin <= leaf_size) {
      nodes_[self].begin = begin;
      nodes_[self].end = end;
      return self;
    }
    int axis = 0;
    middles.sizes().maxCoeff(&axis);
    const std::size_t half = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(half), at(end),
                     [&](std::uint32_t a, std::uint32_t b) { return middle(a)[axis] < middle(b)[axis]; });
    grow(begin, half);
    const std::uint32_t right = grow(half, end);
    nodes_[self].right = right;
    return self;
  }

  Vec3 middle(std::uint32_t triangle) const {
    const std::array<Vec3, 3> x = corners(triangle);
    return (x[0] + x[1] + x[2]) / 3;
  }

  TriangleMesh surface_;
  std::vector<std::uint32_t> order_;  // triangle indices, leaf by leaf
  std::vector<Node> nodes_;
  std::vector<Vec3> at_face_, at_vertex_;
  std::map<Edge, Vec3> at_edge_;
};

}  // namespace

std::string SurfaceFaults::in_words() const {
  std::string out;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, what);
  };
  add(hole_edges, "edges at the borders of holes");
  add(crowded_edges, "edges with more than two triangles (not manifold)");
  add(opposed_edges, "edges between triangles of opposite orientation");
  return fmt::format(
      "not closed: {}; the first is near [{:.4g}, {:.4g}, {:.4g}]. Close the surface in a mesh editor; as a "
      "[[rigid]] body it may be open",
      out, first[0], first[1], first[2]);
}

SurfaceFaults surface_faults(const TriangleMesh& surface) {
  std::map<Edge, std::array<std::size_t, 2>> uses;  // number of triangles along the edge, and against it
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      ++uses[edge_of(a, b)][a < b ? 0 : 1];
    }
  SurfaceFaults out;
  for (const auto& [edge, use] : uses) {
    if (use[0] == use[1]) continue;  // also for more than two: several shells meet there
    if (!out) out.first = 0.5 * (surface.positions[edge[0]] + surface.positions[edge[1]]);
    const std::size_t triangles = use[0] + use[1];
    ++(triangles == 1 ? out.hole_edges : triangles == 2 ? out.opposed_edges : out.crowded_edges);
  }
  return out;
}

double enclosed_volume(const TriangleMesh& surface) {
  double six_times = 0;
  const Vec3 from = surface.positions.empty() ? Vec3::Zero() : surface.positions.front();
  for (const auto& t : surface.triangles)
    six_times += (surface.positions[t[0]] - from)
                     .dot((surface.positions[t[1]] - from).cross(surface.positions[t[2]] - from));
  return six_times / 6;
}

SolidField solid_within(TriangleMesh surface, Sign sign) {
  if (const SurfaceFaults faults = surface_faults(surface)) throw InputError(faults.in_words());
  if (enclosed_volume(surface) < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  const auto winding = sign == Sign::winding ? std::make_shared<const WindingTree>(surface) : nullptr;
  const auto tree = std::make_shared<const DistanceTree>(std::move(surface));
  const Box box{tree->box().min(), tree->box().max()};
  if (!winding) return {[tree](const Vec3& x) { return (*tree)(x); }, box};
  return {[tree, winding](const Vec3& x) {
            // Not zero at walls inside the solid, which aren't its border.
            const double distance = std::max(std::abs((*tree)(x)), std::numeric_limits<double>::min());
            return winding->at(x) > 0.5 ? -distance : distance;
          },
          box};
}

}  // namespace prosector
