#include "server/calibration/beam_piece.h"

#include "common/anatomy/kuhn_box.h"

namespace prosector {

TestPiece beam_piece(unsigned cells, double poisson_ratio) {
  TestPiece piece;
  piece.mesh = kuhn_box(beam_size, cells, cells / 4, cells / 4);
  piece.poisson_ratio = poisson_ratio;
  piece.clamped_axis = 0;
  return piece;
}

}  // namespace prosector
