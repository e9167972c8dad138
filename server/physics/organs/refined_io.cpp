#include "server/physics/organs/refined_io.h"

#include <algorithm>
#include <utility>

#include "server/physics/organs/piece_builder.h"

namespace prosector {
namespace {

std::vector<std::uint8_t> bytes_of(const LocalRefinement& mesh) {
  ByteWriter out;
  mesh.save(out);
  return out.bytes();
}

}  // namespace

bool any_refined(const State& state) {
  return std::any_of(state.dissection.refined.begin(), state.dissection.refined.end(),
                     [](const auto& entry) { return entry.second.mesh.any(); });
}

void save_refined(const State& state, ByteWriter& out) {
  for (const auto& [body, refined] : state.dissection.refined) {
    refined.mesh.save(out);
    if (refined.mesh.any()) out.add(static_cast<std::uint8_t>(refined.touched));
  }
}

RestoredRefinements::RestoredRefinements(State& state) : state_(state) {
  for (const auto& [body, refined] : state.dissection.refined)
    refined_.emplace(body, Restored{refined.mesh.unrefined(refined.whole.tets), false, nullptr});
}

void RestoredRefinements::read(ByteReader& in, const RestoredCuts& cuts) {
  for (auto& [body, restored] : refined_) {
    restored.mesh.load(in);
    in.require(!restored.mesh.any() || !cuts.is_cut(body), "a body that is both cut and refined");
    if (restored.mesh.any()) restored.touched = in.flag();
  }
}

void RestoredRefinements::replace(std::vector<const SoftBody*>& bodies) {
  for (auto& [body, restored] : refined_) {
    const RefinedBody& now = state_.dissection.refined.at(body);
    const bool from_cuts = bodies[body] != state_.bodies.soft[body].solver.get();
    if (from_cuts && !restored.mesh.any()) continue;
    if (!from_cuts && bytes_of(now.mesh) == bytes_of(restored.mesh)) continue;
    RefinedBody made = now;
    made.mesh = restored.mesh;
    restored.solver = same_tissue(state_.bodies, body, state_.bodies.soft[body].desc(),
                                  refined_anatomy(made, refined_mesh(made)));
    bodies[body] = restored.solver.get();
  }
}

void RestoredRefinements::take_effect() {
  for (auto& [body, restored] : refined_) {
    RefinedBody& refined = state_.dissection.refined.at(body);
    refined.mesh = std::move(restored.mesh);
    refined.touched = restored.touched;
    refined.piece = refined_mesh(refined);
    ++refined.rehung;
    if (!restored.solver) continue;
    TissueSurface surface(restored.solver->anatomy());
    place_piece(state_, body, body, std::move(restored.solver), {}, std::move(surface));
    state_.bodies.soft[body].equilibrium =
        refined_field(refined, refined.piece, state_.dissection.uncut_equilibrium[body]);
  }
}

}  // namespace prosector
