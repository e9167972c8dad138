#include "server/physics/stations/dissecting/piece_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "common/assert.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/organs/momentum.h"
#include "server/physics/mechanics/organs/node_transfer.h"
#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/organs/tet_lineage.h"
#include "server/physics/mechanics/soft/recovery_law.h"
#include "server/physics/stations/dissecting/piece_follow.h"
#include "server/physics/stations/dissecting/undone_motion.h"
#include "server/physics/stations/hands/holding.h"
#include "server/physics/stations/touching/fit_tissue.h"

namespace prosector {
namespace {

/// A body under construction.
struct NewPiece {
  std::size_t body = 0;
  bool whole = true;                   // false: it was joined to another body
  std::optional<Following> following;  // incremental update; none: rebuilt, with the following members
  std::unique_ptr<soft::SoftBody> solver;
  Numbering numbering;
  std::optional<contact::TissueSurface> surface;
  std::uint64_t content_hash = 0;
  soft::Motion motion;  // of a whole piece: interpolated from the old motion
  VecX equilibrium, history;
};

void rebuild(const Bodies& bodies, const organs::Organ& organ, NewPiece& made) {
  made.solver = make_piece(bodies, organ, made.body, made.numbering);
  parallel_both([&] { made.surface.emplace(made.solver->anatomy()); },
                [&] { made.content_hash = made.solver->content_hash(); });
}

/// Sets positions and velocities of the piece's nodes from the old bodies, after these were moved back.
void carry_motion(const Bodies& bodies, const organs::Organ& organ,
                  std::span<const organs::OrganPiece> before, const UndoneMotion& back,
                  const organs::OrganPiece& piece, NewPiece& made) {
  std::vector<const organs::PieceMesh*> meshes;
  for (const organs::OrganPiece& old : before) meshes.push_back(&old.mesh);
  const bool quadratic = bodies.soft[before.front().body].solver->desc().configuration.is_quadratic();
  const organs::NodeTransfer transfer(organ.complex(), meshes, piece.mesh, quadratic);
  const auto carried = [&](const auto& field) {
    std::vector<const VecX*> fields;
    for (const organs::OrganPiece& old : before) fields.push_back(&field(old.body));
    return transfer(fields);
  };
  for (VecX soft::Motion::*field :
       {&soft::Motion::x, &soft::Motion::v, &soft::Motion::x_prev, &soft::Motion::v_prev})
    made.motion.*field =
        carried([&](std::size_t body) -> const VecX& { return motion_before(bodies, body, back).*field; });
  made.equilibrium = carried([&](std::size_t body) -> const VecX& { return bodies.soft[body].equilibrium; });
  std::vector<const VecX*> histories;
  auto numbers = std::numeric_limits<Eigen::Index>::max();
  for (const organs::OrganPiece& old : before) {
    histories.push_back(&bodies.soft[old.body].state.history);
    const bool all = bodies.soft[old.body].solver->dropped_elements() == 0;
    numbers = std::min(numbers, all ? organs::history_per_tet(*histories.back(), old.mesh) : 0);
  }
  made.history = organs::carried_history(organ.complex(), meshes, histories, numbers, piece.mesh.tets);
}

/// Builds the pieces after an organ's change. Modifies no state: all operations that can fail are here.
std::vector<NewPiece> make_pieces(const Bodies& bodies, const organs::Organ& organ,
                                  const organs::Regrouped& changed, const UndoneMotion& back) {
  const auto make = [&](std::size_t body, NewPiece& made) {
    const organs::OrganPiece& piece = organ.piece(body);
    made.body = body;
    made.whole = piece.whole();
    parallel_both(
        [&] {
          made.following = following_since(bodies, organ, changed, piece);
          if (!made.following) rebuild(bodies, organ, made);
        },
        [&] {
          if (made.whole) carry_motion(bodies, organ, changed.before, back, piece, made);
        });
  };
  std::vector<NewPiece> out(changed.bodies.size());
  std::vector<std::exception_ptr> failed(out.size());
  parallel_each(out.size(), [&](std::size_t i) {
    try {
      make(changed.bodies[i], out[i]);
    } catch (...) {
      failed[i] = std::current_exception();
    }
  });
  // Rethrows the error of the first piece, for any thread order.
  for (const std::exception_ptr& error : failed)
    if (error) std::rethrow_exception(error);
  return out;
}

/// Applies the incremental updates of all pieces that have one. Cannot fail.
void follow_changes(Bodies& bodies, std::span<NewPiece> pieces) {
  parallel_each(pieces.size(), [&](std::size_t i) {
    NewPiece& piece = pieces[i];
    if (!piece.following) return;
    take_solver_along(bodies, *piece.following);
    parallel_both([&] { piece.content_hash = bodies.soft[piece.body].solver->content_hash(); },
                  [&] { take_surface_along(bodies, *piece.following); });
  });
}

/// Installs a piece as the body with its index, new or existing.
void place_new(State& state, NewPiece piece, std::size_t first, TopologyCause cause, ParticipantId author,
               StepReport& report) {
  Bodies& bodies = state.bodies;
  const std::size_t body = piece.body;
  const bool is_new = body == bodies.soft.size();
  if (piece.following)
    bodies.soft[body].state = bodies.soft[body].solver->initial_state();
  else
    place_piece(state, body, first, std::move(piece.solver), std::move(piece.numbering),
                std::move(*piece.surface));
  bodies.soft[body].memories.clear();
  if (!is_new) ++bodies.soft[body].revision;
  if (piece.whole) {
    set_going(bodies, body, first, std::move(piece.motion), std::move(piece.equilibrium));
    if (piece.history.size() == bodies.soft[body].state.history.size())
      bodies.soft[body].state.history = std::move(piece.history);
  } else {
    bodies.parts[bodies.soft_id(body)].hidden = true;
  }
  bodies.take_effect(bodies.rigid, bodies.soft_id(body));
  if (piece.following)
    fit_to_mesh(state, body, std::move(piece.following->numbering));
  else
    bodies.soft[body].place_surface();
  TopologyChange& change = add_topology_change(bodies, body, piece.content_hash, cause, author, report);
  if (is_new) change.piece_of = bodies.soft_id(first);
}

/// Conserves the momentum of cut or joined pieces. `masses`: of the pieces' nodes before the change.
void keep_momentum_of(Bodies& bodies, const organs::Organ& organ, const organs::Regrouped& changed,
                      UndoneMotion& back, std::span<const VecX> masses, std::span<NewPiece> made) {
  std::vector<organs::PieceMotion> before, now;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const organs::OrganPiece& old = changed.before[i];
    const auto brought = back.find(old.body);
    soft::Motion& motion = brought == back.end() ? bodies.soft[old.body].state.motion : brought->second;
    before.push_back({old.mesh.nodes, &masses[i], &motion.x, &motion.v});
  }
  for (NewPiece& piece : made) {
    if (!piece.whole) continue;
    const soft::SoftBody& solver = piece.solver ? *piece.solver : *bodies.soft[piece.body].solver;
    now.push_back(
        {organ.piece(piece.body).mesh.nodes, &solver.node_mass(), &piece.motion.x, &piece.motion.v});
  }
  // When pieces are joined, removed nodes make positions jump; that change of angular momentum is not
  // corrected.
  organs::keep_momentum(before, now, organ.log().back().cause == TopologyCause::cut);
}

}  // namespace

std::unique_ptr<soft::SoftBody> same_tissue(const Bodies& bodies, std::size_t body, SoftDesc desc,
                                            Anatomy anatomy) {
  auto made = std::make_unique<soft::SoftBody>(std::move(desc), std::move(anatomy));
  if (bodies.soft[body].solver->recovery().is_kept()) made->recovery().keep();
  return made;
}

std::unique_ptr<soft::SoftBody> make_piece(const Bodies& bodies, const organs::Organ& organ, std::size_t body,
                                           Numbering& numbering) {
  const std::size_t first = organ.pieces().front().body;
  SoftDesc desc = bodies.soft[first].solver->desc();
  if (body != first)
    desc.name = fmt::format("{} piece {}", desc.name, body - bodies.model.scene.soft.size() + 1);
  return same_tissue(bodies, first, std::move(desc), organs::anatomy_of(organ, organ.piece(body), numbering));
}

void place_piece(State& state, std::size_t body, std::size_t first, std::unique_ptr<soft::SoftBody> solver,
                 Numbering numbering, contact::TissueSurface surface) {
  Bodies& bodies = state.bodies;
  PROSECTOR_ASSERT(solver != nullptr && body <= bodies.soft.size() && first < bodies.soft.size());
  PROSECTOR_ASSERT(is_ascending(numbering.nodes) && is_ascending(numbering.vertices) &&
                   is_ascending(numbering.triangles));
  if (body == bodies.soft.size()) {
    bodies.soft.emplace_back(body, std::move(solver), bodies.soft[first].collision, std::move(surface));
    bodies.parts.push_back(bodies.parts[bodies.soft_id(first)]);
  } else {
    Tissue& tissue = bodies.soft[body];
    bodies.retired.push_back(std::exchange(tissue.solver, std::move(solver)));
    tissue.state = tissue.solver->initial_state();
    tissue.equilibrium = tissue.state.motion.x;
    tissue.surface = std::move(surface);
  }
  fit_to_mesh(state, body, std::move(numbering));
}

void set_going(Bodies& bodies, std::size_t body, std::size_t first, soft::Motion motion, VecX balance) {
  Tissue& tissue = bodies.soft[body];
  PROSECTOR_ASSERT(motion.x.size() == tissue.state.motion.x.size() && balance.size() == motion.x.size());
  tissue.state.motion = std::move(motion);
  tissue.state.asleep = false;
  tissue.equilibrium = std::move(balance);
  if (body != first && tissue.solver->attachment_stiffness().isZero())
    bodies.parts[bodies.soft_id(body)].attached = false;
}

TopologyChange& add_topology_change(const Bodies& bodies, std::size_t body, std::uint64_t content_hash,
                                    TopologyCause cause, ParticipantId author, StepReport& report) {
  TopologyChange& change = report.topology.emplace_back();
  change.body = bodies.soft_id(body);
  change.revision = bodies.soft[body].revision;
  change.content_hash = content_hash;
  change.cause = cause;
  change.author = author;
  return change;
}

void remake(State& state, organs::Organ& organ, TopologyCause cause, ParticipantId author,
            StepReport& report) {
  Bodies& bodies = state.bodies;
  if (follow_cut(state, organ, cause, author, report)) return;
  const std::size_t first = organ.pieces().front().body;
  const organs::Regrouped changed = organ.regroup(bodies.soft.size());
  UndoneMotion back = undone_motion(bodies, organ, changed);
  std::vector<NewPiece> pieces = make_pieces(bodies, organ, changed, back);
  release_moved_bodies(state, back, report);
  std::vector<VecX> masses;
  for (const organs::OrganPiece& old : changed.before)
    masses.push_back(bodies.soft[old.body].solver->node_mass());
  follow_changes(bodies, pieces);
  if (organ.complex().is_sheet()) keep_momentum_of(bodies, organ, changed, back, masses, pieces);
  for (NewPiece& piece : pieces) place_new(state, std::move(piece), first, cause, author, report);
  keep_holds(state, changed.bodies);
}

}  // namespace prosector
