// Forces of a few elements from vector registers. Included once per instruction set, see lane_math.h.

#if defined(PROSECTOR_LANE_FORCES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PROSECTOR_LANE_FORCES_H
#undef PROSECTOR_LANE_FORCES_H
#else
#define PROSECTOR_LANE_FORCES_H
#endif

#include <algorithm>
#include <span>

#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/simd/lane_math.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

/// Writes f_1 … f_3 (columns) of the elements from i on, and f_0 = −(f_1 + f_2 + f_3).
HWY_INLINE void write_forces(const Matrix& columns, std::size_t i, std::span<Tet4Elements::Forces> out) {
  alignas(64) LaneMatrix f;
  store(columns, f, 0);
  const std::size_t last = std::min(i + hn::Lanes(D()), out.size());
  for (std::size_t e = i; e < last; ++e) {
    auto* to = reinterpret_cast<double*>(&out[e]);
    for (std::size_t k = 0; k < 9; ++k) to[3 + k] = f.at[k][e - i];
    for (std::size_t k = 0; k < 3; ++k) to[k] = -(to[3 + k] + to[6 + k] + to[9 + k]);
  }
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
