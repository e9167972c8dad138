#pragma once
// Elastic model of a spring network, and the sum of two models.

#include <vector>

#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"

namespace prosector::soft {

std::unique_ptr<ElasticModel> make_spring_model(SpringNetwork network);

/// Creates an elastic model whose energy is the sum of the energies of `a` and `b`, two models on the same
/// nodes. Rest shape and nodal volumes are those of `a`.
std::unique_ptr<ElasticModel> make_sum_model(std::unique_ptr<ElasticModel> a,
                                             std::unique_ptr<ElasticModel> b);

}  // namespace prosector::soft
