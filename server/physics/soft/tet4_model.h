#pragma once
// Linear tetrahedra with a constitutive law as an ElasticModel.

#include "server/physics/soft/elastic_model.h"

namespace prosector {

/// `law` is a row of laws(). Throws InputError.
std::unique_ptr<ElasticModel> make_tet4_model(const SoftDesc& desc, const TetMesh& mesh);

}  // namespace prosector
