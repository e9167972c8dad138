#include "server/physics/mechanics/organs/tet_lineage.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector::organs {

std::optional<OldTet> find_old(const cutting::TetComplex& complex, std::span<const PieceMesh* const> before,
                               cutting::TetId tet) {
  for (; tet != cutting::TetComplex::none; tet = complex.lineage(tet).parent)
    for (std::uint32_t p = 0; p < before.size(); ++p) {
      const std::vector<cutting::TetId>& places = before[p]->places;
      PROSECTOR_ASSERT(places.size() == before[p]->tets.size());
      const auto at = std::lower_bound(places.begin(), places.end(), complex.lineage(tet).place);
      const auto i = static_cast<std::size_t>(at - places.begin());
      if (at != places.end() && before[p]->tets[i] == tet) return OldTet{p, i};
    }
  return std::nullopt;
}

VecX carried_history(const cutting::TetComplex& complex, std::span<const PieceMesh* const> before,
                     std::span<const VecX* const> histories, Eigen::Index numbers,
                     std::span<const cutting::TetId> tets) {
  PROSECTOR_ASSERT(histories.size() == before.size() && numbers >= 0);
  if (numbers == 0) return {};
  VecX out = VecX::Zero(numbers * static_cast<Eigen::Index>(tets.size()));
  for (std::size_t t = 0; t < tets.size(); ++t)
    if (const auto old = find_old(complex, before, tets[t]))
      out.segment(numbers * static_cast<Eigen::Index>(t), numbers) =
          histories[old->piece]->segment(numbers * static_cast<Eigen::Index>(old->tet), numbers);
  return out;
}

}  // namespace prosector::organs
