#include "server/physics/stations/dissecting/piece_follow.h"

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/organs/momentum.h"
#include "server/physics/mechanics/organs/node_transfer.h"
#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/organs/surface_follow.h"
#include "server/physics/mechanics/organs/tet_lineage.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "server/physics/stations/dissecting/piece_builder.h"
#include "server/physics/stations/hands/holding.h"
#include "server/physics/stations/touching/fit_tissue.h"

namespace prosector {
namespace {

bool can_follow(const Bodies& bodies, const organs::Organ& organ, const organs::PieceEdit& edit) {
  const soft::SoftBody& solver = *bodies.soft[edit.body].solver;
  return organ.complex().is_sheet() ? solver.follower().can_follow_sheet(edit.mesh.kept_nodes)
                                    : solver.follower().can_follow(edit.mesh);
}

/// Returns the update for an edit that the organ has taken in. `surface`: edit of the tetrahedra's surface.
Following following(const Bodies& bodies, const organs::Organ& organ, organs::PieceEdit edit,
                    std::optional<SurfaceEdit> surface) {
  Following out;
  out.edit = std::move(edit);
  out.surface = std::move(surface);
  const std::size_t body = out.edit.body;
  const organs::OrganPiece& piece = organ.piece(body);
  if (organ.complex().is_sheet()) {
    out.sheet = organs::anatomy_of(organ, piece, out.numbering);
    out.surface =
        organs::edit_between(bodies.soft[body].solver->anatomy().surface, bodies.soft[body].numbering,
                             out.sheet->surface, out.sheet->embedding, out.numbering);
  } else if (out.surface) {
    out.numbering = bodies.soft[body].numbering;
    apply(*out.surface, out.numbering);
    out.numbering.nodes = piece.mesh.nodes;
  } else {
    out.skin = organs::surface_of(organ, piece);
    out.numbering = std::move(out.skin.numbering);
  }
  return out;
}

}  // namespace

std::optional<Following> following_since(const Bodies& bodies, const organs::Organ& organ,
                                         const organs::Regrouped& then, const organs::OrganPiece& piece) {
  std::optional<organs::PieceEdit> edit = organs::edit_since(organ, then, piece);
  if (!edit || !organs::is_worth_following(*edit) || !can_follow(bodies, organ, *edit)) return std::nullopt;
  return following(
      bodies, organ, std::move(*edit),
      organs::surface_edit_since(organ, then, piece, bodies.soft[piece.body].solver->anatomy().surface,
                                 bodies.soft[piece.body].numbering));
}

void take_solver_along(Bodies& bodies, Following& following) {
  const soft::MeshEdit& mesh = following.edit.mesh;
  soft::SoftBody& solver = *bodies.soft[following.edit.body].solver;
  if (following.sheet)
    solver.follower().follow_sheet(std::move(*following.sheet), mesh.kept_nodes, following.edit.touched);
  else if (following.surface)
    solver.follower().follow(mesh, *following.surface);
  else
    solver.follower().follow(mesh, std::move(following.skin.surface), std::move(following.skin.embedding));
}

void take_surface_along(Bodies& bodies, const Following& following) {
  contact::TissueSurface& surface = bodies.soft[following.edit.body].surface;
  if (following.surface)
    surface.follow(*following.surface, !following.numbering.triangles.empty());
  else
    surface.remake();
}

bool follow_cut(State& state, organs::Organ& organ, TopologyCause cause, ParticipantId author,
                StepReport& report) {
  Bodies& bodies = state.bodies;
  std::optional<organs::PieceEdit> edit = organs::cut_in_one_piece(organ);
  if (!edit || !can_follow(bodies, organ, *edit)) return false;
  const std::size_t body = edit->body;
  soft::SoftBody& solver = *bodies.soft[body].solver;
  const organs::PieceMesh& mesh = organ.piece(body).mesh;
  const std::size_t nodes_before = mesh.nodes.size();
  const VecX mass_before = solver.node_mass();
  const soft::MeshEdit nodes = solver.follower().edit_of_nodes(edit->mesh);
  const organs::NodeTransfer transfer(organ.complex(), mesh, edit->nodes, edit->tets, nodes,
                                      solver.follower().edge_nodes());
  soft::Motion motion_before = std::move(bodies.soft[body].state.motion);
  soft::Motion motion;
  for (VecX soft::Motion::*field :
       {&soft::Motion::x, &soft::Motion::v, &soft::Motion::x_prev, &soft::Motion::v_prev})
    motion.*field = transfer.carried(motion_before.*field, nodes);
  VecX balance = transfer.carried(bodies.soft[body].equilibrium, nodes);
  VecX history = bodies.soft[body].state.history;
  const organs::PieceMesh* const before[] = {&mesh};
  const VecX* const histories[] = {&history};
  const Eigen::Index numbers = organs::history_per_tet(history, mesh);
  const VecX touched = organs::carried_history(organ.complex(), before, histories, numbers, edit->tets);
  // None at the first cut, which replaces the compiled surface by the tetrahedra's skin.
  std::optional<SurfaceEdit> surface;
  if (!organ.complex().is_sheet() && !bodies.soft[body].numbering.triangles.empty())
    surface = organs::surface_edit(organ, *edit, solver.anatomy().surface, bodies.soft[body].numbering);
  organ.follow(*edit);
  Following follows = following(bodies, organ, std::move(*edit), std::move(surface));
  take_solver_along(bodies, follows);
  if (organ.complex().is_sheet()) {
    const organs::PieceMotion was[] = {
        {std::span(mesh.nodes).first(nodes_before), &mass_before, &motion_before.x, &motion_before.v}};
    const organs::PieceMotion is[] = {{mesh.nodes, &solver.node_mass(), &motion.x, &motion.v}};
    organs::keep_momentum(was, is, true);
  }
  bodies.soft[body].state = solver.initial_state();
  set_going(bodies, body, organ.pieces().front().body, std::move(motion), std::move(balance));
  history.conservativeResize(bodies.soft[body].state.history.size());
  const std::vector<std::uint32_t>& tets = follows.edit.mesh.tets;
  for (std::size_t i = 0; i < tets.size(); ++i)
    history.segment(numbers * Eigen::Index{tets[i]}, numbers) =
        touched.segment(numbers * static_cast<Eigen::Index>(i), numbers);
  bodies.soft[body].state.history = std::move(history);
  bodies.soft[body].memories.clear();
  ++bodies.soft[body].revision;
  bodies.take_effect(bodies.rigid, bodies.soft_id(body));
  std::uint64_t content_hash = 0;
  parallel_both([&] { content_hash = solver.content_hash(); },
                [&] {
                  take_surface_along(bodies, follows);
                  fit_to_mesh(state, body, std::move(follows.numbering));
                });
  add_topology_change(bodies, body, content_hash, cause, author, report);
  keep_holds(state, {body});
  return true;
}

}  // namespace prosector
