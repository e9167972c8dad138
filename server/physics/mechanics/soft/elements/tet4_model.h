#pragma once
// Linear tetrahedra with a constitutive law as an ElasticModel.

#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {

/// Creates a model of linear tetrahedra with the row of laws() called `law`. Throws InputError.
std::unique_ptr<ElasticModel> make_tet4_model(const std::string& law, const Materials& materials,
                                              const std::vector<RelaxationDesc>& relaxation,
                                              const TetMesh& mesh);

/// Creates a model whose elements resist changes of volume only, see make_volume_law.
std::unique_ptr<ElasticModel> make_tet4_volume_model(const Materials& materials, const TetMesh& mesh);

}  // namespace prosector
