#include "server/physics/mechanics/coupled/rigid_block.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "common/assert.h"

namespace prosector::coupled {
namespace {

void insert(std::vector<std::uint32_t>& sorted, std::uint32_t value) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (at == sorted.end() || *at != value) sorted.insert(at, value);
}

Eigen::Index entry(std::size_t block) {
  return 6 * static_cast<Eigen::Index>(block);
}

}  // namespace

void RigidBlock::begin(std::size_t bodies, std::span<const Pair> pairs) {
  if (neighbours_.size() < bodies) neighbours_.resize(bodies);
  for (std::size_t b = 0; b < bodies; ++b) neighbours_[b].clear();
  for (const auto& [a, b] : pairs) {
    PROSECTOR_ASSERT(a < b && b < bodies);
    insert(neighbours_[a], static_cast<std::uint32_t>(b));
    insert(neighbours_[b], static_cast<std::uint32_t>(a));
  }
  eliminated_.assign(bodies, 0);
  rank_.resize(bodies);
  order();
  diagonal_.resize(bodies);
  below_.resize(rows_.size());
  work_.resize(entry(bodies));
  set_zero();
}

/// Computes the elimination order and the factor's block structure.
void RigidBlock::order() {
  body_.clear();
  rows_.clear();
  first_.assign(1, 0);
  const auto bodies = static_cast<std::uint32_t>(rank_.size());
  while (body_.size() < bodies) {
    std::uint32_t next = bodies;
    for (std::uint32_t b = 0; b < bodies; ++b)
      if (!eliminated_[b] && (next == bodies || neighbours_[b].size() < neighbours_[next].size())) next = b;
    PROSECTOR_ASSERT(next < bodies);
    eliminated_[next] = 1;
    rank_[next] = static_cast<Rank>(body_.size());
    body_.push_back(next);
    for (const std::uint32_t a : neighbours_[next]) {
      std::erase(neighbours_[a], next);
      for (const std::uint32_t b : neighbours_[next])
        if (a != b) insert(neighbours_[a], b);
    }
    rows_.insert(rows_.end(), neighbours_[next].begin(), neighbours_[next].end());
    first_.push_back(rows_.size());
  }
  for (std::uint32_t& row : rows_) row = rank_[row];
  for (std::size_t k = 0; k < bodies; ++k)
    std::sort(rows_.begin() + static_cast<std::ptrdiff_t>(first_[k]),
              rows_.begin() + static_cast<std::ptrdiff_t>(first_[k + 1]));
}

Mat6& RigidBlock::below(Rank row, Rank column) {
  const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(first_[column]),
             end = rows_.begin() + static_cast<std::ptrdiff_t>(first_[column + 1]);
  PROSECTOR_ASSERT(row > column && std::binary_search(begin, end, row));
  return below_[static_cast<std::size_t>(std::lower_bound(begin, end, row) - rows_.begin())];
}

void RigidBlock::set_zero() {
  for (auto* blocks : {&diagonal_, &below_}) std::fill(blocks->begin(), blocks->end(), Mat6::Zero());
}

void RigidBlock::add(std::size_t a, std::size_t b, const Mat6& block) {
  PROSECTOR_ASSERT(a < b && b < rank_.size());
  if (rank_[a] > rank_[b])
    below(rank_[a], rank_[b]) += block;
  else
    below(rank_[b], rank_[a]) += block.transpose();
}

bool RigidBlock::factor() {
  for (Rank k = 0; k < body_.size(); ++k) {
    const Eigen::LLT<Mat6> pivot(diagonal_[k]);
    if (pivot.info() != Eigen::Success) return false;
    diagonal_[k] = pivot.matrixL();
    for (std::size_t p = first_[k]; p < first_[k + 1]; ++p)
      pivot.matrixL().transpose().solveInPlace<Eigen::OnTheRight>(below_[p]);
    for (std::size_t p = first_[k]; p < first_[k + 1]; ++p) {
      diagonal_[rows_[p]].noalias() -= below_[p] * below_[p].transpose();
      for (std::size_t q = p + 1; q < first_[k + 1]; ++q)
        below(rows_[q], rows_[p]).noalias() -= below_[q] * below_[p].transpose();
    }
  }
  return true;
}

void RigidBlock::solve(const Eigen::Ref<const VecX>& r, Eigen::Ref<VecX> z) const {
  PROSECTOR_ASSERT(r.size() == entry(body_.size()) && z.size() == r.size());
  const auto part = [&](Rank k) { return work_.segment<6>(entry(k)); };
  for (Rank k = 0; k < body_.size(); ++k) part(k) = r.segment<6>(entry(body_[k]));
  for (Rank k = 0; k < body_.size(); ++k) {
    auto own = part(k);
    diagonal_[k].triangularView<Eigen::Lower>().solveInPlace(own);
    for (std::size_t p = first_[k]; p < first_[k + 1]; ++p) part(rows_[p]).noalias() -= below_[p] * own;
  }
  for (Rank k = static_cast<Rank>(body_.size()); k-- > 0;) {
    auto own = part(k);
    for (std::size_t p = first_[k]; p < first_[k + 1]; ++p)
      own.noalias() -= below_[p].transpose() * part(rows_[p]);
    diagonal_[k].triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    z.segment<6>(entry(body_[k])) = own;
  }
}

}  // namespace prosector::coupled
