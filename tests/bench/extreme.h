#pragma once
// What no rung may explode at: steps, stiffnesses, meshes, starts, forces and inputs that scenes and users
// can come up with, and worse.

#include <vector>

#include "server/calibration/specimen.h"

namespace prosector {

/// What pieces are of; few_tets: a quarter as many, for quadratic ones, whose nodes are as many then.
enum class PieceMesh { tets, few_tets, sheet, rope };
/// Which of them an extreme makes sense on.
inline constexpr unsigned on_tets = 1 | 2, on_sheets = 4, on_ropes = 8,
                          on_all = on_tets | on_sheets | on_ropes;

/// A piece starts as `start` puts it, bears `load` or `force` for a while, and is then left alone: no
/// gravity, no force. When it is `must_recover` it has to be back in its rest shape by then.
struct Extreme {
  const char* name;
  TestPiece (*piece)(PieceMesh mesh);
  double dt = 1. / 60;                                                // s
  void (*start)(const TestPiece& piece, VecX& x, VecX& v) = nullptr;  // null: at rest in its rest shape
  Vec3 load = {0, 0, 0};                                              // m/s²
  double load_s = 0;                                                  // s
  double release_s = 5;                                               // s
  bool must_recover = true;
  unsigned meshes = on_all;
  double force = 0;        // N, on all of it along `load`, whatever its mass; 0: `load` is meant
  bool cheap = false;      // done in a blink: also looked at by the test
  bool organs = false;     // no piece, but two organs and a hand: two_organs.h
  bool for_direct = true;  // false: a sparse factorisation would take minutes

  bool is_for(PieceMesh mesh) const { return (meshes >> static_cast<unsigned>(mesh) & 1u) != 0; }
};
const std::vector<Extreme>& extremes();

/// How far x (3n, m) is from the piece's rest shape `rest`, in m. Solids and ropes: the largest distance of a
/// node after the best rigid motion (shape_error). Sheets, whose twist nothing resists, and ropes whose
/// slowest bending takes longer than half of `seconds`: the largest change of length of a spring, which a
/// sheet has along and across each cell.
double misfit(const TestPiece& piece, const VecX& rest, const VecX& x, const VecX& node_mass, double seconds);

}  // namespace prosector
