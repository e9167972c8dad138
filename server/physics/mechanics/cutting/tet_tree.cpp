#include "server/physics/mechanics/cutting/tet_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/assert.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/collision/surface/space_order.h"

namespace prosector::cutting {
namespace {

constexpr std::size_t leaf_size = 8, leaves_per_chunk = 128, nodes_per_chunk = 2048;

Vec3 centroid(const TetComplex& complex, TetId t) {
  Vec3 sum = Vec3::Zero();
  for (const NodeId corner : complex.corners(t)) sum += complex.rest(corner);
  return sum / static_cast<double>(complex.sides());
}

}  // namespace

void TetTree::build(const TetComplex& complex) {
  branches_.clear();
  leaves_.clear();
  const std::vector<TetId> ids = tet_ids(complex);
  std::vector<Vec3> middles;
  middles.reserve(ids.size());
  for (const TetId t : ids) middles.push_back(centroid(complex, t));
  std::vector<TetId> tets;
  tets.reserve(ids.size());
  for (const collision::SpaceOrder order(std::move(middles)); const std::uint32_t i : order.order())
    tets.push_back(ids[i]);
  leaf_of_.assign(complex.tet_end(), 0);
  if (!tets.empty()) split(tets, 0, tets.size());
  built_tets_ = tets.size();
  PROSECTOR_ASSERT(built_tets_ == complex.tets());
  undone_ = complex.undone();
}

/// Builds the branch of a run of tetrahedra by halving. The run follows a space-filling curve.
std::uint32_t TetTree::split(std::span<const TetId> tets, std::size_t begin, std::size_t end) {
  PROSECTOR_ASSERT(begin < end && end <= tets.size());
  const auto index = static_cast<std::uint32_t>(branches_.size());
  branches_.push_back({});
  branches_[index].first = static_cast<std::uint32_t>(leaves_.size());
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i) leaf_of_[tets[i]] = static_cast<std::uint32_t>(leaves_.size());
    leaves_.emplace_back(tets.begin() + static_cast<std::ptrdiff_t>(begin),
                         tets.begin() + static_cast<std::ptrdiff_t>(end));
  } else {
    const std::size_t middle = begin + (end - begin) / 2;
    split(tets, begin, middle);
    const std::uint32_t right = split(tets, middle, end);
    branches_[index].right = right;
  }
  branches_[index].last = static_cast<std::uint32_t>(leaves_.size());
  return index;
}

/// Adds new tetrahedra: children of a split are put into their parent's leaf.
void TetTree::take_in(const TetComplex& complex) {
  PROSECTOR_ASSERT(leaf_of_.size() <= complex.tet_end());
  for (auto t = static_cast<TetId>(leaf_of_.size()); t < complex.tet_end(); ++t) {
    const TetId parent = complex.lineage(t).parent;
    PROSECTOR_ASSERT(parent == TetComplex::none || parent < t);
    leaf_of_.push_back(parent == TetComplex::none ? 0 : leaf_of_[parent]);
    if (parent == TetComplex::none) continue;
    std::vector<TetId>& leaf = leaves_[leaf_of_.back()];
    std::erase(leaf, parent);
    if (complex.has_tet(t)) leaf.push_back(t);
  }
}

void TetTree::update(const TetComplex& complex, std::span<const Vec3> positions, const Vec3& low,
                     const Vec3& high) {
  PROSECTOR_ASSERT(positions.size() >= complex.node_end());
  if (branches_.empty() || undone_ != complex.undone() || complex.tets() > 2 * built_tets_) build(complex);
  take_in(complex);
  find_near(complex, positions, low, high);
  boxes(complex, positions);
}

/// Finds the leaves near the box. A tetrahedron is outside if all its corners are beyond the same side of the
/// box.
void TetTree::find_near(const TetComplex& complex, std::span<const Vec3> positions, const Vec3& low,
                        const Vec3& high) {
  beside_.resize(complex.node_end());
  parallel_chunks(beside_.size(), nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      unsigned sides = 0;
      for (unsigned axis = 0; axis < 3; ++axis) {
        const double x = positions[i][axis];
        sides |= (x < low[axis] ? 1U : 0U) << 2 * axis | (x > high[axis] ? 2U : 0U) << 2 * axis;
      }
      beside_[i] = static_cast<std::uint8_t>(sides);
    }
  });
  near_.resize(leaves_.size());
  parallel_chunks(leaves_.size(), leaves_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t l = first; l < last; ++l)
      near_[l] = std::any_of(leaves_[l].begin(), leaves_[l].end(), [&](TetId t) {
        unsigned common = ~0U;
        for (const NodeId corner : complex.corners(t)) common &= beside_[corner];
        return common == 0;
      });
  });
}

void TetTree::boxes(const TetComplex& complex, std::span<const Vec3> positions) {
  PROSECTOR_ASSERT(near_.size() == leaves_.size());
  leaf_begin_.assign(1, 0);
  for (const auto& leaf : leaves_) leaf_begin_.push_back(leaf_begin_.back() + leaf.size());
  low_.resize(leaf_begin_.back());
  high_.resize(leaf_begin_.back());
  parallel_chunks(leaves_.size(), leaves_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t l = first; l < last; ++l) {
      if (!near_[l]) continue;
      std::size_t at = leaf_begin_[l];
      for (const TetId t : leaves_[l]) {
        const auto c = complex.corners(t);
        Vec3 low = positions[c[0]], high = low;
        for (const NodeId corner : c.subspan(1)) {
          low = low.cwiseMin(positions[corner]);
          high = high.cwiseMax(positions[corner]);
        }
        low_[at] = low;
        high_[at++] = high;
      }
    }
  });
  for (std::size_t b = branches_.size(); b-- > 0;) {
    Branch& branch = branches_[b];
    branch.low = Vec3::Constant(std::numeric_limits<double>::infinity());  // empty box
    branch.high = -branch.low;
    if (branch.right == 0) {
      if (!near_[branch.first]) continue;
      const std::size_t begin = leaf_begin_[branch.first], end = leaf_begin_[branch.last];
      for (std::size_t i = begin; i < end; ++i) {
        branch.low = branch.low.cwiseMin(low_[i]);
        branch.high = branch.high.cwiseMax(high_[i]);
      }
    } else {
      branch.low = branches_[b + 1].low.cwiseMin(branches_[branch.right].low);
      branch.high = branches_[b + 1].high.cwiseMax(branches_[branch.right].high);
    }
  }
}

template <class Meets>
void TetTree::visit(Meets&& meets, std::vector<TetId>& found) const {
  PROSECTOR_ASSERT(branches_.empty() || leaf_begin_.size() == leaves_.size() + 1);
  std::vector<std::uint32_t> open;
  if (!branches_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t b = open.back();
    open.pop_back();
    const Branch& branch = branches_[b];
    if (!meets(branch.low, branch.high)) continue;
    if (branch.right != 0) {
      open.push_back(branch.right);
      open.push_back(b + 1);
      continue;
    }
    const std::size_t begin = leaf_begin_[branch.first];
    const auto& leaf = leaves_[branch.first];
    for (std::size_t i = 0; i < leaf.size(); ++i)
      if (meets(low_[begin + i], high_[begin + i])) found.push_back(leaf[i]);
  }
}

void TetTree::query(const SweptSurface::Piece& piece, std::vector<TetId>& found) const {
  visit(
      [&](const Vec3& low, const Vec3& high) {
        if ((low.array() > piece.high.array()).any() || (high.array() < piece.low.array()).any())
          return false;
        const Vec3 center = (low + high) / 2, half = (high - low) / 2;
        return std::abs(piece.normal.dot(center - piece.corner[0])) <=
               piece.normal.cwiseAbs().dot(half) * (1 + 1e-12);
      },
      found);
}

void TetTree::query(const Vec3& low, const Vec3& high, std::vector<TetId>& found) const {
  visit(
      [&](const Vec3& least, const Vec3& most) {
        return (least.array() <= high.array()).all() && (low.array() <= most.array()).all();
      },
      found);
}

}  // namespace prosector::cutting
