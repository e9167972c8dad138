#include "server/physics/cutting/pieces.h"

namespace prosector {

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

}  // namespace prosector
