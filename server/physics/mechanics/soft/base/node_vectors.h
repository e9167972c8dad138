#pragma once
// Node data as flat vectors of 3n coordinates, and sums that do not depend on the thread count.

#include <span>
#include <vector>

#include "common/math.h"

namespace prosector::soft {

inline VecX to_vector(std::span<const Vec3> points) {
  VecX x(static_cast<Eigen::Index>(3 * points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) x.segment<3>(static_cast<Eigen::Index>(3 * i)) = points[i];
  return x;
}

/// Returns the total of partial sums (one per chunk of a parallel loop), added in their order, so that it
/// does not depend on the number of threads.
inline double ordered_sum(const std::vector<double>& sums) {
  double total = 0;
  for (double sum : sums) total += sum;
  return total;
}

}  // namespace prosector::soft
