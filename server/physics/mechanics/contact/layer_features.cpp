#include "server/physics/mechanics/contact/layer_features.h"

#include <cmath>
#include <limits>

namespace prosector::contact {
namespace {

constexpr double slack = 0.1;      // rad: tolerance of normal cones
constexpr double parallel = 0.98;  // least cosine of normals of parallel layers

Vec3 doubled_area(const collision::Triangle& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

/// Returns the mean normal of the layers if they are parallel at the points and n is across them; otherwise
/// n. All point from b to a.
Vec3 across(const LayerElement& a, const Vec3& on_a, const LayerElement& b, const Vec3& on_b, const Vec3& n) {
  const Vec3 of_a = a.of.normal_at(a.index, on_a, n), of_b = b.of.normal_at(b.index, on_b, n);
  const bool over = of_a.dot(of_b) > parallel && of_a.dot(n) > parallel;
  return over ? Vec3((of_a + of_b).normalized()) : n;
}

/// The point of the other element that corner k of `own` meets.
struct Landing {
  Vec3 weights;                                               // barycentric, of the other element
  Vec3 normal;                                                // unit, towards the corner
  double distance = std::numeric_limits<double>::infinity();  // m, along the normal
};

Landing land(const LayerElement& own, Eigen::Index k, const LayerElement& other, double limit) {
  const collision::Triangle& y = other.now;
  const Vec3& corner = own.now[static_cast<std::size_t>(k)];
  const Vec3 weights = collision::closest_weights(corner, y[0], y[1], y[2]),
             apart = corner - collision::at(y, weights);
  const double distance = apart.norm();
  if (!(distance <= limit) || !(distance > 0)) return {};
  const Vec3 n = apart / distance;
  if ((weights.array() > 0).all()) return {weights, n, distance};
  const Vec3 itself = Vec3::Unit(k);
  if (!other.of.crest_at(other.index, weights, n, slack)) return {};
  if (!other.of.level_at(other.index, weights, n, slack) && !own.of.crest_at(own.index, itself, -n, slack))
    return {};
  const Vec3 normal = across(own, itself, other, weights, n);
  return {weights, normal, normal.dot(apart)};
}

void add_corners(const LayerElement& a, const LayerElement& b, double limit, double thickness,
                 std::vector<LayerMeeting>& out) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (const Landing of_a = land(a, k, b, limit); of_a.distance <= limit)
      out.push_back({LayerMeet::corner_of_a, a.index, b.index, Vec3::Unit(k), of_a.weights, of_a.normal,
                     of_a.distance - thickness});
    const Landing of_b = land(b, k, a, limit);
    if (!(of_b.distance <= limit)) continue;
    LayerMeeting m{LayerMeet::corner_of_a,   b.index, a.index, Vec3::Unit(k), of_b.weights, of_b.normal,
                   of_b.distance - thickness};
    if (&a.of != &b.of) {
      m.kind = LayerMeet::corner_of_b;
      swap_sides(m);
    }
    out.push_back(m);
  }
}

Vec3 on_edge(std::size_t from, double share) {
  return (1 - share) * Vec3::Unit(static_cast<Eigen::Index>(from)) +
         share * Vec3::Unit(static_cast<Eigen::Index>((from + 1) % 3));
}

void add_edges(const LayerElement& a, const LayerElement& b, double limit, double thickness,
               std::vector<LayerMeeting>& out) {
  const auto inside = [](double share) { return share > 0 && share < 1; };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &p = a.now[i], d = a.now[(i + 1) % 3] - p;
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 &q = b.now[j], e = b.now[(j + 1) % 3] - q;
      const auto [s, t] = collision::closest_parameters(p, d, q, e);
      if (!inside(s) || !inside(t)) continue;
      const Vec3 apart = p + s * d - q - t * e;
      const double distance = apart.norm();
      if (!(distance <= limit) || !(distance > 0)) continue;
      const Vec3 n = apart / distance, on_a = on_edge(i, s), on_b = on_edge(j, t);
      if (!a.of.crest_at(a.index, on_a, -n, slack) || !b.of.crest_at(b.index, on_b, n, slack)) continue;
      const Vec3 normal = across(a, on_a, b, on_b, n);
      out.push_back({LayerMeet::edges, a.index, b.index, on_a, on_b, normal, normal.dot(apart) - thickness});
    }
  }
}

}  // namespace

bool meet_by_features(const LayerElement& a, const LayerElement& b) {
  if (a.of.thread(a.index) && b.of.thread(b.index)) return false;
  const Vec3 of_a = doubled_area(a.now), of_b = doubled_area(b.now);
  return std::abs(of_a.dot(of_b)) >= parallel * of_a.norm() * of_b.norm();
}

void meet_features(const LayerElement& a, const LayerElement& b, double limit, double thickness,
                   std::vector<LayerMeeting>& out) {
  add_corners(a, b, limit, thickness, out);
  add_edges(a, b, limit, thickness, out);
}

}  // namespace prosector::contact
