#pragma once
// Linear tetrahedra with a constitutive law as an ElasticModel.

#include "server/physics/soft/constitutive_law.h"
#include "server/physics/soft/elastic_model.h"

namespace prosector {

/// With the row of laws() called `law`. Throws InputError.
std::unique_ptr<ElasticModel> make_tet4_model(const std::string& law, const Lame& constants,
                                              const TetMesh& mesh);

/// Elements that resist changes of volume only, see make_volume_law; Pa.
std::unique_ptr<ElasticModel> make_tet4_volume_model(double bulk_modulus, const TetMesh& mesh);

}  // namespace prosector
