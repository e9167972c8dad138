#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/solvers/node_covariance.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include "server/physics/mechanics/soft/simd/four_lanes.h"
#include "server/physics/mechanics/soft/solvers/node_covariance.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

void covariances(const BlockPattern& neighbours, const float* x, const float* rest, std::size_t first,
                 std::size_t last, LaneMatrix& F) {
  for (std::size_t i = first; i < last; ++i) {
    const V4 here = load4(x + 4 * i);
    const float* Xi = rest + 4 * i;
    V4 sum[3] = {zero4(), zero4(), zero4()};
    for (std::size_t k = neighbours.begin(i); k < neighbours.end(i); ++k) {
      const std::size_t j = neighbours.column(k);
      const V4 away = multiply_add(-1.f, here, load4(x + 4 * j));
      const float* Xj = rest + 4 * j;
      for (std::size_t c = 0; c < 3; ++c) sum[c] = multiply_add(Xj[c] - Xi[c], away, sum[c]);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      float column[4];
      store4(sum[c], column);
      for (std::size_t r = 0; r < 3; ++r) F.at[3 * c + r][i - first] = static_cast<double>(column[r]);
    }
  }
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector::soft {

HWY_EXPORT(covariances);

void node_covariances(const BlockPattern& neighbours, const float* x, const float* rest, std::size_t first,
                      std::size_t last, LaneMatrix& F) {
  HWY_DYNAMIC_DISPATCH(covariances)(neighbours, x, rest, first, last, F);
}

}  // namespace prosector::soft
#endif
