#include "server/physics/mechanics/soft/soft_matter.h"

#include <fmt/format.h>

#include <utility>

#include "server/physics/mechanics/soft/make_model.h"
#include "server/physics/mechanics/soft/soft_body_setup.h"

namespace prosector::soft {
namespace {

/// Adds the edge nodes if the body has quadratic elements.
Anatomy nodes_for(const SoftDesc& desc, Anatomy anatomy, std::optional<QuadraticNodes>& quadratic) {
  if (!desc.configuration.is_quadratic()) return anatomy;
  SparseMap linear = anatomy.embedding;
  EdgeNodes edges = add_edge_nodes(anatomy);
  TetMesh eighths = divided(anatomy.tets, edges);
  quadratic = QuadraticNodes{std::move(edges), std::move(linear), std::move(eighths)};
  return anatomy;
}

std::unique_ptr<ElasticModel> usable_model(const SoftDesc& desc, const Anatomy& anatomy) {
  auto model = name_in_errors(desc, [&] { return make_elastic_model(desc, anatomy); });
  require(model->connectivity().size() > 0, desc,
          fmt::format("all {} elements of the mesh are degenerate (flat); at least one must have a volume, "
                      "area or length",
                      model->dropped_elements()));
  return model;
}

VecX borne_shares(const ElasticModel& model) {
  if (&model.shape_volume() == &model.volume()) return {};
  return model.shape_volume().cwiseQuotient(model.volume());
}

}  // namespace

SoftMatter::SoftMatter(const SoftDesc& d, Anatomy a)
    : desc((check_constants(d), d)),
      anatomy((check_mesh(d, a), nodes_for(d, std::move(a), quadratic))),
      model(usable_model(d, anatomy)),
      pattern(model->connectivity()),
      symmetric(pattern),
      mass(lumped_mass(d.material.density, model->volume())),
      ties(attachment_stiffness(d.attach, model->rest(), model->volume())),
      borne(borne_shares(*model)),
      inertia(mass),
      attached(ties),
      area(vertex_areas(anatomy)),
      diagonal(bounding_diagonal(model->rest())) {}

void SoftMatter::weigh() {
  inertia = mass / strength;
  attached = (tied ? 1 / strength : 0) * ties;
}

void SoftMatter::fit() {
  symmetric.fit(pattern);
  mass = lumped_mass(desc.material.density, model->volume());
  ties = attachment_stiffness(desc.attach, model->rest(), model->volume());
  borne = borne_shares(*model);
  weigh();
  diagonal = bounding_diagonal(model->rest());
}

bool SoftMatter::falls() const {
  const bool cut_loose = !desc.attach.empty() && ties.isZero();
  return desc.gravity || !tied || cut_loose;
}

}  // namespace prosector::soft
