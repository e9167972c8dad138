// Last phase: what blades cut, and what is undone. Pieces that come free become bodies.

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <exception>
#include <limits>

#include "common/error.h"
#include "server/physics/cutting/carry.h"
#include "server/physics/organs/momentum.h"
#include "server/physics/organs/sheet_parts.h"
#include "server/physics/organs/tet_lineage.h"
#include "server/physics/simulation_impl.h"
#include "server/physics/soft/rungs.h"

namespace prosector {

/// Where an organ's nodes are, by id.
std::vector<Vec3> Simulation::Impl::node_positions(const Organ& organ) const {
  std::vector<Vec3> out(organ.complex().node_end(), Vec3::Zero());
  for (const OrganPiece& piece : organ.pieces())
    for (std::size_t n = 0; n < piece.mesh.nodes.size(); ++n)
      out[piece.mesh.nodes[n]] = soft[piece.body].motion.x.segment<3>(3 * static_cast<Eigen::Index>(n));
  return out;
}

/// A stroke through a sheet knows its edge in the room only: it goes with the sheet as the edge's points do.
void Simulation::Impl::carry_beside_sheet(BladeStroke& stroke, const Blade& blade, std::size_t edge,
                                          std::span<const Vec3> from) const {
  std::size_t first = 0;
  for (std::size_t e = 0; e < edge; ++e) first += blade_shapes[blade.slot].edges[e].points.size();
  for (std::size_t k = 0; k < from.size(); ++k) stroke.edge[k].room += from[k] - blade.cut_to[first + k];
}

bool Simulation::Impl::can_cut(std::size_t body, bool with_ray) const {
  const MeshKind kind = mesh_kind(model.soft[body]->anatomy());
  return kind != MeshKind::rope && (!with_ray || kind == MeshKind::sheet) &&
         model.soft_collision[body].fidelity != Fidelity::none;
}

/// With the scene, so that no tick waits for it.
void Simulation::Impl::make_organs_ready() {
  for (std::size_t body = 0; body < model.soft.size(); ++body) {
    const bool is_cut = std::any_of(blade_shapes.begin(), blade_shapes.end(), [&](const BladeShape& blade) {
      return std::any_of(blade.edges.begin(), blade.edges.end(),
                         [&](const BladeShape::Edge& edge) { return can_cut(body, edge.ray); });
    });
    if (!is_cut) continue;
    const SoftBody& soft_body = *model.soft[body];
    try {
      uncut_organs.try_emplace(body, body, soft_body.anatomy(), soft_body.desc().density,
                               held_nodes_of(body));
    } catch (const InputError&) {  // can't be cut: said when a blade comes to it
    }
  }
}

/// Throws InputError for a mesh that can't be cut.
Organ& Simulation::Impl::organ_of(std::size_t body) {
  if (const auto cut = organs.find(body); cut != organs.end()) return cut->second;
  if (auto ready = uncut_organs.extract(body)) return organs.insert(std::move(ready)).position->second;
  const SoftBody& soft_body = *model.soft[body];
  return organs.try_emplace(body, body, soft_body.anatomy(), soft_body.desc().density, held_nodes_of(body))
      .first->second;
}

/// Takes an edge of a blade on, through whatever tissue there is.
void Simulation::Impl::cut_tissue(Blade& blade, std::size_t edge, std::span<const Vec3> from,
                                  std::span<const Vec3> to) {
  const Aabb swept = swept_box(from, to);
  const bool ray = blade_shapes[blade.slot].edges[edge].ray;
  for (std::size_t first = 0; first < model.scene.soft.size(); ++first) {
    if (!can_cut(first, ray)) continue;
    const auto cut_before = organs.find(first);
    const auto reaches = [&](std::size_t body) {
      return !parts[soft_id(body)].out_of_touch() && outer_box(body).overlaps(swept);
    };
    bool near = cut_before == organs.end() && reaches(first);
    if (cut_before != organs.end())
      for (const OrganPiece& piece : cut_before->second.pieces())
        near |= piece.whole() && reaches(piece.body);
    if (!near) {
      blade.strokes.erase({first, edge});
      continue;
    }
    try {
      cut_organ(blade, edge, first, from, to);
    } catch (const InputError& error) {  // a mesh that can't be cut: with flat elements, say
      BodyReport& row = report.bodies.emplace_back();
      row.body = model.soft[first]->desc().name;
      row.note = error.what();
    }
  }
}

/// Throws InputError, and changes nothing, where that can't be.
void Simulation::Impl::cut_organ(Blade& blade, std::size_t edge, std::size_t first,
                                 std::span<const Vec3> from, std::span<const Vec3> to) {
  Organ& organ = organ_of(first);
  const auto [stroke, begins] = blade.strokes.try_emplace({first, edge});
  if (begins)
    stroke->second = begin_stroke(from);
  else if (organ.complex().is_sheet())
    carry_beside_sheet(stroke->second, blade, edge, from);
  std::vector<Vec3>& positions = organ_positions[first];
  if (positions.empty()) positions = node_positions(organ);
  const CutResult result = organ.cut(positions, to, stroke->second, blade.holder, blade.stroke);
  for (const TopologyOp& op : result.ops) carry(op, positions);
  cut_figures.split_tets += result.split_tets;
  cut_figures.slivers += result.slivers;
  cut_figures.least_dihedral_deg = std::min(cut_figures.least_dihedral_deg, result.least_dihedral_deg);
}

void Simulation::Impl::obey(const CutEvent& event) {
  std::string& answer = report.cut_answers.emplace_back();
  if (event.kind == CutEvent::Kind::rewind) {
    answer = rewind(event);
    return;
  }
  Organ* last = nullptr;
  std::uint64_t stroke = 0;
  for (auto& [first, organ] : organs)
    if (const auto newest = organ.last_stroke(event.participant); newest && *newest >= stroke) {
      stroke = *newest;
      last = &organ;
    }
  if (last == nullptr) {
    answer = "there is no cut of yours to undo";
    return;
  }
  const Organ::Mark before = last->mark();
  answer = last->undo(event.participant);
  if (answer.empty())
    answer = carry_through(last->pieces().front().body, before, TopologyCause::undo, event.participant);
}

/// The solver of a piece: named after the organ, and of its material.
std::unique_ptr<SoftBody> Simulation::Impl::make_piece(const Organ& organ, std::size_t body,
                                                       Numbering& numbering) const {
  const std::size_t first = organ.pieces().front().body;
  SoftDesc desc = model.soft[first]->desc();
  if (body != first) desc.name = fmt::format("{} piece {}", desc.name, body - model.scene.soft.size() + 1);
  return std::make_unique<SoftBody>(desc, organ.anatomy(organ.piece(body), numbering));
}

/// Puts a solver in the place of the body's, or at the end, where the body is new; none: it has followed.
void Simulation::Impl::place_piece(std::size_t body, std::size_t first, std::unique_ptr<SoftBody> solver,
                                   Numbering numbering, SurfaceDetector surface) {
  if (body == model.soft.size()) {
    model.soft.push_back(std::move(solver));
    model.soft_collision.push_back(model.soft_collision[first]);
    soft.emplace_back();
    equilibrium.emplace_back();
    parts.push_back(parts[soft_id(first)]);
  } else if (solver) {
    retired.push_back(std::exchange(model.soft[body], std::move(solver)));
  }
  soft[body] = model.soft[body]->initial_state();
  equilibrium[body] = soft[body].motion.x;
  fit_to_mesh(body, std::move(surface), std::move(numbering));
}

/// A body in the making.
struct Simulation::Impl::NewPiece {
  std::size_t body = 0;
  bool whole = true;                 // else it was joined to another
  std::optional<MeshEdit> edit;      // which the solver that is there follows; else there is a new one
  PieceSurface skin;                 // with it
  std::unique_ptr<SoftBody> solver;  // a new one
  Numbering numbering;
  std::optional<SurfaceDetector> surface;
  std::uint64_t content_hash = 0;
  Motion motion;  // of a whole one: as what was there moved
  VecX equilibrium, history;
};

/// Of the pieces that an organ's change left or made. Changes nothing: what can fail fails here.
std::vector<Simulation::Impl::NewPiece> Simulation::Impl::make_pieces(const Organ& organ,
                                                                      const Organ::Regrouped& changed) const {
  const auto make = [&](std::size_t body, NewPiece& made) {
    const OrganPiece& piece = organ.piece(body);
    made.body = body;
    made.whole = piece.whole();
    made.edit = organ.edit_since(changed, piece);
    if (made.edit && !model.soft[body]->can_follow(*made.edit)) made.edit.reset();
    tbb::parallel_invoke(
        [&] {
          if (made.edit)
            made.skin = organ.surface(piece);
          else
            made.solver = make_piece(organ, body, made.numbering);
        },
        [&] {
          if (made.whole) carry_motion(organ, changed.before, piece, made);
        });
    if (made.solver) fit_around(*made.solver, made);
  };
  std::vector<NewPiece> out(changed.bodies.size());
  std::vector<std::exception_ptr> failed(out.size());
  tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
    try {
      make(changed.bodies[i], out[i]);
    } catch (...) {
      failed[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : failed)  // the first of them, whichever came first
    if (error) std::rethrow_exception(error);
  return out;
}

/// What else is found of a solver's mesh.
void Simulation::Impl::fit_around(const SoftBody& solver, NewPiece& made) const {
  tbb::parallel_invoke([&] { made.surface.emplace(detector(solver)); },
                       [&] { made.content_hash = solver.content_hash(); });
}

/// Takes the solvers along that can go on. Nothing fails any more.
void Simulation::Impl::follow_changes(std::span<NewPiece> pieces) {
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    NewPiece& piece = pieces[i];
    if (!piece.edit) return;
    SoftBody& solver = *model.soft[piece.body];
    piece.numbering = std::move(piece.skin.numbering);
    solver.follow(*piece.edit, std::move(piece.skin.surface), std::move(piece.skin.embedding));
    fit_around(solver, piece);
  });
}

/// Where its nodes are and how they move: as what was there did.
void Simulation::Impl::carry_motion(const Organ& organ, std::span<const OrganPiece> before,
                                    const OrganPiece& piece, NewPiece& made) const {
  std::vector<const PieceMesh*> meshes;
  for (const OrganPiece& old : before) meshes.push_back(&old.mesh);
  const bool quadratic = model.soft[before.front().body]->desc().element == "tet10";
  const NodeTransfer transfer(organ.complex(), meshes, piece.mesh, quadratic);
  const auto carried = [&](const auto& field) {
    std::vector<const VecX*> fields;
    for (const OrganPiece& old : before) fields.push_back(&field(old.body));
    return transfer(fields);
  };
  for (VecX Motion::*field : {&Motion::x, &Motion::v, &Motion::x_prev, &Motion::v_prev})
    made.motion.*field = carried([&](std::size_t body) -> const VecX& { return soft[body].motion.*field; });
  made.equilibrium = carried([&](std::size_t body) -> const VecX& { return equilibrium[body]; });
  std::vector<const VecX*> histories;
  auto numbers = std::numeric_limits<Eigen::Index>::max();
  for (const OrganPiece& old : before) {
    histories.push_back(&soft[old.body].history);
    const bool all = model.soft[old.body]->dropped_elements() == 0;
    numbers = std::min(numbers, all ? history_per_tet(*histories.back(), old.mesh) : 0);
  }
  made.history = carried_history(organ.complex(), meshes, histories, numbers, piece.mesh.tets);
}

/// Puts a piece in the place of the body that had its index, if any.
void Simulation::Impl::place(NewPiece piece, std::size_t first, TopologyCause cause, ParticipantId author) {
  const std::size_t body = piece.body;
  const bool is_new = body == model.soft.size();
  place_piece(body, first, std::move(piece.solver), std::move(piece.numbering), std::move(*piece.surface));
  memories[body].clear();
  if (!is_new) ++revisions[body];
  if (piece.whole) {
    set_going(body, first, std::move(piece.motion), std::move(piece.equilibrium));
    if (piece.history.size() == soft[body].history.size()) soft[body].history = std::move(piece.history);
  } else {
    parts[soft_id(body)].hidden = true;
  }
  take_effect(world, soft_id(body));
  place_surface(body);
  TopologyChange& change = tell_of(body, piece.content_hash, cause, author);
  if (is_new) change.piece_of = soft_id(first);
}

/// A piece moves as what was there did. One that nothing ties to its place any more is out of it.
void Simulation::Impl::set_going(std::size_t body, std::size_t first, Motion motion, VecX balance) {
  soft[body].motion = std::move(motion);
  soft[body].asleep = false;
  equilibrium[body] = std::move(balance);
  if (body != first && model.soft[body]->attachment_stiffness().isZero())
    parts[soft_id(body)].attached = false;
}

TopologyChange& Simulation::Impl::tell_of(std::size_t body, std::uint64_t content_hash, TopologyCause cause,
                                          ParticipantId author) {
  TopologyChange& change = report.topology.emplace_back();
  change.body = soft_id(body);
  change.revision = revisions[body];
  change.content_hash = content_hash;
  change.cause = cause;
  change.author = author;
  return change;
}

void Simulation::Impl::keep_momentum_of(const Organ& organ, const Organ::Regrouped& changed,
                                        std::span<NewPiece> made) {
  std::vector<PieceMotion> before, now;
  for (const OrganPiece& old : changed.before)
    before.push_back({old.mesh.nodes, &model.soft[old.body]->node_mass(), &soft[old.body].motion.x,
                      &soft[old.body].motion.v});
  for (NewPiece& piece : made)
    if (piece.whole)
      now.push_back(
          {organ.piece(piece.body).mesh.nodes, &piece.solver->node_mass(), &piece.motion.x, &piece.motion.v});
  // Where pieces are joined, places jump with the nodes that go: what that does to spin is no cut's.
  keep_momentum(before, now, organ.log().back().cause == TopologyCause::cut);
}

/// Makes bodies of the pieces that an organ's change left or made.
void Simulation::Impl::remake(Organ& organ, TopologyCause cause, ParticipantId author) {
  if (follow_cut(organ, cause, author)) return;
  const std::size_t first = organ.pieces().front().body;
  const Organ::Regrouped changed = organ.regroup(model.soft.size());
  std::vector<NewPiece> pieces = make_pieces(organ, changed);
  if (organ.complex().is_sheet()) keep_momentum_of(organ, changed, pieces);
  follow_changes(pieces);
  for (NewPiece& piece : pieces) place(std::move(piece), first, cause, author);
  keep_holds(changed.bodies);
}

/// The same, but leaves everything as it was before the change where that can't be. Empty when done, else why
/// not.
std::string Simulation::Impl::carry_through(std::size_t first, const Organ::Mark& before, TopologyCause cause,
                                            ParticipantId author) {
  Organ& organ = organs.at(first);
  try {
    remake(organ, cause, author);
    return {};
  } catch (const std::exception& error) {
    for (Blade& blade : blades)
      std::erase_if(blade.strokes, [&](const auto& stroke) { return stroke.first.first == first; });
    if (before.changes == 0)
      organs.erase(first);
    else
      organ.back_to(before, model.soft.size());
    return error.what();
  }
}

/// Hands go on holding what is nearest to where they held it.
void Simulation::Impl::keep_holds(const std::vector<std::size_t>& bodies) {
  for (Hand& hand : hands) {
    if (!hand.hold || !is_soft(hand.hold->body)) continue;
    if (!std::binary_search(bodies.begin(), bodies.end(), soft_index(hand.hold->body))) continue;
    const Pose centre = world.motion(hand.slot).pose;
    struct Nearest {
      std::size_t body = 0;
      std::uint32_t vertex = 0;
      double distance = std::numeric_limits<double>::infinity();
    };
    std::vector<Nearest> found;
    for (const Hold::Point& p : hand.hold->points) {
      Nearest& best = found.emplace_back();
      for (const std::size_t body : bodies) {
        const auto x = surfaces[body].positions();
        for (std::uint32_t v = 0; v < x.size(); ++v)
          if (const double d = (x[v] - centre * p.in_hand).squaredNorm(); d < best.distance)
            best = {body, v, d};
      }
    }
    // One hand holds one body: that of most points.
    std::map<std::size_t, std::size_t> points;
    for (const Nearest& n : found) ++points[n.body];
    const auto most = std::max_element(points.begin(), points.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    Hold& hold = *hand.hold;
    hold.body = soft_id(most->first);
    std::vector<Hold::Point> kept;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].body != most->first) continue;
      kept.push_back(hold.points[i]);
      kept.back().vertex = found[i].vertex;
    }
    hold.points = std::move(kept);
  }
}

void Simulation::Impl::cut_soft_bodies(const TickInput& input) {
  organ_positions.clear();
  cut_figures = {};
  const std::uint64_t before = log_length();
  std::map<std::size_t, Organ::Mark> marks;  // of organs, before they were cut
  for (const auto& [first, organ] : organs) marks[first] = organ.mark();
  std::map<std::size_t, ParticipantId> cut;  // organ → whose cut
  for (Blade& blade : blades) {
    std::map<std::size_t, std::size_t> lengths;
    for (const auto& [first, organ] : organs) lengths[first] = organ.log().size();
    advance(blade);
    for (const auto& [first, organ] : organs)
      if (organ.log().size() > lengths[first]) cut[first] = blade.holder;
  }
  for (const auto& [first, author] : cut)
    if (const std::string failed = carry_through(first, marks[first], TopologyCause::cut, author);
        !failed.empty()) {
      BodyReport& row = report.bodies.emplace_back();
      row.body = model.soft[first]->desc().name;
      row.note = fmt::format("the cut was taken back: {}", failed);
    }
  for (const CutEvent& event : input.cuts) obey(event);
  if (log_length() > before) report_cuts();
}

std::uint64_t Simulation::Impl::log_length() const {
  std::uint64_t sum = 0;
  for (const auto& [first, organ] : organs) sum += organ.log().size();
  return sum;
}

/// What a cut could not keep above the floor.
void Simulation::Impl::report_cuts() {
  if (cut_figures.slivers == 0) return;
  BodyReport& row = report.bodies.emplace_back();
  row.body = "cut";
  row.note = fmt::format("{} of the tetrahedra made have dihedral angles below {} degrees, the least {:.1f}",
                         cut_figures.slivers, least_dihedral_deg, cut_figures.least_dihedral_deg);
}

}  // namespace prosector
