#include "server/physics/stations/compile/overlaps.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"
#include "server/physics/mechanics/contact/parting.h"

namespace prosector {
namespace {

bool is_solid(const contact::SoftSkin& skin) {
  return skin.faces != nullptr && skin.skin == 0;
}

void refuse_rigid_inside(const Bodies& bodies, Tissue& tissue) {
  const contact::SoftSkin skin = tissue.skin();
  if (!is_solid(skin)) return;
  for (std::size_t slot = 0; slot < bodies.model.rigid.size(); ++slot) {
    if (!bodies.rigid.used(slot) || !bodies.rigid.dynamic(slot) ||
        !collision::may_touch(bodies.rigid.mask(slot), tissue.collision.mask))
      continue;
    const Vec3 centre = bodies.rigid.motion(slot).pose.p;
    const auto nearest = skin.faces->nearest(centre);
    if (!nearest || skin.faces->winding_number(centre) < 0.5) continue;
    throw InputError(fmt::format(
        "[[rigid]] \"{}\" is placed inside [[soft]] \"{}\": its centre is {:.1f} mm below the surface, and "
        "nothing could separate them; move one of them, or name groups in `touches` so that they don't touch",
        bodies.model.rigid[slot].name, tissue.desc().name, 1e3 * nearest->distance));
  }
}

void report_overlap(Tissue& a, Tissue& b, const CompileOptions& options) {
  const contact::SoftSkin of_a = a.skin(), of_b = b.skin();
  if (!is_solid(of_a) || !is_solid(of_b)) return;
  const contact::Immersion a_in_b = contact::find_immersion(of_a, of_b, {}, {}),
                           b_in_a = contact::find_immersion(of_b, of_a, {}, {});
  if (!contact::is_deep(a_in_b, b_in_a, std::min(of_a.cell, of_b.cell))) return;
  options.progress(
      fmt::format("{} and {}: warning: they are placed in each other, up to {:.1f} mm deep; they are pushed "
                  "apart",
                  a.desc().name, b.desc().name, 1e3 * std::max(a_in_b.deepest, b_in_a.deepest)));
}

}  // namespace

void check_overlaps(State& state, const CompileOptions& options) {
  Bodies& bodies = state.bodies;
  for (std::size_t i = 0; i < bodies.soft.size(); ++i) {
    if (bodies.soft[i].collision.fidelity != Fidelity::mesh) continue;
    refuse_rigid_inside(bodies, bodies.soft[i]);
    for (std::size_t j = 0; j < i && options.progress; ++j)
      if (bodies.soft[j].collision.fidelity == Fidelity::mesh && bodies.may_meet(i, j))
        report_overlap(bodies.soft[j], bodies.soft[i], options);
  }
}

}  // namespace prosector
