#include "server/physics/stations/save/saved_cuts.h"

#include "server/physics/mechanics/organs/cut_records.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/stations/dissecting/cut_by_blades.h"
#include "server/physics/stations/dissecting/piece_builder.h"
#include "server/physics/stations/dissecting/refining.h"

namespace prosector {
namespace {

using organs::entry;  // records of cuts

constexpr std::size_t most_strokes = 1 << 20;  // maximum number of simultaneous strokes of one blade

template <class Io>
void entry(Io& io, typename Io::template Entry<organs::Blade>& blade,
           const std::vector<organs::BladeShape>& shapes) {
  auto& [slot, holder, stroke, cutting, drawn, outside, cut_to, strokes] = blade;
  io.index(slot, shapes.size(), "instrument");
  const std::vector<organs::BladeShape::Edge>& edges = shapes[slot].edges;
  io.require(!edges.empty(), "a blade without an edge");
  io.number(holder, "holder");
  io.number(stroke, "stroke");
  io.flag(cutting, "cutting");
  io.flag(drawn, "drawn");
  io.number(outside, "seconds outside tissue");
  io.list(cut_to, organs::most_listed, "point of the edges",
          [&](auto& point) { io.vector(point, "position"); });
  std::size_t points = 0;
  for (const organs::BladeShape::Edge& edge : edges) points += edge.points.size();
  io.require(cut_to.size() == points, "a blade with other points");
  io.map(strokes, most_strokes, "stroke", [&](auto& where, auto& of_edge) {
    io.number(where.first, "organ");
    io.index(where.second, edges.size(), "edge");
    entry(io, of_edge);
    io.require(of_edge.points() == edges[where.second].points.size(), "a stroke of another edge");
  });
}

/// Returns whether two organs were cut alike, and have the same pieces.
bool equal_history(const organs::Organ& a, const organs::Organ& b) {
  return a.log().size() == b.log().size() && organs::begins_with(a.log(), b.log()) &&
         a.mark().pieces == b.mark().pieces;
}

/// Forgets pieces that are no bodies any more in a state that is gone back to.
void forget_bodies_from(State& state, std::size_t count) {
  Bodies& bodies = state.bodies;
  bodies.lost.erase(bodies.lost.lower_bound(bodies.soft_id(count)), bodies.lost.end());
  state.lingerers.forget_from(bodies.soft_id(count));
  std::erase_if(state.entangled, [&](const auto& entry) { return entry.first.second >= count; });
  while (bodies.soft.size() > count) bodies.soft.pop_back();
  bodies.parts.resize(bodies.count());
}

}  // namespace

void save_cuts(const State& state, RecordWriter& io) {
  const organs::Dissection& dissection = state.dissection;
  const std::deque<Tissue>& soft = state.bodies.soft;
  io.index(soft.size(), organs::most_soft_bodies, "soft bodies");
  io.map(dissection.organs, 0, "organ", [&](std::size_t first, const organs::Organ& organ) {
    io.index(first, soft.size(), "body");
    entry(io, organ.log());
    entry(io, organ.mark().pieces);
    for (const organs::OrganPiece& piece : organ.pieces()) {
      io.number(soft[piece.body].revision, "revision");
      io.vector(soft[piece.body].equilibrium, 0, "equilibrium");
    }
  });
  io.number(dissection.strokes, "strokes");
  io.list(dissection.blades, 0, "blade",
          [&](const organs::Blade& blade) { entry(io, blade, state.bodies.model.blades); });
}

RestoredCuts::RestoredCuts(State& state) : state_(state), count_(state.bodies.model.scene.soft.size()) {
  const std::deque<Tissue>& soft = state.bodies.soft;
  for (const auto& [first, organ] : state.dissection.organs) {
    Piece& uncut = pieces_[first];
    uncut.first = first;
    uncut.solver = same_tissue(state.bodies, first, soft[first].desc(), organ.whole());
    uncut.equilibrium = state.dissection.uncut_equilibrium[first];
  }
}

void RestoredCuts::read(RecordReader& io) {
  const Model& model = state_.bodies.model;
  const std::size_t described = model.scene.soft.size();
  io.index(count_, organs::most_soft_bodies, "soft bodies");
  io.require(count_ >= described, "the checkpoint is damaged: it has fewer soft bodies than the scene");
  std::size_t organs = 0;
  io.index(organs, described + 1, "organs");
  for (; organs > 0; --organs) {
    std::size_t first = 0;
    io.index(first, described, "body");
    io.require(!organs_.contains(first), "an organ twice");
    read_organ(io, first);
  }
  for (std::size_t body = described; body < count_; ++body)
    io.require(pieces_.contains(body),
               "the checkpoint is damaged: it has an additional body that is not a piece of any cut body");
  io.number(strokes_, "strokes");
  io.list(blades_, model.rigid.size(), "blade",
          [&](organs::Blade& blade) { entry(io, blade, model.blades); });
}

void RestoredCuts::read_organ(RecordReader& io, std::size_t first) {
  const soft::SoftBody& body = *state_.bodies.soft[first].solver;
  io.require(soft::mesh_kind(body.anatomy()) != soft::MeshKind::rope, "a cut through a rope");
  const auto cut = state_.dissection.organs.find(first);
  const Anatomy& whole =
      cut == state_.dissection.organs.end() ? unrefined_anatomy(state_, first) : cut->second.whole();
  organs::Organ& organ =
      organs_.try_emplace(first, first, whole, body.desc().material.density, held_nodes_of(state_, first))
          .first->second;
  organs::OrganLog log;
  organs::PieceMarks marks;
  entry(io, log);
  entry(io, marks);
  organ.restore(std::move(log), marks, count_);
  const bool current = is_current(first, organ);
  for (const organs::OrganPiece& piece : organ.pieces()) {
    const auto known = pieces_.find(piece.body);
    io.require(known == pieces_.end() || piece.body == first, "a piece of two organs");
    Piece& made = pieces_[piece.body];
    made = {};
    made.first = first;
    io.number(made.revision, "revision");
    if (current)
      made.numbering = state_.bodies.soft[piece.body].numbering;
    else
      made.solver = make_piece(state_.bodies, organ, piece.body, made.numbering);
    const soft::SoftBody& solver = current ? *state_.bodies.soft[piece.body].solver : *made.solver;
    io.vector(made.equilibrium, 3 * solver.nodes(), "equilibrium");
  }
}

bool RestoredCuts::is_current(std::size_t first, const organs::Organ& organ) const {
  const auto now = state_.dissection.organs.find(first);
  return now != state_.dissection.organs.end() && equal_history(now->second, organ);
}

std::vector<const soft::SoftBody*> RestoredCuts::bodies() const {
  std::vector<const soft::SoftBody*> out(count_, nullptr);
  for (std::size_t body = 0; body < count_; ++body) {
    const auto piece = pieces_.find(body);
    out[body] = piece != pieces_.end() && piece->second.solver ? piece->second.solver.get()
                                                               : state_.bodies.soft[body].solver.get();
  }
  return out;
}

void RestoredCuts::take_effect() {
  forget_bodies_from(state_, count_);
  for (auto& [body, piece] : pieces_) {
    if (piece.solver) {
      contact::TissueSurface surface(piece.solver->anatomy());
      place_piece(state_, body, piece.first, std::move(piece.solver), std::move(piece.numbering),
                  std::move(surface));
    }
    state_.bodies.soft[body].revision = piece.revision;
    state_.bodies.soft[body].equilibrium = std::move(piece.equilibrium);
  }
  state_.dissection.organs = std::move(organs_);
  state_.dissection.blades = std::move(blades_);
  state_.dissection.strokes = strokes_;
}

}  // namespace prosector
