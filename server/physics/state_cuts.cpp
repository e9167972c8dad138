#include "server/physics/state_cuts.h"

#include "server/physics/organs/topology_op_io.h"
#include "server/physics/soft/rungs.h"

namespace prosector {
namespace {

constexpr std::size_t most_pieces = 1 << 20;
constexpr std::size_t most_strokes = 1 << 20;  // of one blade at once

void add(ByteWriter& out, const Blade& blade) {
  out.add(static_cast<std::uint64_t>(blade.slot));
  out.add(blade.holder);
  out.add(blade.stroke);
  out.add(static_cast<std::uint8_t>(blade.cutting));
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
  blade.cutting = in.flag();
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

}  // namespace

void Simulation::Impl::save_cuts(ByteWriter& out) const {
  out.add(static_cast<std::uint64_t>(soft.size()));
  out.add(static_cast<std::uint64_t>(organs.size()));
  for (const auto& [first, organ] : organs) {
    out.add(static_cast<std::uint64_t>(first));
    organ.save(out);
    for (const OrganPiece& piece : organ.pieces()) {
      out.add(revisions[piece.body]);
      out.add(equilibrium[piece.body]);
    }
  }
  out.add(strokes);
  out.add(static_cast<std::uint64_t>(blades.size()));
  for (const Blade& blade : blades) add(out, blade);
}

/// Of pieces that are no bodies any more, in a state that is gone back to.
void Simulation::Impl::forget_bodies_from(std::size_t count) {
  lost.erase(lost.lower_bound(soft_id(count)), lost.end());
  std::erase_if(entangled, [&](const auto& entry) { return entry.first.second >= count; });
  for (std::size_t i = count; i < soft.size(); ++i)
    if (const auto id = static_cast<BroadPhase::Id>(i); soft_boxes.has(id)) soft_boxes.remove(id);
  const auto shorten = [&](auto& list) {
    if (list.size() > count) list.erase(list.begin() + static_cast<std::ptrdiff_t>(count), list.end());
  };
  shorten(model.soft);
  shorten(model.soft_collision);
  shorten(soft);
  shorten(equilibrium);
  shorten(surfaces);
  shorten(faces);
  shorten(faces_moved);
  shorten(soft_contacts);
  shorten(memories);
  shorten(rough);
  shorten(stored);
  shorten(layered);
  shorten(layers);
  shorten(folds);
  shorten(layers_moved);
  shorten(passed_through);
  shorten(inside_out);
  shorten(parted);
  shorten(revisions);
  shorten(numberings);
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(model.rigid.size() + soft.size()), parts.end());
  soft_pairs.clear();
}

RestoredCuts::RestoredCuts(Simulation::Impl& simulation)
    : simulation_(simulation), count_(simulation.model.scene.soft.size()) {
  for (const auto& [first, organ] : simulation.organs) {
    Piece& uncut = pieces_[first];
    uncut.first = first;
    uncut.solver = simulation.same_tissue(first, simulation.model.soft[first]->desc(), organ.whole());
    uncut.equilibrium = simulation.uncut_equilibrium[first];
  }
}

void RestoredCuts::read(ByteReader& in) {
  count_ = in.count(most_pieces);
  in.require(count_ >= simulation_.model.scene.soft.size(), "fewer bodies than the scene has");
  const std::size_t described = simulation_.model.scene.soft.size();
  for (std::size_t left = in.count(described); left > 0; --left) {
    const std::size_t first = in.count(described);
    in.require(first < described && !organs_.contains(first), "an organ that isn't there");
    read_organ(in, first);
  }
  for (std::size_t body = described; body < count_; ++body)
    in.require(pieces_.contains(body), "a body that is no piece of anything");
  strokes_ = in.number<std::uint64_t>();
  for (std::size_t left = in.count(simulation_.model.rigid.size()); left > 0; --left)
    blades_.push_back(read_blade(in, simulation_.blade_shapes));
}

void RestoredCuts::read_organ(ByteReader& in, std::size_t first) {
  const SoftBody& body = *simulation_.model.soft[first];
  in.require(mesh_kind(body.anatomy()) != MeshKind::rope, "a cut through a rope");
  const auto cut = simulation_.organs.find(first);
  const Anatomy& whole = cut == simulation_.organs.end() ? body.anatomy() : cut->second.whole();
  Organ& organ =
      organs_.try_emplace(first, first, whole, body.desc().density, simulation_.held_nodes_of(first))
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
      made.numbering = simulation_.numberings[piece.body];
    else
      made.solver = simulation_.make_piece(organ, piece.body, made.numbering);
    const SoftBody& solver = current ? *simulation_.model.soft[piece.body] : *made.solver;
    made.equilibrium = in.vector(3 * solver.nodes());
  }
}

bool RestoredCuts::is_current(std::size_t first, const Organ& organ) const {
  const auto now = simulation_.organs.find(first);
  return now != simulation_.organs.end() && bytes_of(now->second) == bytes_of(organ);
}

std::vector<const SoftBody*> RestoredCuts::bodies() const {
  std::vector<const SoftBody*> out(count_, nullptr);
  for (std::size_t body = 0; body < count_; ++body) {
    const auto piece = pieces_.find(body);
    out[body] = piece != pieces_.end() && piece->second.solver ? piece->second.solver.get()
                                                               : simulation_.model.soft[body].get();
  }
  return out;
}

void RestoredCuts::take_effect() {
  Simulation::Impl& s = simulation_;
  s.forget_bodies_from(count_);
  for (auto& [body, piece] : pieces_) {
    if (piece.solver) {
      SurfaceDetector surface = s.detector(*piece.solver);
      s.place_piece(body, piece.first, std::move(piece.solver), std::move(piece.numbering),
                    std::move(surface));
    }
    s.revisions[body] = piece.revision;
    s.equilibrium[body] = std::move(piece.equilibrium);
  }
  s.organs = std::move(organs_);
  s.blades = std::move(blades_);
  s.strokes = strokes_;
}

}  // namespace prosector
