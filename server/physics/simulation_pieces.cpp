// Last phase: what an organ's change left or made of its pieces becomes bodies.

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <exception>
#include <limits>

#include "server/physics/organs/momentum.h"
#include "server/physics/organs/tet_lineage.h"
#include "server/physics/simulation_impl.h"

namespace prosector {

/// A solver of the same tissue as a body's, of other geometry.
std::unique_ptr<SoftBody> Simulation::Impl::same_tissue(std::size_t body, SoftDesc desc,
                                                        Anatomy anatomy) const {
  auto made = std::make_unique<SoftBody>(std::move(desc), std::move(anatomy));
  if (model.soft[body]->keeps_recovering()) made->keep_recovering();
  return made;
}

/// The solver of a piece: named after the organ, and of its material.
std::unique_ptr<SoftBody> Simulation::Impl::make_piece(const Organ& organ, std::size_t body,
                                                       Numbering& numbering) const {
  const std::size_t first = organ.pieces().front().body;
  SoftDesc desc = model.soft[first]->desc();
  if (body != first) desc.name = fmt::format("{} piece {}", desc.name, body - model.scene.soft.size() + 1);
  return same_tissue(first, std::move(desc), organ.anatomy(organ.piece(body), numbering));
}

/// Puts a solver in the place of the body's, or at the end, where the body is new.
void Simulation::Impl::place_piece(std::size_t body, std::size_t first, std::unique_ptr<SoftBody> solver,
                                   Numbering numbering, SurfaceDetector surface) {
  if (body == model.soft.size()) {
    model.soft.push_back(std::move(solver));
    model.soft_collision.push_back(model.soft_collision[first]);
    soft.emplace_back();
    equilibrium.emplace_back();
    parts.push_back(parts[soft_id(first)]);
  } else {
    retired.push_back(std::exchange(model.soft[body], std::move(solver)));
  }
  soft[body] = model.soft[body]->initial_state();
  equilibrium[body] = soft[body].motion.x;
  fit_to_mesh(body, std::move(surface), std::move(numbering));
}

/// A body in the making.
struct Simulation::Impl::NewPiece {
  std::size_t body = 0;
  bool whole = true;                   // else it was joined to another
  std::optional<Following> following;  // what is there does; else it is made anew:
  std::unique_ptr<SoftBody> solver;
  Numbering numbering;
  std::optional<SurfaceDetector> surface;
  std::uint64_t content_hash = 0;
  Motion motion;  // of a whole one: as what was there moved
  VecX equilibrium, history;
};

/// Of the pieces that an organ's change left or made. Changes nothing: what can fail fails here.
std::vector<Simulation::Impl::NewPiece> Simulation::Impl::make_pieces(const Organ& organ,
                                                                      const Organ::Regrouped& changed,
                                                                      const BroughtBack& back) const {
  const auto make = [&](std::size_t body, NewPiece& made) {
    const OrganPiece& piece = organ.piece(body);
    made.body = body;
    made.whole = piece.whole();
    tbb::parallel_invoke(
        [&] {
          made.following = following_since(organ, changed, piece);
          if (!made.following) make_anew(organ, made);
        },
        [&] {
          if (made.whole) carry_motion(organ, changed.before, back, piece, made);
        });
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

void Simulation::Impl::make_anew(const Organ& organ, NewPiece& made) const {
  made.solver = make_piece(organ, made.body, made.numbering);
  tbb::parallel_invoke([&] { made.surface.emplace(detector(*made.solver)); },
                       [&] { made.content_hash = made.solver->content_hash(); });
}

/// Those that can go on do. Nothing fails any more.
void Simulation::Impl::follow_changes(std::span<NewPiece> pieces) {
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    NewPiece& piece = pieces[i];
    if (!piece.following) return;
    take_solver_along(*piece.following);
    tbb::parallel_invoke([&] { piece.content_hash = model.soft[piece.body]->content_hash(); },
                         [&] { take_surface_along(*piece.following); });
  });
}

/// Where its nodes are and how they move: as what was there did, or was brought back to.
void Simulation::Impl::carry_motion(const Organ& organ, std::span<const OrganPiece> before,
                                    const BroughtBack& back, const OrganPiece& piece, NewPiece& made) const {
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
    made.motion.*field =
        carried([&](std::size_t body) -> const VecX& { return motion_before(body, back).*field; });
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
  if (piece.following)
    soft[body] = model.soft[body]->initial_state();
  else
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
  if (piece.following)
    fit_rest_to_mesh(body, std::move(piece.following->numbering));
  else
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

/// `masses`: of the pieces before.
void Simulation::Impl::keep_momentum_of(const Organ& organ, const Organ::Regrouped& changed,
                                        BroughtBack& back, std::span<const VecX> masses,
                                        std::span<NewPiece> made) {
  std::vector<PieceMotion> before, now;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const OrganPiece& old = changed.before[i];
    const auto brought = back.find(old.body);
    Motion& motion = brought == back.end() ? soft[old.body].motion : brought->second;
    before.push_back({old.mesh.nodes, &masses[i], &motion.x, &motion.v});
  }
  for (NewPiece& piece : made) {
    if (!piece.whole) continue;
    const SoftBody& solver = piece.solver ? *piece.solver : *model.soft[piece.body];
    now.push_back(
        {organ.piece(piece.body).mesh.nodes, &solver.node_mass(), &piece.motion.x, &piece.motion.v});
  }
  // Where pieces are joined, places jump with the nodes that go: what that does to spin is no cut's.
  keep_momentum(before, now, organ.log().back().cause == TopologyCause::cut);
}

/// Makes bodies of the pieces that an organ's change left or made.
void Simulation::Impl::remake(Organ& organ, TopologyCause cause, ParticipantId author) {
  if (follow_cut(organ, cause, author)) return;
  const std::size_t first = organ.pieces().front().body;
  const Organ::Regrouped changed = organ.regroup(model.soft.size());
  BroughtBack back = brought_back(organ, changed);
  std::vector<NewPiece> pieces = make_pieces(organ, changed, back);
  leave_what_went_back(back);
  std::vector<VecX> masses;
  for (const OrganPiece& old : changed.before) masses.push_back(model.soft[old.body]->node_mass());
  follow_changes(pieces);
  if (organ.complex().is_sheet()) keep_momentum_of(organ, changed, back, masses, pieces);
  for (NewPiece& piece : pieces) place(std::move(piece), first, cause, author);
  keep_holds(changed.bodies);
}

}  // namespace prosector
