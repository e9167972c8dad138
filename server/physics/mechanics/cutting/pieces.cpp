#include "server/physics/mechanics/cutting/pieces.h"

#include <numeric>

#include "common/assert.h"

namespace prosector::cutting {

std::vector<std::vector<TetId>> pieces(const TetComplex& complex) {
  std::vector<TetId> piece_of(complex.tet_end(), TetComplex::none), open;
  std::vector<std::size_t> sizes;
  for (TetId first = 0; first < complex.tet_end(); ++first) {
    if (!complex.has_tet(first) || piece_of[first] != TetComplex::none) continue;
    const auto piece = static_cast<TetId>(sizes.size());
    piece_of[first] = piece;
    open.assign(1, first);
    for (std::size_t n = 0; n < open.size(); ++n)
      for (std::size_t k = 0; k < 4; ++k) {
        const TetId beyond = complex.neighbor(open[n], k);
        PROSECTOR_ASSERT(beyond == TetComplex::none || complex.has_tet(beyond));
        if (beyond == TetComplex::none || piece_of[beyond] != TetComplex::none) continue;
        piece_of[beyond] = piece;
        open.push_back(beyond);
      }
    sizes.push_back(open.size());
  }
  std::vector<std::vector<TetId>> out(sizes.size());
  for (std::size_t piece = 0; piece < out.size(); ++piece) out[piece].reserve(sizes[piece]);
  for (TetId tet = 0; tet < complex.tet_end(); ++tet)
    if (complex.has_tet(tet)) out[piece_of[tet]].push_back(tet);
  return out;
}

bool hang_together(const TetComplex& complex, std::span<const TetId> tets) {
  std::vector<TetId> open;
  std::vector<std::uint32_t> group_of(complex.tet_end(), TetComplex::none);  // by tetrahedron reached so far
  for (TetId tet : tets) {
    while (!complex.has_tet(tet)) {
      tet = complex.lineage(tet).child;
      PROSECTOR_ASSERT(tet < complex.tet_end());
    }
    if (group_of[tet] != TetComplex::none) continue;
    group_of[tet] = static_cast<std::uint32_t>(open.size());
    open.push_back(tet);
  }
  std::vector<std::uint32_t> joined(open.size());  // by group: a group that it was merged into
  std::iota(joined.begin(), joined.end(), 0U);
  const auto whole = [&](std::uint32_t group) {
    while (joined[group] != group) group = joined[group] = joined[joined[group]];
    return group;
  };
  std::size_t groups = open.size();
  for (std::size_t n = 0; n < open.size() && groups > 1; ++n)
    for (std::size_t k = 0; k < 4; ++k) {
      const TetId beyond = complex.neighbor(open[n], k);
      if (beyond == TetComplex::none) continue;
      if (group_of[beyond] == TetComplex::none) {
        group_of[beyond] = group_of[open[n]];
        open.push_back(beyond);
      } else if (const std::uint32_t a = whole(group_of[open[n]]), b = whole(group_of[beyond]); a != b) {
        joined[std::max(a, b)] = std::min(a, b);
        --groups;
      }
    }
  return groups <= 1;
}

}  // namespace prosector::cutting
