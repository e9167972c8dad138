#pragma once
// Elastic model of a spring network, and the sum of two models.

#include <vector>

#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"

namespace prosector {

std::unique_ptr<ElasticModel> make_spring_model(SpringNetwork network);

/// Creates the sum of two models' energies on the same nodes; rest shape and volumes are those of `a`.
std::unique_ptr<ElasticModel> make_sum_model(std::unique_ptr<ElasticModel> a,
                                             std::unique_ptr<ElasticModel> b);

}  // namespace prosector
