#include "server/physics/mechanics/soft/make_model.h"

#include "server/physics/mechanics/soft/elements/tet10_model.h"
#include "server/physics/mechanics/soft/elements/tet4_model.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/springs/spring_model.h"
#include "server/physics/mechanics/soft/springs/tet_springs.h"

namespace prosector::soft {

std::unique_ptr<ElasticModel> make_elastic_model(const SoftDesc& desc, const Anatomy& anatomy) {
  check_rung(desc, anatomy);
  const bool tets = mesh_kind(anatomy) == MeshKind::tets;
  if (desc.configuration.model == "mass_spring" || !tets) {
    auto springs = make_spring_model(make_spring_network(desc.material, anatomy));
    const std::optional<Materials> volume = tets ? volume_springs(desc.material, anatomy.tets) : std::nullopt;
    if (!volume) return springs;
    return make_sum_model(std::move(springs), make_tet4_volume_model(*volume, anatomy.tets));
  }
  // Law of XPBD's pair of constraints.
  const std::string law =
      desc.configuration.is_position_based() ? "fem_neo_hookean_polynomial" : desc.configuration.model;
  const Materials materials =
      make_materials(desc.material, anatomy.tets, desc.configuration.is_position_based());
  if (desc.configuration.is_quadratic())
    return make_tet10_model(law, materials, desc.material.relaxation, anatomy.tets);
  return make_tet4_model(law, materials, desc.material.relaxation, anatomy.tets);
}

}  // namespace prosector::soft
