#pragma once
// Linear tetrahedra with a constitutive law as an ElasticModel.

#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector::soft {

/// Creates the elastic model of a body of linear tetrahedra under the material law called `law`.
/// `relaxation`: terms of viscoelastic stress relaxation, may be empty. Throws InputError for an unknown law.
std::unique_ptr<ElasticModel> make_tet4_model(const std::string& law, const Materials& materials,
                                              const std::vector<RelaxationDesc>& relaxation,
                                              const TetMesh& mesh);

/// Creates an elastic model of linear tetrahedra that resist changes of their volume only (make_volume_law).
/// It is added to the springs of a mass-spring solid.
std::unique_ptr<ElasticModel> make_tet4_volume_model(const Materials& materials, const TetMesh& mesh);

}  // namespace prosector::soft
