#include "server/physics/soft/elements/elastic_model.h"

namespace prosector {

// Rows sum to zero: a diagonal block is minus the others of its row, and each of those stands in two rows.
double ElasticModel::rest_trace() {
  double sum = 0;
  for (const Mat3& block : warped_stiffness(rest().data())) sum -= 2 * block.trace();
  return sum;
}

}  // namespace prosector
