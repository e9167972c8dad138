#include "client/text/distance_field.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>

#include "common/math.h"

namespace prosector {
namespace {

using Point = Eigen::Vector2d;  // pixels of the em, y up

struct Segment {
  Point a, b;
};

/// An outline as straight segments, collected by FT_Outline_Decompose().
struct Pieces {
  std::vector<Segment> segments;
  Point at = Point::Zero();

  void line_to(const Point& to) {
    if (to != at) segments.push_back({at, to});
    at = to;
  }
};

Point point_of(const FT_Vector* v) {
  return Point(static_cast<double>(v->x), static_cast<double>(v->y)) / 64;
}

Pieces& pieces_of(void* user) {
  return *static_cast<Pieces*>(user);
}

int move_to(const FT_Vector* to, void* user) {
  pieces_of(user).at = point_of(to);
  return 0;
}

int line_to(const FT_Vector* to, void* user) {
  pieces_of(user).line_to(point_of(to));
  return 0;
}

// Segments per curve: at this em size the error is below a tenth of a pixel.
constexpr int conic_segments = 8, cubic_segments = 12;

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  const Point from = pieces_of(user).at, by = point_of(control), end = point_of(to);
  for (int k = 1; k <= conic_segments; ++k) {
    const double t = static_cast<double>(k) / conic_segments, s = 1 - t;
    pieces_of(user).line_to(s * s * from + 2 * s * t * by + t * t * end);
  }
  return 0;
}

int cubic_to(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
  const Point from = pieces_of(user).at, p = point_of(first), q = point_of(second), end = point_of(to);
  for (int k = 1; k <= cubic_segments; ++k) {
    const double t = static_cast<double>(k) / cubic_segments, s = 1 - t;
    pieces_of(user).line_to(s * s * s * from + 3 * s * s * t * p + 3 * s * t * t * q + t * t * t * end);
  }
  return 0;
}

double squared_distance(const Segment& segment, const Point& from) {
  const Point along = segment.b - segment.a, way = from - segment.a;
  const double share = std::clamp(way.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (way - share * along).squaredNorm();
}

/// Squared distances of pixels from the segments, within the image's reach.
class Field {
 public:
  Field(int left, int top, int width, int height)
      : left_(left),
        top_(top),
        width_(width),
        height_(height),
        squared_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                 distance_reach * distance_reach) {}

  void add(const Segment& segment) {
    const Point low = segment.a.cwiseMin(segment.b), high = segment.a.cwiseMax(segment.b);
    const int first_x = std::max(static_cast<int>(low.x()) - distance_reach - left_ - 1, 0);
    const int last_x = std::min(static_cast<int>(high.x()) + distance_reach - left_ + 1, width_ - 1);
    const int first_y = std::max(top_ - static_cast<int>(high.y()) - distance_reach - 2, 0);
    const int last_y = std::min(top_ - static_cast<int>(low.y()) + distance_reach + 1, height_ - 1);
    for (int y = first_y; y <= last_y; ++y)
      for (int x = first_x; x <= last_x; ++x) {
        double& best = squared_[index(x, y)];
        best = std::min(best, squared_distance(segment, {left_ + x + 0.5, top_ - y - 0.5}));
      }
  }

  /// Returns the signed distances. A pixel is inside if its coverage is more than half.
  std::vector<std::uint8_t> pixels(const FT_Bitmap& coverage, int inset) const {
    std::vector<std::uint8_t> out(squared_.size());
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const int column = x - inset, row = y - inset;
        const bool there = column >= 0 && row >= 0 && column < static_cast<int>(coverage.width) &&
                           row < static_cast<int>(coverage.rows);
        const bool inside = there && coverage.buffer[row * coverage.pitch + column] > 127;
        const double away = std::sqrt(squared_[index(x, y)]) * 127 / distance_reach;
        out[index(x, y)] = static_cast<std::uint8_t>(std::lround(inside ? 128 + away : 128 - away));
      }
    return out;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int left_, top_, width_, height_;
  std::vector<double> squared_;
};

}  // namespace

GlyphImage distance_field(FT_GlyphSlotRec_* slot) {
  if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return {};
  Pieces pieces;
  const FT_Outline_Funcs take = {move_to, line_to, conic_to, cubic_to, 0, 0};
  if (FT_Outline_Decompose(&slot->outline, &take, &pieces) != 0) return {};
  if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0 || slot->bitmap.width == 0) return {};
  GlyphImage image{static_cast<int>(slot->bitmap.width) + 2 * distance_reach,
                   static_cast<int>(slot->bitmap.rows) + 2 * distance_reach,
                   slot->bitmap_left - distance_reach,
                   slot->bitmap_top + distance_reach,
                   {}};
  Field field(image.left, image.top, image.width, image.height);
  for (const Segment& segment : pieces.segments) field.add(segment);
  image.pixels = field.pixels(slot->bitmap, distance_reach);
  return image;
}

}  // namespace prosector
