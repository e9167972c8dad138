#include "tests/client/cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "client/render/text_layout.h"

namespace prosector::test {
namespace {

/// A corner as the camera sees it: m to the right, up, and ahead.
using Corner = Vec3;

/// Cuts a polygon off at a depth ahead of the eye.
std::vector<Corner> ahead_of(const std::vector<Corner>& polygon, double depth) {
  std::vector<Corner> out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (a.z() >= depth) out.push_back(a);
    if ((a.z() >= depth) != (b.z() >= depth)) out.push_back(a + (depth - a.z()) / (b.z() - a.z()) * (b - a));
  }
  return out;
}

/// Tells whether the renderer leaves a triangle out that faces away from the eye: of the room, so that one
/// looks in from outside.
bool is_one_sided(const DrawItem& item) {
  const Surface surface = item.appearance.surface;
  return surface == Surface::floor || surface == Surface::wall || surface == Surface::ceiling;
}

bool faces_away(const Corner& a, const Corner& b, const Corner& c) {
  const Corner normal = Corner(b - a).cross(Corner(c - a));  // of a frame whose z is the other way round
  return normal.dot(a) < 0;
}

class Raster {
 public:
  Raster(const DrawCamera& camera, int longest) : camera_(camera) {
    const double scale = static_cast<double>(longest) / std::max(camera.width, camera.height);
    width_ = std::max(1, static_cast<int>(std::lround(scale * camera.width)));
    height_ = std::max(1, static_cast<int>(std::lround(scale * camera.height)));
  }

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }

  std::vector<Corner> corners_of(const DrawItem& item) const {
    const Pose eye = camera_.pose.inverse();
    std::vector<Corner> out;
    for (const auto& at : item.mesh->positions) {
      const Vec3 x = eye * (item.shape * (item.pose * at.cast<double>().eval()));
      out.emplace_back(x.x(), x.y(), -x.z());
    }
    return out;
  }

  /// Calls f(pixel, depth) for all that the item covers beyond the near plane.
  template <class F>
  void draw(const DrawItem& item, const F& f) const {
    const std::vector<Corner> corners = corners_of(item);
    const bool one_sided = is_one_sided(item);
    for (const auto& [a, b, c] : item.mesh->triangles) {
      if (one_sided && faces_away(corners[a], corners[b], corners[c])) continue;
      const std::vector<Corner> cut = ahead_of({corners[a], corners[b], corners[c]}, camera_.near);
      for (std::size_t k = 2; k < cut.size(); ++k) fill({on(cut[0]), on(cut[k - 1]), on(cut[k])}, f);
    }
  }

  /// Tells whether the near plane cuts the item open within the picture.
  bool is_cut_open(const DrawItem& item) const {
    const std::vector<Corner> corners = corners_of(item);
    const auto inside = [&](const Corner& x) {
      return x.x() > camera_.left * x.z() && x.x() < camera_.right * x.z() &&
             x.y() > camera_.bottom * x.z() && x.y() < camera_.top * x.z();
    };
    for (const auto& triangle : item.mesh->triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner &a = corners[triangle[k]], &b = corners[triangle[(k + 1) % 3]];
        if ((a.z() < camera_.near) == (b.z() < camera_.near)) continue;
        if (inside(a + (camera_.near - a.z()) / (b.z() - a.z()) * (b - a))) return true;
      }
    return false;
  }

 private:
  const DrawCamera& camera_;
  int width_ = 0, height_ = 0;

  /// Returns its place in the raster, pixels from the top left, and how far ahead it is.
  Vec3 on(const Corner& x) const {
    return {(x.x() / x.z() - camera_.left) / (camera_.right - camera_.left) * width_,
            (camera_.top - x.y() / x.z()) / (camera_.top - camera_.bottom) * height_, x.z()};
  }

  template <class F>
  void fill(const std::array<Vec3, 3>& t, const F& f) const {
    const auto cross = [](const Vec3& a, const Vec3& b, double x, double y) {
      return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
    };
    const double area = cross(t[0], t[1], t[2].x(), t[2].y());
    if (area == 0) return;
    const auto [left, right] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
    const auto [top, bottom] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
    for (int y = std::max(0, static_cast<int>(top)); y < std::min<double>(height_, bottom); ++y)
      for (int x = std::max(0, static_cast<int>(left)); x < std::min<double>(width_, right); ++x) {
        const double u = cross(t[1], t[2], x + 0.5, y + 0.5) / area,
                     v = cross(t[2], t[0], x + 0.5, y + 0.5) / area, w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        f(static_cast<std::size_t>(y * width_ + x), 1 / (u / t[0].z() + v / t[1].z() + w / t[2].z()));
      }
  }
};

/// Adds to `hidden` the pixels behind the grounds of texts.
void hide_by_texts(const DrawList& list, const Raster& raster, std::vector<char>& hidden) {
  static Typesetter typesetter;
  const DrawCamera& camera = list.cameras.front();
  const double scale = static_cast<double>(raster.width()) / camera.width;
  for (const PlacedText& text : place_texts(list, camera, typesetter)) {
    if (text.text->ground == TextGround::none) continue;
    const Eigen::Vector2d rim = list.scale * Eigen::Vector2d(ground_beside, ground_above);
    const Eigen::Vector2d low = scale * (text.origin - rim), high = scale * (text.origin + text.size + rim);
    for (int y = 0; y < raster.height(); ++y)
      for (int x = 0; x < raster.width(); ++x)
        if (x + 0.5 > low.x() && x + 0.5 < high.x() && y + 0.5 > low.y() && y + 0.5 < high.y())
          hidden[static_cast<std::size_t>(y * raster.width() + x)] = 1;
  }
}

}  // namespace

Cover cover_of(const DrawList& list, const CoverSubject& subject, int longest, AnatomyPixels* seen) {
  const DrawCamera& camera = list.cameras.front();
  const Raster raster(camera, longest);
  std::vector<double> depth(raster.size(), std::numeric_limits<double>::infinity());
  std::vector<char> anatomy(raster.size(), 0), texts(raster.size(), 0);
  for (const DrawItem& item : list.items) {
    if (!subject.bodies.contains(item.mesh->id) || item.shaft) continue;
    const bool counts = subject.anatomy.contains(item.mesh->id);
    raster.draw(item, [&](std::size_t pixel, double ahead) {
      if (ahead >= depth[pixel]) return;
      depth[pixel] = ahead;
      anatomy[pixel] = counts ? 1 : 0;
    });
  }
  Cover out;
  std::vector<double> through(raster.size(), 1), behind(raster.size(), 1);
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const DrawItem& item = list.items[k];
    if (subject.bodies.contains(item.mesh->id) || item.opacity <= 0) continue;
    if (raster.is_cut_open(item)) out.near.push_back(k);
    std::vector<char> covers(raster.size(), 0);
    raster.draw(item, [&](std::size_t pixel, double ahead) {
      if (ahead < depth[pixel]) covers[pixel] = 1;
    });
    for (std::size_t pixel = 0; pixel < covers.size(); ++pixel) {
      if (covers[pixel] == 0) continue;
      through[pixel] *= 1 - item.opacity;
      behind[pixel] = 0;
    }
  }
  hide_by_texts(list, raster, texts);
  for (std::size_t pixel = 0; pixel < anatomy.size(); ++pixel) {
    if (anatomy[pixel] == 0) continue;
    ++out.pixels;
    out.by_items += 1 - through[pixel];
    out.opaque += 1 - behind[pixel];
    if (texts[pixel] != 0) out.by_texts += through[pixel];
    if (seen == nullptr) continue;
    const double to_camera = static_cast<double>(camera.width) / raster.width();
    const auto width = static_cast<std::size_t>(raster.width());
    seen->push_back(to_camera * Eigen::Vector2d(static_cast<double>(pixel % width) + 0.5,
                                                static_cast<double>(pixel / width) + 0.5));
  }
  for (double* share : {&out.by_items, &out.opaque, &out.by_texts})
    *share /= static_cast<double>(std::max<std::size_t>(1, out.pixels));
  return out;
}

}  // namespace prosector::test
