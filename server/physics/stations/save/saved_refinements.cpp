#include "server/physics/stations/save/saved_refinements.h"

#include <utility>

#include "server/physics/stations/dissecting/piece_builder.h"

namespace prosector {
namespace {

constexpr std::size_t most_refined_edges = 1 << 24;

/// Saved refinement of one body.
struct RefinementRecord {
  std::vector<cutting::RefinedEdge> edges;
  bool touched = false;
};

template <class Io>
void entry(Io& io, typename Io::template Entry<RefinementRecord>& record) {
  auto& [edges, touched] = record;
  io.list(edges, most_refined_edges, "refined edge", [&](auto& edge) {
    auto& [a, b, left] = edge;
    io.number(a, "first end");
    io.number(b, "second end");
    io.number(left, "ticks left");
  });
  io.flag(touched, "touched");
}

}  // namespace

void save_refined(const State& state, RecordWriter& io) {
  for (const auto& [body, refined] : state.dissection.refined) {
    const auto in = io.scope("refinement of body", body);
    const RefinementRecord record{refined.mesh.edges(), refined.touched && refined.mesh.any()};
    entry(io, record);
  }
}

RestoredRefinements::RestoredRefinements(State& state) : state_(state) {
  for (const auto& [body, refined] : state.dissection.refined)
    refined_.emplace(body, Restored{refined.mesh.unrefined(refined.whole.tets), false, nullptr});
}

void RestoredRefinements::read(RecordReader& io, const RestoredCuts& cuts) {
  for (auto& [body, restored] : refined_) {
    RefinementRecord record;
    entry(io, record);
    io.require(record.edges.empty() || !cuts.is_cut(body),
               "the checkpoint is damaged: it has a body that is both cut and locally refined");
    restored.mesh.bisect(record.edges);
    restored.touched = record.touched;
  }
}

void RestoredRefinements::replace(std::vector<const soft::SoftBody*>& bodies) {
  for (auto& [body, restored] : refined_) {
    const organs::RefinedBody& now = state_.dissection.refined.at(body);
    const bool from_cuts = bodies[body] != state_.bodies.soft[body].solver.get();
    if (from_cuts && !restored.mesh.any()) continue;
    if (!from_cuts && now.mesh.edges() == restored.mesh.edges()) continue;
    organs::RefinedBody made = now;
    made.mesh = restored.mesh;
    restored.solver = same_tissue(state_.bodies, body, state_.bodies.soft[body].desc(),
                                  organs::refined_anatomy(made, organs::refined_mesh(made)));
    bodies[body] = restored.solver.get();
  }
}

void RestoredRefinements::take_effect() {
  for (auto& [body, restored] : refined_) {
    organs::RefinedBody& refined = state_.dissection.refined.at(body);
    refined.mesh = std::move(restored.mesh);
    refined.touched = restored.touched;
    refined.piece = organs::refined_mesh(refined);
    ++refined.rehung;
    if (!restored.solver) continue;
    contact::TissueSurface surface(restored.solver->anatomy());
    place_piece(state_, body, body, std::move(restored.solver), {}, std::move(surface));
    state_.bodies.soft[body].equilibrium =
        organs::refined_field(refined, refined.piece, state_.dissection.uncut_equilibrium[body]);
  }
}

}  // namespace prosector
