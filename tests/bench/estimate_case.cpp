#include "tests/bench/estimate_case.h"

#include <fmt/format.h>

#include <cmath>

#include "common/anatomy/kuhn_box.h"
#include "common/error.h"
#include "common/paths.h"
#include "server/accuracy/body_estimator.h"
#include "server/accuracy/body_trial.h"
#include "server/accuracy/foot.h"
#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/soft_matter.h"
#include "server/physics/stations/compile/sources.h"

namespace prosector {
namespace {

const Vec3 gravity(0, -9.81, 0);
constexpr double far_away = 1e4;  // m: radius of spheres that serve as planes
constexpr double left_by_halving =
    1. / 3;  // fraction of the difference that remains: second-order convergence

/// Describes tissue that is pinned where x or y (axis 0, 1) is 0.
SoftDesc pinned(int axis, double youngs_modulus, double ratio) {
  SoftDesc desc;
  desc.name = "body";
  desc.material.youngs_modulus = youngs_modulus;
  desc.material.poisson_ratio = ratio;
  desc.material.density = 1000;
  desc.attach.push_back({-far_away * Vec3::Unit(axis), far_away + 1e-4, 1e13});
  return desc;
}

EstimateCase boxed(const char* name, const SoftDesc& desc, const Vec3& size,
                   std::array<std::uint32_t, 3> cells) {
  EstimateCase out{name, desc, {kuhn_box(size, cells[0], cells[1], cells[2]), {}, {}}, {}};
  out.acts = acts_of(desc, out.mesh.tets, gravity, 1);
  std::erase_if(out.acts, [](const Act& act) { return act.name == "on its side"; });
  return out;
}

/// Returns the liver's case: the CT liver packaged by Debian, or the built-in shape if it is missing.
std::vector<EstimateCase> liver(double ratio) {
  SceneDesc scene;
  SoftDesc& desc = scene.soft.emplace_back();
  desc.name = "liver";
  desc.geometry.shape = "liver";
  desc.geometry.size = {0.2, 0.12, 0.16};
  desc.geometry.cell = 0.025;
  desc.material.youngs_modulus = 5000;
  desc.material.poisson_ratio = ratio;
  desc.material.density = 1000;
  CompileOptions compile;
  compile.data_dirs = {default_data_dir()};
  const Anatomy anatomy = soft_anatomy(desc, scene, compile);
  EstimateCase out{"liver", desc, {anatomy.tets, {}, {}}, {}};
  out.mesh.tets.stretch = nullptr;
  out.acts = acts_of(desc, out.mesh.tets, gravity, 2);
  std::erase_if(out.acts, [](const Act& act) { return act.name == "hung"; });
  return {out};
}

/// Divides each tetrahedron into eight, with positive volumes.
Anatomy divided_mesh(const Anatomy& anatomy) {
  Anatomy fine;
  fine.tets = anatomy.tets;
  fine.tets = soft::divided(fine.tets, soft::add_edge_nodes(fine));
  for (auto& tet : fine.tets.tets) {
    const auto from_first = [&](std::size_t k) -> Vec3 {
      return fine.tets.positions[tet[k]] - fine.tets.positions[tet[0]];
    };
    if (from_first(1).cross(from_first(2)).dot(from_first(3)) < 0) std::swap(tet[0], tet[1]);
  }
  return fine;
}

/// Static solution of a body under one load.
struct Rested {
  StaticAnswer answer;
  double compliance;  // J: work of the load
};

struct Modelled {
  Modelled(const EstimateCase& one, const Anatomy& mesh, const char* model, const char* element)
      : desc(one.desc), body(with(desc, model, element), mesh) {
    if (const auto foot = foot_of(desc, mesh.tets, gravity)) body.tie(ties_of(*foot, body));
  }
  static const SoftDesc& with(SoftDesc& desc, const char* model, const char* element) {
    desc.configuration.model = model;
    desc.configuration.element = element;
    return desc;
  }
  Rested rest(const Act& act) {
    const VecX load = load_of(act, body);
    Rested out{body.settle(load), 0};
    out.compliance = load.dot(out.answer.x - body.rest());
    return out;
  }
  SoftDesc desc;
  StaticBody body;
};

struct Judged {
  Estimate estimate;
  double us_a_piece;
};

Judged estimated(const Modelled& modelled, const Act& act, const StaticAnswer& at_rest) {
  BodyEstimator estimator(modelled.desc, modelled.body.mesh(), modelled.body.matter().ties, tissue_law);
  BodyMoment moment;
  moment.x = at_rest.x;
  moment.slip = VecX::Zero(moment.x.size());
  moment.acceleration = act.weight.replicate(moment.x.size() / 3, 1);
  estimator.begin(moment);
  const double begun = cpu_ms();
  estimator.go_on(estimator.pieces());
  const double ms = cpu_ms() - begun;
  return {estimator.newest(), 1e3 * ms / static_cast<double>(estimator.mesh().tets.size())};
}

}  // namespace

std::vector<EstimateCase> estimate_cases(bool quick) {
  if (quick) return {boxed("cube", pinned(1, 5400, 0.45), Vec3::Constant(0.1), {2, 2, 2})};
  std::vector<EstimateCase> out;
  for (const double ratio : {0.3, 0.45, 0.49}) {
    out.push_back(boxed("beam", pinned(0, 3e5, ratio), {0.4, 0.1, 0.1}, {8, 2, 2}));
    out.push_back(boxed("cube", pinned(1, 5400, ratio), Vec3::Constant(0.1), {4, 4, 4}));
    out.push_back(boxed("slab", pinned(1, 5400, ratio), {0.2, 0.06, 0.2}, {7, 3, 7}));
    out.push_back(boxed("layer", pinned(1, 5000, ratio), {0.04, 0.02, 0.04}, {8, 4, 8}));
    for (EstimateCase& one : liver(ratio)) out.push_back(std::move(one));
  }
  return out;
}

std::vector<ReportRow> judged(const EstimateCase& one) {
  std::vector<ReportRow> out;
  Modelled fine(one, divided_mesh(one.mesh), tissue_law, "tet10"), coarse(one, one.mesh, tissue_law, "tet10");
  std::vector<double> truth, unsettled;
  for (const Act& act : one.acts) {
    const Rested settled = fine.rest(act), other = coarse.rest(act);
    unsettled.push_back(left_by_halving * (settled.compliance - other.compliance));
    truth.push_back(settled.answer.usable() && other.answer.usable() ? settled.compliance + unsettled.back()
                                                                     : std::nan(""));
    unsettled.back() /= truth.back();
  }
  for (const char* element : {"tet4", "tet10"})
    for (const char* model : {"fem_corotational", tissue_law}) {
      Modelled modelled(one, one.mesh, model, element);
      for (std::size_t k = 0; k < one.acts.size(); ++k) {
        const Rested rested = modelled.rest(one.acts[k]);
        if (!rested.answer.usable() || std::isnan(truth[k])) continue;
        const Judged found = estimated(modelled, one.acts[k], rested.answer);
        const double error = 1 - rested.compliance / truth[k];
        const ErrorParts& parts = found.estimate.parts;
        out.push_back({{"case", one.name},
                       {"act", one.acts[k].name},
                       {"poisson_ratio", one.desc.material.poisson_ratio},
                       {"model", model},
                       {"element", element},
                       {"tets", one.mesh.tets.tets.size()},
                       {"error_continuum", error},
                       {"unsettled", unsettled[k]},
                       {"estimate", found.estimate.error},
                       {"discretisation", parts.discretisation},
                       {"model_part", parts.model},
                       {"press", found.estimate.press},
                       {"effectivity", found.estimate.error / std::abs(error)},
                       {"us_per_tet", found.us_a_piece}});
      }
    }
  return out;
}

}  // namespace prosector
