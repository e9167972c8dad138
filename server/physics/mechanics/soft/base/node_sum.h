#pragma once
// Sums over nodes with equal results for any number of threads.

#include <vector>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"

namespace prosector::soft {

class NodeSum {
 public:
  explicit NodeSum(std::size_t nodes) : nodes_(nodes), sums_(chunk_count(nodes, nodes_per_chunk)) {}

  /// Returns the sum of f(i) over the body's nodes i, computed in parallel with equal results for any number
  /// of threads. Allocates no memory.
  template <class F>
  double operator()(const F& f) {
    parallel_short_chunks(nodes_, nodes_per_chunk,
                          [&](std::size_t first, std::size_t last, std::size_t chunk) {
                            double sum = 0;
                            for (std::size_t i = first; i < last; ++i) sum += f(static_cast<Eigen::Index>(i));
                            sums_[chunk] = sum;
                          });
    return ordered_sum(sums_);
  }

  static constexpr std::size_t nodes_per_chunk = 256;

 private:
  std::size_t nodes_;
  std::vector<double> sums_;  // one per chunk
};

}  // namespace prosector::soft
