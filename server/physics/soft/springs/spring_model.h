#pragma once
// A network of springs as an ElasticModel, and models that add up.

#include <vector>

#include "server/physics/soft/elements/elastic_model.h"
#include "server/physics/soft/springs/spring_network.h"

namespace prosector {

std::unique_ptr<ElasticModel> make_spring_model(SpringNetwork network);

/// Returns the sum of two models' energies on the same nodes; rest shape and volumes are the first's.
std::unique_ptr<ElasticModel> make_sum_model(std::unique_ptr<ElasticModel> a,
                                             std::unique_ptr<ElasticModel> b);

}  // namespace prosector
