#pragma once
// Quadratic tetrahedra with a constitutive law as an ElasticModel.

#include "server/physics/soft/elements/elastic_model.h"
#include "server/physics/soft/laws/constitutive_law.h"

namespace prosector {

/// Makes a model of quadratic tetrahedra with mean_dilatation.h's remedy for locking. `law` is a row of
/// laws(); `mesh` has its edges' nodes (add_edge_nodes). Throws InputError.
std::unique_ptr<ElasticModel> make_tet10_model(const std::string& law, const Materials& materials,
                                               const std::vector<RelaxationDesc>& relaxation,
                                               const TetMesh& mesh);

}  // namespace prosector
