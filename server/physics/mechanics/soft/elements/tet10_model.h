#pragma once
// Quadratic tetrahedra with a constitutive law as an ElasticModel.

#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector::soft {

/// Creates the elastic model of a body of quadratic tetrahedra under the material law called `law`. Mean
/// dilatation (mean_dilatation.h) prevents volumetric locking. `relaxation`: terms of viscoelastic stress
/// relaxation, may be empty. `mesh` must have edge nodes (add_edge_nodes). Throws InputError for an unknown
/// law.
std::unique_ptr<ElasticModel> make_tet10_model(const std::string& law, const Materials& materials,
                                               const std::vector<RelaxationDesc>& relaxation,
                                               const TetMesh& mesh);

}  // namespace prosector::soft
