#include "common/anatomy/embedding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosector {
namespace {

using Weights = Eigen::Vector4d;

/// Tetrahedra by the cells of a uniform grid that their bounding boxes overlap.
class TetGrid {
 public:
  explicit TetGrid(const TetMesh& mesh) : mesh_(mesh) {
    min_ = max_ = mesh.positions.front();
    for (const Vec3& x : mesh.positions) {
      min_ = min_.cwiseMin(x);
      max_ = max_.cwiseMax(x);
    }
    const Vec3 extent = (max_ - min_).cwiseMax(1e-9);
    step_ = std::max(std::cbrt(extent.prod() / static_cast<double>(mesh.tets.size())) * 1.5,
                     extent.maxCoeff() / 200);
    for (int k = 0; k < 3; ++k) n_[k] = static_cast<int>(extent[k] / step_) + 1;
    cells_.resize(static_cast<std::size_t>(n_.prod()));
    for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
      Vec3 low = mesh.positions[mesh.tets[t][0]], high = low;
      for (const auto v : mesh.tets[t]) {
        low = low.cwiseMin(mesh.positions[v]);
        high = high.cwiseMax(mesh.positions[v]);
      }
      const Eigen::Vector3i a = cell(low), b = cell(high);
      for (int z = a[2]; z <= b[2]; ++z)
        for (int y = a[1]; y <= b[1]; ++y)
          for (int x = a[0]; x <= b[0]; ++x) cells_[number({x, y, z})].push_back(t);
    }
  }

  Weights weights(std::uint32_t t, const Vec3& x) const {
    const auto& tet = mesh_.tets[t];
    const Vec3& o = mesh_.positions[tet[0]];
    Mat3 edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = mesh_.positions[tet[static_cast<std::size_t>(k) + 1]] - o;
    const Vec3 b = edges.inverse() * (x - o);
    return {1 - b.sum(), b[0], b[1], b[2]};
  }

  /// Returns the tetrahedron that contains x most deeply, or the one whose clamped barycentric point is
  /// nearest.
  std::uint32_t nearest(const Vec3& x) const {
    std::uint32_t best = 0;
    double best_distance = std::numeric_limits<double>::max(), best_inner = -1;
    const Eigen::Vector3i home = cell(x);
    for (int ring = 0; ring <= n_.maxCoeff(); ++ring) {
      // Tetrahedra found only in this ring of cells are at least (ring − 1) steps away. This also holds for x
      // outside the grid: clamping x into the box reduces its distance to everything in the box.
      if ((ring - 1) * step_ > best_distance || best_inner >= 0) break;
      visit_ring(home, ring, [&](std::uint32_t t) {
        const Weights w = weights(t, x);
        if (w.minCoeff() > best_inner && w.minCoeff() >= 0) {
          best_inner = w.minCoeff();
          best_distance = 0;
          best = t;
        } else if (best_inner < 0) {
          const double d = (point(t, clamped_weights(w)) - x).norm();
          if (d < best_distance) {
            best_distance = d;
            best = t;
          }
        }
      });
    }
    return best;
  }

  static Weights clamped_weights(const Weights& w) {
    const Weights positive = w.cwiseMax(0);
    return positive / positive.sum();
  }

  Vec3 point(std::uint32_t t, const Weights& w) const {
    Vec3 x = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) x += w[static_cast<int>(k)] * mesh_.positions[mesh_.tets[t][k]];
    return x;
  }

 private:
  Eigen::Vector3i cell(const Vec3& x) const {
    Eigen::Vector3i i;
    for (int k = 0; k < 3; ++k)
      i[k] = static_cast<int>(std::clamp((x[k] - min_[k]) / step_, 0.0, static_cast<double>(n_[k] - 1)));
    return i;
  }
  std::size_t number(const Eigen::Vector3i& i) const {
    return static_cast<std::size_t>(i[0] + n_[0] * (i[1] + n_[1] * i[2]));
  }
  template <class Visit>
  void visit_ring(const Eigen::Vector3i& home, int ring, Visit&& visit) const {
    const Eigen::Vector3i low = (home.array() - ring).max(0),
                          high = (home.array() + ring).min(n_.array() - 1);
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) {
          const Eigen::Vector3i i(x, y, z);
          if ((i - home).cwiseAbs().maxCoeff() != ring) continue;
          for (const auto t : cells_[number(i)]) visit(t);
        }
  }

  const TetMesh& mesh_;
  Vec3 min_, max_;
  double step_ = 0;
  Eigen::Vector3i n_ = Eigen::Vector3i::Zero();
  std::vector<std::vector<std::uint32_t>> cells_;
};

// Moves the weights towards the tetrahedron's nearest point until no weight exceeds the limit.
Weights bounded(const Weights& w) {
  if (w.cwiseAbs().maxCoeff() <= max_embedding_weight) return w;
  const Weights in = TetGrid::clamped_weights(w);
  double keep = 1;
  for (int k = 0; k < 4; ++k) {
    const double change = std::abs(w[k] - in[k]);
    const double room = max_embedding_weight - std::abs(in[k]);
    if (change > room) keep = std::min(keep, room / change);
  }
  return in + keep * (w - in);
}

}  // namespace

void apply_embedding(Anatomy& anatomy) {
  if (anatomy.tets.positions.empty()) return;
  for (std::size_t i = 0; i < anatomy.embedding.rows.size(); ++i)
    anatomy.surface.positions[i] = anatomy.embedding.apply(i, anatomy.tets.positions.front().data());
}

Embedding embed(TetMesh tets, TriangleMesh surface) {
  Embedding out;
  const TetGrid grid(tets);
  out.anatomy.embedding.rows.reserve(surface.positions.size());
  for (const Vec3& x : surface.positions) {
    const std::uint32_t t = grid.nearest(x);
    const Weights w = grid.weights(t, x);
    if (w.minCoeff() < -1e-9) ++out.outside;
    const Weights kept = bounded(w);
    if (kept != w) {
      ++out.drawn_in;
      out.farthest = std::max(out.farthest, (grid.point(t, kept) - x).norm());
    }
    SparseMap::Row row;
    for (std::size_t k = 0; k < 4; ++k) {
      row.node[k] = tets.tets[t][k];
      row.weight[k] = kept[static_cast<int>(k)];
    }
    out.anatomy.embedding.rows.push_back(row);
  }
  out.anatomy.tets = std::move(tets);
  out.anatomy.surface = std::move(surface);
  apply_embedding(out.anatomy);
  return out;
}

}  // namespace prosector
