#pragma once
// Quadratic tetrahedra with a constitutive law as an ElasticModel.

#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {

/// Creates a model of quadratic tetrahedra, with the mean dilatation of mean_dilatation.h against volumetric
/// locking. `law` is a row of laws(); `mesh` must have edge nodes (add_edge_nodes). Throws InputError.
std::unique_ptr<ElasticModel> make_tet10_model(const std::string& law, const Materials& materials,
                                               const std::vector<RelaxationDesc>& relaxation,
                                               const TetMesh& mesh);

}  // namespace prosector
