#include "server/physics/soft/elastic_model.h"

#include "server/physics/soft/tet4_model.h"

namespace prosector {

std::unique_ptr<ElasticModel> make_elastic_model(const SoftDesc& desc, const Anatomy& anatomy) {
  return make_tet4_model(desc, anatomy.tets);
}

}  // namespace prosector
