#include "server/physics/cutting/pieces.h"

#include <algorithm>

namespace prosector {

std::vector<std::vector<TetId>> pieces(const TetComplex& complex) {
  std::vector<bool> seen(complex.tet_end(), false);
  std::vector<std::vector<TetId>> out;
  for (TetId first = 0; first < complex.tet_end(); ++first) {
    if (!complex.has_tet(first) || seen[first]) continue;
    seen[first] = true;
    auto& piece = out.emplace_back(1, first);
    for (std::size_t n = 0; n < piece.size(); ++n)
      for (std::size_t k = 0; k < 4; ++k) {
        const TetId beyond = complex.neighbor(piece[n], k);
        if (beyond == TetComplex::none || seen[beyond]) continue;
        seen[beyond] = true;
        piece.push_back(beyond);
      }
    std::sort(piece.begin(), piece.end());
  }
  return out;
}

}  // namespace prosector
