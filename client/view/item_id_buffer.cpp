#include "client/view/item_id_buffer.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

/// A vertex in cells of the map, and its nearness; 0: not in front of the eye.
using Projected = Eigen::Vector3f;

bool hides(const DrawItem& item) {
  return item.mesh && !item.shaft && item.opacity >= solid_opacity &&
         item.appearance.surface != Surface::glass;
}

class Mapper {
 public:
  Mapper(ItemIdBuffer& map, const DrawCamera& camera) : map_(map), camera_(camera) {}

  void add(const DrawItem& item, std::int32_t index) {
    project(item);
    const bool mirrored = item.shape.A.determinant() < 0;
    const Triangles& triangles = triangles_of(item);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const Projected& a = projected_[triangles[t][0]];
      const Projected& b = projected_[triangles[t][mirrored ? 2 : 1]];
      const Projected& c = projected_[triangles[t][mirrored ? 1 : 2]];
      if (a.z() > 0 && b.z() > 0 && c.z() > 0) fill(a, b, c, index, t);
    }
  }

 private:
  ItemIdBuffer& map_;
  const DrawCamera& camera_;
  std::vector<Projected> projected_;

  void project(const DrawItem& item) {
    const Eigen::Matrix3d into_eye = camera_.pose.q.toRotationMatrix().transpose();
    const Eigen::Matrix3d linear = into_eye * item.shape.A * item.pose.q.toRotationMatrix();
    const Vec3 offset = into_eye * (item.shape * item.pose.p - camera_.pose.p);
    const Eigen::Matrix3f A = linear.cast<float>();
    const Eigen::Vector3f p = offset.cast<float>();
    const auto left = static_cast<float>(camera_.left), top = static_cast<float>(camera_.top);
    const auto across = static_cast<float>(map_.width / (camera_.right - camera_.left));
    const auto down = static_cast<float>(map_.height / (camera_.top - camera_.bottom));
    const auto near = static_cast<float>(camera_.near);
    projected_.resize(item.mesh->positions.size());
    for (std::size_t v = 0; v < projected_.size(); ++v) {
      const Eigen::Vector3f x = A * item.mesh->positions[v] + p;
      const float nearness = -x.z() > near ? -1 / x.z() : 0;
      projected_[v] = {(x.x() * nearness - left) * across, (top - x.y() * nearness) * down, nearness};
    }
  }

  /// Rasterises a front-facing triangle: fills the cells with their centres in it.
  void fill(const Projected& a, const Projected& b, const Projected& c, std::int32_t item, std::uint32_t t) {
    const float area = (b.x() - a.x()) * (a.y() - c.y()) - (a.y() - b.y()) * (c.x() - a.x());
    if (!(area > 0)) return;
    const auto first = [](float low) {
      return std::max(static_cast<int>(std::ceil(std::max(low, 0.F) - 0.5F)), 0);
    };
    const auto last = [](float high, int count) {
      return std::min(static_cast<int>(std::floor(std::min(high, static_cast<float>(count)) - 0.5F)),
                      count - 1);
    };
    const int left = first(std::min({a.x(), b.x(), c.x()})), top = first(std::min({a.y(), b.y(), c.y()}));
    const int right = last(std::max({a.x(), b.x(), c.x()}), map_.width);
    const int bottom = last(std::max({a.y(), b.y(), c.y()}), map_.height);
    const auto side = [](const Projected& p, const Projected& q, float x, float y) {
      return (q.x() - p.x()) * (p.y() - y) - (p.y() - q.y()) * (x - p.x());
    };
    for (int row = top; row <= bottom; ++row)
      for (int column = left; column <= right; ++column) {
        const float x = static_cast<float>(column) + 0.5F, y = static_cast<float>(row) + 0.5F;
        const float of_a = side(b, c, x, y), of_b = side(c, a, x, y), of_c = side(a, b, x, y);
        if (of_a < 0 || of_b < 0 || of_c < 0) continue;
        const float nearness = (of_a * a.z() + of_b * b.z() + of_c * c.z()) / area;
        ItemIdBuffer::Cell& cell =
            map_.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.width) +
                       static_cast<std::size_t>(column)];
        if (nearness > cell.nearness) cell = {nearness, item, t};
      }
  }
};

}  // namespace

ItemIdBuffer rasterize_items(const DrawList& list, const DrawCamera& camera, int width, int height) {
  ItemIdBuffer map{width, height, {}};
  map.cells.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Mapper mapper(map, camera);
  for (std::size_t k = 0; k < list.items.size(); ++k)
    if (hides(list.items[k])) mapper.add(list.items[k], static_cast<std::int32_t>(k));
  return map;
}

}  // namespace prosector
