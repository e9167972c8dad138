#pragma once
// Extreme time steps, stiffnesses, meshes, initial states, forces and inputs, under which every configuration
// must remain stable.

#include <vector>

#include "server/calibration/specimen.h"

namespace prosector {

/// Mesh of a test piece. few_tets: a quarter of the tetrahedra, so that quadratic elements have as many
/// nodes.
enum class PieceMesh { tets, few_tets, sheet, rope };
/// Bit set of the meshes that an extreme applies to.
inline constexpr unsigned on_tets = 1 | 2, on_sheets = 4, on_ropes = 8,
                          on_all = on_tets | on_sheets | on_ropes;

/// An extreme: a piece starts in the state that `start` sets, bears `load` or `force` for `load_s`, and then
/// moves without gravity and forces for `release_s`. With `must_recover`, it must have its rest shape at the
/// end.
struct Extreme {
  const char* name;
  TestPiece (*piece)(PieceMesh mesh);
  double dt = 1. / 60;                                                // s
  void (*start)(const TestPiece& piece, VecX& x, VecX& v) = nullptr;  // null: at rest, undeformed
  Vec3 load = {0, 0, 0};                                              // m/s²
  double load_s = 0;                                                  // s
  double release_s = 5;                                               // s
  bool must_recover = true;
  unsigned meshes = on_all;
  double force = 0;        // N, total force along `load`, independent of mass; 0: use `load`
  bool cheap = false;      // fast, so that the unit test runs it too
  bool organs = false;     // the test of two_organs.h instead of a piece
  bool for_direct = true;  // false: a sparse factorisation would take minutes

  bool is_for(PieceMesh mesh) const { return (meshes >> static_cast<unsigned>(mesh) & 1u) != 0; }
};
const std::vector<Extreme>& extremes();

/// Returns the shape error of positions x (3n, m) against the rest shape `rest`, m. Solids and ropes: largest
/// node distance after the best-fit rigid motion (shape_error). Sheets, whose twist has no stiffness, and
/// ropes whose slowest bending period exceeds half of `seconds`: largest length change of a spring, which a
/// sheet has along and across each cell.
double misfit(const TestPiece& piece, const VecX& rest, const VecX& x, const VecX& node_mass, double seconds);

}  // namespace prosector
