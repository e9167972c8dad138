#include "server/physics/soft/elastic_model.h"

#include "server/physics/soft/tet10_model.h"
#include "server/physics/soft/tet4_model.h"

namespace prosector {

std::unique_ptr<ElasticModel> make_elastic_model(const SoftDesc& desc, const Anatomy& anatomy) {
  if (desc.element == "tet10")
    return make_tet10_model(desc.model, lame(desc.youngs_modulus, desc.poisson_ratio), anatomy.tets);
  return make_tet4_model(desc, anatomy.tets);
}

}  // namespace prosector
