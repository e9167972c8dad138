#include "tests/bench/weighed_body.h"

#include "server/accuracy/act.h"
#include "server/accuracy/body_trial.h"

namespace prosector {

SoftDesc weighed_desc(const WeighedBody& body, const char* element, double poisson_ratio) {
  SoftDesc desc;
  desc.name = body.name;
  desc.configuration.model = tissue_law;
  desc.configuration.element = element;
  desc.material.youngs_modulus = weighed_modulus;
  desc.material.poisson_ratio = poisson_ratio;
  desc.material.density = weighed_density;
  constexpr double flat = 1e5, foot_stiffness = 1e13;  // m: sphere so large that it contains only the foot
  desc.attach.push_back({Vec3(body.size[0] / 2, -flat, body.size[2] / 2), flat + 1e-4, foot_stiffness});
  return desc;
}

Weighed::Weighed(const SoftDesc& desc, Anatomy mesh, double gravity) : body(desc, std::move(mesh)) {
  answer = body.settle(load_of({"weight", Vec3(0, gravity, 0), {}}, body));
}

}  // namespace prosector
