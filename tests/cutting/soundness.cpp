#include "tests/cutting/soundness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "server/physics/mechanics/cutting/mesh_cut.h"
#include "server/physics/mechanics/cutting/pieces.h"
#include "server/physics/mechanics/cutting/tet_shape.h"

namespace prosector {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

constexpr cutting::TetId none = cutting::TetComplex::none;

class Sets {
 public:
  explicit Sets(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { root_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> root_;
};

AssertionResult caches_are_as_rebuilt(const cutting::TetComplex& complex) {
  std::map<std::array<cutting::NodeId, 3>, std::vector<std::pair<cutting::TetId, std::size_t>>> faces;
  std::vector<std::vector<cutting::TetId>> star(complex.node_end());
  for (const cutting::TetId t : cutting::tet_ids(complex))
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& c = complex.corners(t);
      if (!complex.has_node(c[k])) return AssertionFailure() << "tet " << t << " has a node that is gone";
      star[c[k]].push_back(t);
      std::array<cutting::NodeId, 3> key{};
      for (std::size_t i = 0; i < 3; ++i) key[i] = c[cutting::TetComplex::face[k][i]];
      std::sort(key.begin(), key.end());
      faces[key].emplace_back(t, k);
    }
  for (cutting::NodeId i = 0; i < complex.node_end(); ++i)
    if (!std::equal(star[i].begin(), star[i].end(), complex.star(i).begin(), complex.star(i).end()))
      return AssertionFailure() << "the star of node " << i << " is not as rebuilt";
  for (const auto& [key, sides] : faces) {
    const auto [t, k] = sides.front();
    if (sides.size() > 2) return AssertionFailure() << "a face with " << sides.size() << " tets";
    if (sides.size() == 1) {
      if (complex.neighbor(t, k) != none)
        return AssertionFailure() << "tet " << t << " neighbours a stranger";
      continue;
    }
    const auto [u, j] = sides.back();
    const bool joined = complex.neighbor(t, k) == u && complex.neighbor(u, j) == t;
    const bool slit = complex.neighbor(t, k) == none && complex.neighbor(u, j) == none &&
                      complex.is_wall(t, k) && complex.is_wall(u, j);
    if (joined == slit)
      return AssertionFailure() << "tets " << t << " and " << u << " are neither joined nor slit";
  }
  return AssertionSuccess();
}

// Boundary faces, each edge matched with the face met on the way round it through the tetrahedra.
class Boundary {
 public:
  explicit Boundary(const cutting::TetComplex& complex) : complex_(complex) {
    for (const cutting::TetId t : cutting::tet_ids(complex))
      for (std::size_t k = 0; k < 4; ++k)
        if (complex.neighbor(t, k) == none) {
          index_[{t, k}] = faces_.size();
          faces_.emplace_back(t, k);
        }
  }

  // Euler characteristic of each closed surface is even and at most 2, and every edge has its one partner.
  AssertionResult is_closed() {
    Sets surfaces(faces_.size()), corners(3 * faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t e = 0; e < 3; ++e) {
        const auto [g, h] = partner(f, e);
        if (g == npos || g == f) return AssertionFailure() << "an edge of boundary face " << f << " is open";
        if (partner(g, h) != std::pair{f, e})
          return AssertionFailure() << "an edge with three boundary faces";
        if (node(f, e) != node(g, (h + 1) % 3) || node(f, (e + 1) % 3) != node(g, h))
          return AssertionFailure() << "two boundary faces disagree in orientation";
        surfaces.join(f, g);
        corners.join(3 * f + e, 3 * g + (h + 1) % 3);
        corners.join(3 * f + (e + 1) % 3, 3 * g + h);
      }
    std::map<std::size_t, long> twice;  // 2·(V − E + F)
    for (std::size_t c = 0; c < 3 * faces_.size(); ++c)
      if (corners.find(c) == c) twice[surfaces.find(c / 3)] += 2;
    for (std::size_t f = 0; f < faces_.size(); ++f) twice[surfaces.find(f)] += 2 - 3;
    for (const auto& [surface, x] : twice)
      if (x > 4 || x % 4 != 0)
        return AssertionFailure() << "a boundary of Euler characteristic " << x << " / 2";
    return AssertionSuccess();
  }

 private:
  static constexpr std::size_t npos = SIZE_MAX;

  cutting::NodeId node(std::size_t f, std::size_t i) const {
    const auto [t, k] = faces_[f];
    return complex_.corners(t)[cutting::TetComplex::face[k][i]];
  }
  std::pair<std::size_t, std::size_t> partner(std::size_t f, std::size_t e) const {
    const cutting::NodeId a = node(f, e), b = node(f, (e + 1) % 3);
    auto [t, k] = faces_[f];
    for (int steps = 0; steps < 1000; ++steps) {
      std::size_t other = 4;  // the tetrahedron's other face at a–b
      for (std::size_t i = 0; i < 4; ++i)
        if (i != k && complex_.corners(t)[i] != a && complex_.corners(t)[i] != b) other = i;
      const cutting::TetId next = complex_.neighbor(t, other);
      if (next == none) {
        const std::size_t g = index_.at({t, other});
        for (std::size_t h = 0; h < 3; ++h)
          if (node(g, h) == b && node(g, (h + 1) % 3) == a) return {g, h};
        return {npos, 0};
      }
      for (k = 0; complex_.neighbor(next, k) != t;) ++k;
      t = next;
    }
    return {npos, 0};
  }

  const cutting::TetComplex& complex_;
  std::vector<std::pair<cutting::TetId, std::size_t>> faces_;
  std::map<std::pair<cutting::TetId, std::size_t>, std::size_t> index_;
};

AssertionResult nodes_are_parted(const cutting::TetComplex& complex) {
  for (const cutting::NodeId node : cutting::node_ids(complex)) {
    const auto star = complex.star(node);
    Sets sets(star.size());
    for (std::size_t i = 0; i < star.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const cutting::TetId beyond = complex.neighbor(star[i], k);
        if (beyond == none || complex.corners(star[i])[k] == node) continue;
        sets.join(
            i, static_cast<std::size_t>(std::lower_bound(star.begin(), star.end(), beyond) - star.begin()));
      }
    for (std::size_t i = 1; i < star.size(); ++i)
      if (sets.find(i) != sets.find(0))
        return AssertionFailure() << "node " << node << " holds two parts together";
  }
  return AssertionSuccess();
}

}  // namespace

Whole whole(const cutting::TetComplex& complex) {
  Whole w;
  double cosine = -1;
  for (const cutting::TetId t : cutting::tet_ids(complex)) {
    const auto& c = complex.corners(t);
    w.volume += complex.volume(t);
    cosine = std::max(cosine, cutting::cos_least_dihedral({complex.rest(c[0]), complex.rest(c[1]),
                                                           complex.rest(c[2]), complex.rest(c[3])}));
  }
  for (const cutting::NodeId i : cutting::node_ids(complex)) w.mass += complex.mass(i);
  w.least_dihedral_deg = std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
  return w;
}

AssertionResult is_sound(const cutting::TetComplex& complex, const Whole& before) {
  for (const cutting::TetId t : cutting::tet_ids(complex))
    if (!(complex.volume(t) > 0))
      return AssertionFailure() << "tet " << t << " has a volume of " << complex.volume(t);
  const Whole now = whole(complex);
  if (std::abs(now.volume - before.volume) > 1e-12 * before.volume)
    return AssertionFailure() << "volume " << before.volume << " became " << now.volume;
  if (std::abs(now.mass - before.mass) > 1e-12 * before.mass)
    return AssertionFailure() << "mass " << before.mass << " became " << now.mass;
  const double floor = std::min(before.least_dihedral_deg, cutting::least_dihedral_deg);
  if (now.least_dihedral_deg < floor - 1e-6)
    return AssertionFailure() << "a dihedral angle of " << now.least_dihedral_deg << " deg";
  if (auto good = caches_are_as_rebuilt(complex); !good) return good;
  if (auto good = Boundary(complex).is_closed(); !good) return good;
  return nodes_are_parted(complex);
}

}  // namespace prosector
