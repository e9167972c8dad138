#include "client/view/cap.h"

#include <algorithm>
#include <array>

#include "common/rotation_between.h"

namespace prosector {
namespace {

// Pieces of a cap overlap by this length, so that no pixel falls between them.
constexpr double overlap = 1e-5;  // m

/// A non-horizontal segment of the outline, oriented upwards.
struct RisingEdge {
  OutlinePoint low, high;
  int winding;  // 1: the solid begins here, going from left to right; −1: it ends

  double share_at(double y) const {
    return std::clamp((y - low.at.y()) / (high.at.y() - low.at.y()), 0.0, 1.0);
  }
  double x_at(double y) const { return low.at.x() + share_at(y) * (high.at.x() - low.at.x()); }
};

/// The region filled from y upwards between two segments.
struct Span {
  std::size_t left, right;  // indices of rising edges
  double from;              // y, m
};

std::vector<RisingEdge> rising(const std::vector<OutlineEdge>& outline) {
  std::vector<RisingEdge> out;
  for (const OutlineEdge& edge : outline) {
    if (edge.from.at.y() < edge.to.at.y()) out.push_back({edge.from, edge.to, -1});
    if (edge.from.at.y() > edge.to.at.y()) out.push_back({edge.to, edge.from, 1});
  }
  std::ranges::sort(out, {}, [](const RisingEdge& e) { return e.low.at.y(); });
  return out;
}

std::vector<double> levels_of(const std::vector<RisingEdge>& edges) {
  std::vector<double> out;
  for (const RisingEdge& edge : edges) out.insert(out.end(), {edge.low.at.y(), edge.high.at.y()});
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Returns the spans that a horizontal line at y crosses; `active`: the edges that it crosses.
std::vector<Span> spans_at(double y, const std::vector<RisingEdge>& edges, std::vector<std::size_t>& active) {
  std::ranges::sort(active, {}, [&](std::size_t e) { return edges[e].x_at(y); });
  std::vector<Span> out;
  int winding = 0;
  std::size_t left = 0;
  for (const std::size_t e : active) {
    const int before = winding;
    winding += edges[e].winding;
    if (before <= 0 && winding > 0) left = e;
    if (before > 0 && winding <= 0) out.push_back({left, e, y});
  }
  if (winding != 0) out.clear();  // the outline has a gap here
  return out;
}

OutlinePoint point_at(const RisingEdge& edge, double y) {
  const double share = edge.share_at(y);
  return {{edge.x_at(y), y}, edge.low.rest + static_cast<float>(share) * (edge.high.rest - edge.low.rest)};
}

void close(const Span& span, double to, const std::vector<RisingEdge>& edges, Cap& cap) {
  const RisingEdge &left = edges[span.left], &right = edges[span.right];
  cap.area += 0.5 * (to - span.from) *
              (right.x_at(to) - left.x_at(to) + right.x_at(span.from) - left.x_at(span.from));
  const auto first = static_cast<std::uint32_t>(cap.corners.size());
  const double below = span.from - overlap, above = to + overlap;
  for (const OutlinePoint& p :
       {point_at(left, below), point_at(right, below), point_at(right, above), point_at(left, above)})
    cap.corners.push_back(p);
  cap.triangles.push_back({first, first + 1, first + 2});
  cap.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

Pose frame_of(const SectionPlane& section) {
  return {section.offset * section.normal, rotation_between(Vec3::UnitZ(), section.normal)};
}

void add_outline(const DrawItem& item, const SectionPlane& section, std::vector<OutlineEdge>& outline) {
  const DrawMesh& mesh = *item.mesh;
  const Pose into = frame_of(section).inverse();
  const Mat3 linear = item.shape.A * item.pose.q.toRotationMatrix();
  const bool mirrored = linear.determinant() < 0;
  std::vector<Vec3> places;  // in the plane's frame; z is the height over the plane
  places.reserve(mesh.positions.size());
  for (const auto& x : mesh.positions)
    places.push_back(into * (item.shape * (item.pose * x.cast<double>().eval())));
  const auto& rest = mesh.rest_positions.empty() ? mesh.positions : mesh.rest_positions;
  const auto crossing = [&](std::uint32_t above, std::uint32_t below) -> OutlinePoint {
    const double share = places[above].z() / (places[above].z() - places[below].z());
    return {(places[above] + share * (places[below] - places[above])).head<2>(),
            rest[above] + static_cast<float>(share) * (rest[below] - rest[above])};
  };
  for (const auto& t : mesh.triangles) {
    const std::array<bool, 3> above = {places[t[0]].z() > 0, places[t[1]].z() > 0, places[t[2]].z() > 0};
    if (above[0] == above[1] && above[1] == above[2]) continue;
    // The corner that is alone on its side of the plane.
    const std::size_t k = above[1] == above[2] ? 0 : above[0] == above[2] ? 1 : 2;
    const std::uint32_t alone = t[k], next = t[(k + 1) % 3], last = t[(k + 2) % 3];
    OutlineEdge edge = above[k] ? OutlineEdge{crossing(alone, next), crossing(alone, last)}
                                : OutlineEdge{crossing(last, alone), crossing(next, alone)};
    if (mirrored) std::swap(edge.from, edge.to);
    outline.push_back(edge);
  }
}

// Scanline fill. Horizontal lines through all corners divide the plane into strips, in which no edge ends.
// The area between the same two edges in consecutive strips is one piece.
Cap fill(const std::vector<OutlineEdge>& outline) {
  const std::vector<RisingEdge> edges = rising(outline);
  const std::vector<double> levels = levels_of(edges);
  Cap cap;
  std::vector<Span> open;
  std::vector<std::size_t> active;
  std::size_t next = 0;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const double low = levels[k], middle = 0.5 * (low + levels[k + 1]);
    std::erase_if(active, [&](std::size_t e) { return edges[e].high.at.y() <= low; });
    for (; next < edges.size() && edges[next].low.at.y() <= low; ++next) active.push_back(next);
    std::vector<Span> now = spans_at(middle, edges, active);
    for (const Span& span : open) {
      const auto same = std::ranges::find_if(
          now, [&](const Span& s) { return s.left == span.left && s.right == span.right; });
      same != now.end() ? void(same->from = span.from) : close(span, low, edges, cap);
    }
    for (Span& span : now)
      if (span.from == middle) span.from = low;
    open = std::move(now);
  }
  for (const Span& span : open) close(span, levels.back(), edges, cap);
  return cap;
}

}  // namespace prosector
