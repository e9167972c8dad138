#include "server/physics/mechanics/contact/layers.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include "server/physics/mechanics/collision/primitives/triangle_crossing.h"
#include "server/physics/mechanics/collision/surface/surface_pairs.h"
#include "server/physics/mechanics/contact/layer_features.h"

namespace prosector::contact {
namespace {

constexpr double alike = 0.01;    // thicknesses: tolerance of gaps between parallel layers
constexpr double remembered = 2;  // thicknesses: the side is stored for elements nearer than this

using Pair = std::pair<std::uint32_t, std::uint32_t>;  // of element indices

collision::Aabb box_around(const collision::Triangle& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

class Search {
 public:
  Search(const ElementSurface& a, const ElementSurface& b, const LayerSearch& how,
         const std::vector<LayerSide>& before)
      : a_(a), b_(b), how_(how), before_(before), same_(&a == &b) {}

  void run() {
    const double limit = how_.thickness + how_.margin;
    collision::descend_pairs(
        a_.tree(), b_.tree(), Mat3::Identity(), Vec3::Zero(), [&] { return limit * limit; },
        [&](const collision::SurfaceTree::Node& p, const collision::SurfaceTree::Node& q) {
          if (same_ && p.begin > q.begin) return;  // the swapped pair is visited, too
          for (std::uint32_t i = p.begin; i < p.end; ++i)
            for (std::uint32_t j = q.begin; j < q.end; ++j) {
              if (same_ && p.begin == q.begin && j <= i) continue;
              std::uint32_t s = a_.tree().order()[i], t = b_.tree().order()[j];
              if (same_ && t < s) std::swap(s, t);
              look_at(s, t, limit);
            }
        });
    std::sort(sides.begin(), sides.end(), earlier);
  }

  std::vector<LayerSide> sides;
  std::vector<LayerMeeting> meetings;
  std::vector<std::pair<Pair, double>> gaps;  // m, between elements
  int passed = 0;

 private:
  static bool earlier(const LayerSide& s, const LayerSide& t) {
    return std::pair{s.a, s.b} < std::pair{t.a, t.b};
  }

  enum class AtRest : std::uint8_t { far, joined, parted };

  AtRest at_rest(std::uint32_t s, std::uint32_t t) const {
    const double apart = how_.apart_at_rest;
    if (!(apart > 0)) return AtRest::far;
    const auto around = a_.around(s);
    if (same_ && std::binary_search(around.begin(), around.end(), t)) return AtRest::joined;
    if (!(collision::closest(a_.at_rest(s), b_.at_rest(t)).squared_distance < apart * apart))
      return AtRest::far;
    return same_ && a_.hang_together(s, t, apart) ? AtRest::joined : AtRest::parted;
  }

  /// Returns the distance (m) at which points of two elements touch; not positive: they make no contact.
  double thickness(AtRest were, std::uint32_t s, const Vec3& weights_a, std::uint32_t t,
                   const Vec3& weights_b) const {
    if (were == AtRest::far) return how_.thickness;
    const Vec3 way = collision::at(a_.at_rest(s), weights_a) - collision::at(b_.at_rest(t), weights_b);
    return std::min(how_.thickness, way.norm() - how_.seam);
  }

  std::optional<Vec3> known(std::uint32_t s, std::uint32_t t) const {
    const bool swapped = same_ && t < s;
    const LayerSide key{swapped ? t : s, swapped ? s : t, {}};
    const auto found = std::lower_bound(before_.begin(), before_.end(), key, earlier);
    if (found == before_.end() || earlier(key, *found)) return std::nullopt;
    return swapped ? Vec3(-found->normal) : found->normal;
  }

  /// Returns the stored side of this pair or, without one, of pairs of neighbouring elements, since elements
  /// that slide while passed through meet other elements.
  std::optional<Vec3> side_of(std::uint32_t s, std::uint32_t t) const {
    if (const auto own = known(s, t)) return own;
    std::optional<Vec3> out;
    for (const std::uint32_t p : a_.around(s))
      for (const std::uint32_t q : b_.around(t)) {
        const auto near = known(p, q);
        if (near && out && near->dot(*out) < 0) return std::nullopt;  // the neighbours disagree
        if (near && !out) out = near;
      }
    return out;
  }

  void look_at(std::uint32_t s, std::uint32_t t, double limit) {
    const collision::Triangle of_a = a_.now(s), of_b = b_.now(t);
    const collision::Aabb box_a = box_around(of_a), box_b = box_around(of_b);
    if (box_a.squared_distance(box_b) > limit * limit) return;
    const AtRest were = at_rest(s, t);
    if (were == AtRest::joined) return;
    if (box_a.overlaps(box_b))
      if (const collision::TriangleCrossing crosses = collision::crossing(of_a, of_b); crosses.count > 0)
        return add_crossing(s, t, of_a, of_b, crosses, were);
    add_near(s, t, of_a, of_b, limit, were);
  }

  void add_near(std::uint32_t s, std::uint32_t t, const collision::Triangle& of_a,
                const collision::Triangle& of_b, double limit, AtRest were) {
    const collision::TrianglePair pair = collision::closest(of_a, of_b);
    double distance = std::sqrt(pair.squared_distance);
    if (!(distance <= limit) || !(distance > 0)) return;
    const LayerElement own{a_, s, of_a}, other{b_, t, of_b};
    const bool by_features = meet_by_features(own, other);
    const double touching = thickness(were, s, pair.weights_a, t, pair.weights_b);
    if (!(touching > 0)) {
      if (by_features) add_features(own, other, limit, were);
      return;
    }
    Vec3 n = (pair.on_a - pair.on_b) / distance;
    if (distance < touching)
      if (const auto side = side_of(s, t); side && n.dot(*side) < 0) {
        n = -n;
        distance = -distance;
        ++passed;
      }
    if (std::abs(distance) < remembered * touching) sides.push_back({s, t, n});
    const double gap = distance - touching;
    gaps.push_back({{s, t}, gap});
    if (distance > 0 && by_features)
      add_features(own, other, limit, were);
    else
      meetings.push_back({LayerMeet::nearest, s, t, pair.weights_a, pair.weights_b, n, gap});
  }

  void add_features(const LayerElement& own, const LayerElement& other, double limit, AtRest were) {
    const auto before = static_cast<std::ptrdiff_t>(meetings.size());
    meet_features(own, other, limit, how_.thickness, meetings);
    if (were == AtRest::far) return;
    const auto beside = [&](LayerMeeting& m) {
      const double touching = thickness(were, m.a, m.weights_a, m.b, m.weights_b);
      m.gap += how_.thickness - touching;
      return !(touching > 0);
    };
    meetings.erase(std::remove_if(meetings.begin() + before, meetings.end(), beside), meetings.end());
  }

  /// Adds contacts that send the ends of intersecting edges back through the other face.
  void add_crossing(std::uint32_t s, std::uint32_t t, const collision::Triangle& of_a,
                    const collision::Triangle& of_b, const collision::TriangleCrossing& crosses,
                    AtRest were) {
    const auto touching = [&](const collision::Piercing& piercing) {
      const collision::Triangle& face = piercing.of_a ? of_b : of_a;
      Vec3 along = Vec3::Zero();
      along[piercing.edge] = 1 - piercing.along;
      along[(piercing.edge + 1) % 3] = piercing.along;
      const Vec3 within = collision::closest_weights(piercing.point, face[0], face[1], face[2]);
      return piercing.of_a ? thickness(were, s, along, t, within) : thickness(were, s, within, t, along);
    };
    const auto all = std::span(crosses.piercings).first(crosses.count);
    if (std::ranges::none_of(all, [&](const collision::Piercing& p) { return touching(p) > 0; })) return;
    ++passed;
    const std::optional<Vec3> side = side_of(s, t);
    if (!side) return;
    const Vec3 n = *side;
    sides.push_back({s, t, n});
    for (const collision::Piercing& piercing : all) {
      if (!(touching(piercing) > 0)) continue;
      const collision::Triangle& edge_of = piercing.of_a ? of_a : of_b;
      const std::size_t from = piercing.edge, to = (from + 1) % 3;
      const Vec3 way = piercing.of_a ? n : Vec3(-n);  // out of the other element
      const std::size_t end = way.dot(edge_of[from]) < way.dot(edge_of[to]) ? from : to;
      LayerMeeting m{LayerMeet::nearest,
                     s,
                     t,
                     Vec3::Unit(static_cast<Eigen::Index>(end)),
                     Vec3::Unit(static_cast<Eigen::Index>(end)),
                     n,
                     way.dot(edge_of[end] - piercing.point) - touching(piercing)};
      const collision::Triangle& face = piercing.of_a ? of_b : of_a;
      (piercing.of_a ? m.weights_b : m.weights_a) =
          collision::closest_weights(piercing.point, face[0], face[1], face[2]);
      gaps.push_back({{s, t}, m.gap});
      meetings.push_back(m);
    }
  }

  const ElementSurface &a_, &b_;
  const LayerSearch& how_;
  const std::vector<LayerSide>& before_;
  bool same_;
};

/// Removes nearest-point meetings that are not the nearest of either element's surroundings. Nearer
/// neighbours stop such pairs first, and their oblique contact planes would stop sliding. `gaps`: of all
/// pairs.
void keep_nearest(const ElementSurface& a, const ElementSurface& b, double thickness,
                  std::vector<std::pair<Pair, double>>& gaps, std::vector<LayerMeeting>& meetings) {
  const bool same = &a == &b;
  std::sort(gaps.begin(), gaps.end());
  const auto nearer = [&](std::uint32_t s, std::uint32_t t, double gap) {
    const Pair key = same && t < s ? Pair{t, s} : Pair{s, t};
    const auto found = std::lower_bound(gaps.begin(), gaps.end(), std::pair{key, -1e9});
    return found != gaps.end() && found->first == key && found->second < gap - alike * thickness;
  };
  std::erase_if(meetings, [&](const LayerMeeting& m) {
    if (m.kind != LayerMeet::nearest) return false;
    const auto of_b = b.around(m.b), of_a = a.around(m.a);
    return std::any_of(of_b.begin(), of_b.end(), [&](std::uint32_t t) { return nearer(m.a, t, m.gap); }) &&
           std::any_of(of_a.begin(), of_a.end(), [&](std::uint32_t s) { return nearer(s, m.b, m.gap); });
  });
}

/// Keeps each pair of features once, the deepest meeting. In self-contact the lower feature becomes a, except
/// for meetings of corners, whose corner stays a for its memory.
void keep_each_once(const ElementSurface& a, const ElementSurface& b, std::vector<LayerMeeting>& meetings) {
  const bool same = &a == &b;
  std::vector<std::pair<Pair, LayerMeeting>> keyed;
  for (LayerMeeting m : meetings) {
    Pair key{a.feature(m.a, m.weights_a), b.feature(m.b, m.weights_b)};
    if (same && key.second < key.first) {
      std::swap(key.first, key.second);
      if (m.kind != LayerMeet::corner_of_a) swap_sides(m);
    }
    keyed.emplace_back(key, m);
  }
  const auto rank = [](const auto& k) {
    return std::tuple{k.first, k.second.gap, k.second.kind, k.second.a, k.second.b};
  };
  std::sort(keyed.begin(), keyed.end(), [&](const auto& p, const auto& q) { return rank(p) < rank(q); });
  meetings.clear();
  for (std::size_t i = 0; i < keyed.size(); ++i)
    if (i == 0 || keyed[i].first != keyed[i - 1].first) meetings.push_back(keyed[i].second);
}

}  // namespace

int find_layers(const ElementSurface& a, const ElementSurface& b, const LayerSearch& search,
                std::vector<LayerSide>& sides, std::vector<LayerMeeting>& out) {
  Search found(a, b, search, sides);
  found.run();
  keep_nearest(a, b, search.thickness, found.gaps, found.meetings);
  keep_each_once(a, b, found.meetings);
  sides = std::move(found.sides);
  out.insert(out.end(), found.meetings.begin(), found.meetings.end());
  return found.passed;
}

}  // namespace prosector::contact
