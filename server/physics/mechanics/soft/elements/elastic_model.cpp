#include "server/physics/mechanics/soft/elements/elastic_model.h"

namespace prosector::soft {

// Rows sum to zero, so a diagonal block is minus the sum of the others of its row, and each of these counts
// in two rows.
double ElasticModel::rest_trace() {
  double sum = 0;
  for (const Mat3& block : warped_stiffness(rest().data())) sum -= 2 * block.trace();
  return sum;
}

}  // namespace prosector::soft
