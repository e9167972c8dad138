#include "server/physics/stations/touching/fit_tissue.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"
#include "server/physics/mechanics/soft/rungs.h"

namespace prosector {
namespace {

bool has_blades(const Model& model) {
  return std::any_of(model.blades.begin(), model.blades.end(),
                     [](const organs::BladeShape& blade) { return !blade.edges.empty(); });
}

bool can_fall_apart(const Tissue& tissue) {
  const collision::CollisionMask& mask = tissue.collision.mask;
  return soft::mesh_kind(tissue.anatomy()) == soft::MeshKind::sheet && collision::may_touch(mask, mask);
}

/// Returns whether two bodies may touch as thin shells. A sheet that can be cut has self-contact from the
/// start, for its future pieces: a checkpoint's content must not depend on whether it was cut.
bool meet_as_thin_shells(const Tissue& a, const Tissue& b, bool with_blades) {
  const contact::SoftCollision &first = a.collision, &second = b.collision;
  if (!a.is_thin() || !b.is_thin() || first.fidelity != Fidelity::mesh || second.fidelity != Fidelity::mesh)
    return false;
  return a.index == b.index ? first.with_itself || (with_blades && can_fall_apart(a))
                            : collision::may_touch(first.mask, second.mask);
}

}  // namespace

void fit_to_mesh(State& state, std::size_t body, Numbering numbering) {
  const std::deque<Tissue>& all = state.bodies.soft;
  Tissue& tissue = state.bodies.soft[body];
  tissue.numbering = std::move(numbering);
  tissue.stored.reset();
  state.lingerers.forget(state.bodies.soft_id(body));
  tissue.surface.fit(tissue.collision, !tissue.numbering.triangles.empty());
  std::erase_if(state.layer_sides,
                [&](const auto& entry) { return entry.first.first == body || entry.first.second == body; });
  if (tissue.collision.with_itself && !tissue.is_thin() && tissue.surface.faces()) {
    const bool closed = tissue.surface.fit_self_collision(tissue.collision.cell);
    if (!closed && state.dissection.organs.empty())
      throw InputError(
          fmt::format("[[soft]] \"{}\": self_contact needs a closed surface without holes; close the surface "
                      "or omit self_contact",
                      tissue.desc().name));
  }
  const bool with_blades = has_blades(state.bodies.model);
  tissue.surface.set_thin_shell(std::any_of(all.begin(), all.end(), [&](const Tissue& other) {
    return meet_as_thin_shells(tissue, other, with_blades);
  }));
  tissue.place_surface();
}

bool has_thin_shells(const Bodies& bodies) {
  return std::any_of(bodies.soft.begin(), bodies.soft.end(),
                     [](const Tissue& tissue) { return tissue.surface.thin_shell(); });
}

}  // namespace prosector
