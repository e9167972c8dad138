#include "server/physics/organs/dissection_io.h"

#include "server/physics/organs/cutting.h"
#include "server/physics/organs/piece_builder.h"
#include "server/physics/organs/refining.h"
#include "server/physics/organs/topology_op_io.h"
#include "server/physics/soft/rungs.h"

namespace prosector {
namespace {

constexpr std::size_t most_soft_bodies = 1 << 20;
constexpr std::size_t most_strokes = 1 << 20;  // of one blade at once

void add(ByteWriter& out, const Blade& blade) {
  out.add(static_cast<std::uint64_t>(blade.slot));
  out.add(blade.holder);
  out.add(blade.stroke);
  out.add(static_cast<std::uint8_t>((blade.cutting ? 1 : 0) | (blade.drawn ? 2 : 0)));
  out.add(blade.outside);
  for (const Vec3& point : blade.cut_to) out.add(point);
  out.add(static_cast<std::uint64_t>(blade.strokes.size()));
  for (const auto& [where, stroke] : blade.strokes) {
    out.add(static_cast<std::uint64_t>(where.first));
    out.add(static_cast<std::uint64_t>(where.second));
    add(out, stroke);
  }
}

Blade read_blade(ByteReader& in, const std::vector<BladeShape>& shapes) {
  Blade blade;
  blade.slot = in.count(shapes.size());
  in.require(blade.slot < shapes.size() && !shapes[blade.slot].edges.empty(), "a blade without an edge");
  const std::vector<BladeShape::Edge>& edges = shapes[blade.slot].edges;
  blade.holder = in.number<ParticipantId>();
  blade.stroke = in.number<std::uint64_t>();
  const auto use = in.number<std::uint8_t>();
  in.require(use <= 3, "a blade that neither cuts nor doesn't");
  blade.cutting = (use & 1) != 0;
  blade.drawn = (use & 2) != 0;
  blade.outside = in.number<double>();
  for (const BladeShape::Edge& edge : edges)
    for (std::size_t k = 0; k < edge.points.size(); ++k) blade.cut_to.push_back(in.vector());
  for (std::size_t left = in.count(most_strokes); left > 0; --left) {
    const auto organ = in.number<std::uint64_t>(), edge = in.number<std::uint64_t>();
    in.require(edge < edges.size(), "a stroke of an edge that isn't there");
    BladeStroke& stroke = blade.strokes[{organ, edge}] = read_stroke(in);
    in.require(stroke.points() == edges[edge].points.size(), "a stroke of another edge");
  }
  return blade;
}

std::vector<std::uint8_t> bytes_of(const Organ& organ) {
  ByteWriter out;
  organ.save(out);
  return out.bytes();
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

void save_cuts(const State& state, ByteWriter& out) {
  const Dissection& dissection = state.dissection;
  const std::deque<Tissue>& soft = state.bodies.soft;
  out.add(static_cast<std::uint64_t>(soft.size()));
  out.add(static_cast<std::uint64_t>(dissection.organs.size()));
  for (const auto& [first, organ] : dissection.organs) {
    out.add(static_cast<std::uint64_t>(first));
    organ.save(out);
    for (const OrganPiece& piece : organ.pieces()) {
      out.add(soft[piece.body].revision);
      out.add(soft[piece.body].equilibrium);
    }
  }
  out.add(dissection.strokes);
  out.add(static_cast<std::uint64_t>(dissection.blades.size()));
  for (const Blade& blade : dissection.blades) add(out, blade);
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

void RestoredCuts::read(ByteReader& in) {
  const Model& model = state_.bodies.model;
  count_ = in.count(most_soft_bodies);
  in.require(count_ >= model.scene.soft.size(), "fewer bodies than the scene has");
  const std::size_t described = model.scene.soft.size();
  for (std::size_t left = in.count(described); left > 0; --left) {
    const std::size_t first = in.count(described);
    in.require(first < described && !organs_.contains(first), "an organ that isn't there");
    read_organ(in, first);
  }
  for (std::size_t body = described; body < count_; ++body)
    in.require(pieces_.contains(body), "a body that is no piece of anything");
  strokes_ = in.number<std::uint64_t>();
  for (std::size_t left = in.count(model.rigid.size()); left > 0; --left)
    blades_.push_back(read_blade(in, model.blades));
}

void RestoredCuts::read_organ(ByteReader& in, std::size_t first) {
  const SoftBody& body = *state_.bodies.soft[first].solver;
  in.require(mesh_kind(body.anatomy()) != MeshKind::rope, "a cut through a rope");
  const auto cut = state_.dissection.organs.find(first);
  const Anatomy& whole =
      cut == state_.dissection.organs.end() ? unrefined_anatomy(state_, first) : cut->second.whole();
  Organ& organ = organs_.try_emplace(first, first, whole, body.desc().density, held_nodes_of(state_, first))
                     .first->second;
  organ.load(in, count_);
  const bool current = is_current(first, organ);
  for (const OrganPiece& piece : organ.pieces()) {
    const auto known = pieces_.find(piece.body);
    in.require(known == pieces_.end() || piece.body == first, "a piece of two organs");
    Piece& made = pieces_[piece.body];
    made = {};
    made.first = first;
    made.revision = in.number<std::uint32_t>();
    if (current)
      made.numbering = state_.bodies.soft[piece.body].numbering;
    else
      made.solver = make_piece(state_.bodies, organ, piece.body, made.numbering);
    const SoftBody& solver = current ? *state_.bodies.soft[piece.body].solver : *made.solver;
    made.equilibrium = in.vector(3 * solver.nodes());
  }
}

bool RestoredCuts::is_current(std::size_t first, const Organ& organ) const {
  const auto now = state_.dissection.organs.find(first);
  return now != state_.dissection.organs.end() && bytes_of(now->second) == bytes_of(organ);
}

std::vector<const SoftBody*> RestoredCuts::bodies() const {
  std::vector<const SoftBody*> out(count_, nullptr);
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
      TissueSurface surface(piece.solver->anatomy());
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
