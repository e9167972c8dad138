#include "twins/camera/mesh_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosector {
namespace {

constexpr int cells_of_pixel = 3;       // cells per side of a pixel
constexpr float nearest_drawn = 0.02F;  // m
constexpr float nothing_met = std::numeric_limits<float>::infinity();

}  // namespace

MeshDepthBuffer::MeshDepthBuffer(int width, int height, const Eigen::Vector2d& low,
                                 const Eigen::Vector2d& high)
    : width_(width),
      height_(height),
      low_(low.cast<float>()),
      cells_(static_cast<float>(width / (high.x() - low.x())),
             static_cast<float>(height / (high.y() - low.y()))),
      hits_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  clear();
}

MeshDepthBuffer::MeshDepthBuffer(const Lens& lens)
    : MeshDepthBuffer(
          cells_of_pixel * lens.width, cells_of_pixel * lens.height, lens.ray({-1, -1}).head<2>(),
          lens.ray({static_cast<double>(lens.width), static_cast<double>(lens.height)}).head<2>()) {}

void MeshDepthBuffer::clear() {
  std::fill(hits_.begin(), hits_.end(), Hit{{}, nothing_met});
}

void MeshDepthBuffer::draw(const ShadedMesh& mesh, const Pose& camera_mesh, const Lamp& lamp) {
  const Eigen::Matrix3f turn = camera_mesh.q.toRotationMatrix().cast<float>();
  const Eigen::Vector3f shift = camera_mesh.p.cast<float>(), towards = lamp.towards.cast<float>();
  const auto ambient = static_cast<float>(lamp.ambient);
  std::vector<Corner> corners(mesh.positions.size());
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const Eigen::Vector3f x = turn * mesh.positions[v] + shift;
    const float inverse = 1 / std::max(x.z(), 1e-6F);
    const Eigen::Vector2f cell = (x.head<2>() * inverse - low_).cwiseProduct(cells_);
    const float lit = ambient + (1 - ambient) * std::max(towards.dot(turn * mesh.normals[v]), 0.F);
    corners[v].at = {cell.x(), cell.y(), x.z() < nearest_drawn ? nothing_met : inverse};
    for (std::size_t c = 0; c < 3; ++c) corners[v].light[c] = lit * mesh.paint[v][c];
  }
  for (const auto& t : mesh.triangles) {
    const std::array<const Corner*, 3> three = {&corners[t[0]], &corners[t[1]], &corners[t[2]]};
    if (std::all_of(three.begin(), three.end(), [](const Corner* c) { return std::isfinite(c->at.z()); }))
      fill(three);
  }
}

/// Fills the cells whose centres are inside a triangle and in front of their present content. Back faces are
/// culled.
void MeshDepthBuffer::fill(const std::array<const Corner*, 3>& corners) {
  const Eigen::Vector2f a = corners[0]->at.head<2>(), b = corners[1]->at.head<2>(),
                        c = corners[2]->at.head<2>();
  const auto cross = [](const Eigen::Vector2f& u, const Eigen::Vector2f& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const float area = cross(b - a, c - a);
  if (!(area < 0)) return;  // y points down, so front faces have negative area
  const auto first = [](float low, float p, float q) {
    return static_cast<int>(std::clamp(std::floor(std::min({low, p, q})), 0.F, 1e6F));
  };
  const auto last = [](float high, float p, float q, int most) {
    return static_cast<int>(
        std::clamp(std::ceil(std::max({high, p, q})), -1.F, static_cast<float>(most - 1)));
  };
  const int right = last(a.x(), b.x(), c.x(), width_), bottom = last(a.y(), b.y(), c.y(), height_);
  for (int y = first(a.y(), b.y(), c.y()); y <= bottom; ++y)
    for (int x = first(a.x(), b.x(), c.x()); x <= right; ++x) {
      const Eigen::Vector2f p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      const Eigen::Vector3f share(cross(b - p, c - p) / area, cross(c - p, a - p) / area,
                                  cross(a - p, b - p) / area);
      if (share.minCoeff() < 0) continue;
      const Eigen::Vector3f inverse(share.x() * corners[0]->at.z(), share.y() * corners[1]->at.z(),
                                    share.z() * corners[2]->at.z());
      const float depth = 1 / inverse.sum();
      Hit& hit =
          hits_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
      if (depth >= hit.depth) continue;
      hit.depth = depth;
      for (std::size_t k = 0; k < 3; ++k)
        hit.light[k] = depth * (inverse.x() * corners[0]->light[k] + inverse.y() * corners[1]->light[k] +
                                inverse.z() * corners[2]->light[k]);
    }
}

MeshDepthBuffer::Hit MeshDepthBuffer::at(const Eigen::Vector2f& direction) const {
  const Eigen::Vector2f cell = (direction - low_).cwiseProduct(cells_);
  if (!(cell.minCoeff() >= 0) || !(cell.x() < static_cast<float>(width_)) ||
      !(cell.y() < static_cast<float>(height_)))
    return {{}, nothing_met};
  return hits_[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(cell.x())];
}

}  // namespace prosector
