// Last phase: what hangs on a piece's mesh follows a cut, or what takes one back, to the bits that it would
// have if it were made anew.

#include <tbb/parallel_invoke.h>

#include "server/physics/organs/momentum.h"
#include "server/physics/organs/surface_follow.h"
#include "server/physics/organs/tet_lineage.h"
#include "server/physics/simulation_impl.h"

namespace prosector {

bool Simulation::Impl::can_follow(const Organ& organ, const PieceEdit& edit) const {
  const SoftBody& solver = *model.soft[edit.body];
  return organ.complex().is_sheet() ? solver.can_follow_sheet(edit.mesh.kept_nodes)
                                    : solver.can_follow(edit.mesh);
}

/// `surface`: of tetrahedra. The organ has taken the change in.
Simulation::Impl::Following Simulation::Impl::following(const Organ& organ, PieceEdit edit,
                                                        std::optional<SurfaceEdit> surface) const {
  Following out;
  out.edit = std::move(edit);
  out.surface = std::move(surface);
  const std::size_t body = out.edit.body;
  const OrganPiece& piece = organ.piece(body);
  if (organ.complex().is_sheet()) {
    out.sheet = organ.anatomy(piece, out.numbering);
    out.surface = edit_between(model.soft[body]->anatomy().surface, numberings[body], out.sheet->surface,
                               out.sheet->embedding, out.numbering);
  } else if (out.surface) {
    out.numbering = numberings[body];
    apply(*out.surface, out.numbering);
    out.numbering.nodes = piece.mesh.nodes;
  } else {
    out.skin = organ.surface(piece);
    out.numbering = std::move(out.skin.numbering);
  }
  return out;
}

/// None where the piece has to be made anew.
std::optional<Simulation::Impl::Following> Simulation::Impl::following_since(const Organ& organ,
                                                                             const Organ::Regrouped& then,
                                                                             const OrganPiece& piece) const {
  std::optional<PieceEdit> edit = organ.edit_since(then, piece);
  if (!edit || !is_worth_following(*edit) || !can_follow(organ, *edit)) return std::nullopt;
  return following(organ, std::move(*edit),
                   organ.surface_edit_since(then, piece, model.soft[piece.body]->anatomy().surface,
                                            numberings[piece.body]));
}

void Simulation::Impl::take_solver_along(Following& following) {
  const MeshEdit& mesh = following.edit.mesh;
  SoftBody& solver = *model.soft[following.edit.body];
  if (following.sheet)
    solver.follow_sheet(std::move(*following.sheet), mesh.kept_nodes, following.edit.touched);
  else if (following.surface)
    solver.follow(mesh, *following.surface);
  else
    solver.follow(mesh, std::move(following.skin.surface), std::move(following.skin.embedding));
}

/// After the solver. The tree of its faces, if it was made, only where it was and is that of an order; as
/// what of it may meet what.
void Simulation::Impl::take_surface_along(const Following& following) {
  const std::size_t body = following.edit.body;
  const SoftBody& solver = *model.soft[body];
  if (!following.surface) {
    surfaces[body] = detector(solver);
    faces[body].reset();
    folds[body].reset();
    return;
  }
  surfaces[body].follow(*following.surface);
  if (numberings[body].triangles.empty() || following.numbering.triangles.empty()) {
    faces[body].reset();
    folds[body].reset();
    return;
  }
  if (faces[body])
    faces[body]->follow(*following.surface, solver.anatomy().surface, surfaces[body].triangle_order());
  if (folds[body]) folds[body]->follow(*following.surface, surfaces[body]);
}

/// Where one piece was cut and nothing came off it. False, and nothing changed, where that isn't so or can't
/// be followed. What can fail fails first.
bool Simulation::Impl::follow_cut(Organ& organ, TopologyCause cause, ParticipantId author) {
  std::optional<PieceEdit> edit = organ.cut_in_one_piece();
  if (!edit || !can_follow(organ, *edit)) return false;
  const std::size_t body = edit->body;
  SoftBody& solver = *model.soft[body];
  const PieceMesh& mesh = organ.piece(body).mesh;
  const std::size_t nodes_before = mesh.nodes.size();
  const VecX mass_before = solver.node_mass();
  const MeshEdit nodes = solver.edit_of_nodes(edit->mesh);
  const NodeTransfer transfer(organ.complex(), mesh, edit->nodes, edit->tets, nodes, solver.edge_nodes());
  Motion motion_before = std::move(soft[body].motion);
  Motion motion;
  for (VecX Motion::*field : {&Motion::x, &Motion::v, &Motion::x_prev, &Motion::v_prev})
    motion.*field = transfer.carried(motion_before.*field, nodes);
  VecX balance = transfer.carried(equilibrium[body], nodes);
  VecX history = soft[body].history;
  const PieceMesh* const before[] = {&mesh};
  const VecX* const histories[] = {&history};
  const Eigen::Index numbers = history_per_tet(history, mesh);
  const VecX touched = carried_history(organ.complex(), before, histories, numbers, edit->tets);
  std::optional<SurfaceEdit> surface;  // none with the first cut, which makes the tetrahedra's own skin of it
  if (!organ.complex().is_sheet() && !numberings[body].triangles.empty())
    surface = organ.surface_edit(*edit, solver.anatomy().surface, numberings[body]);
  organ.follow(*edit);
  Following follows = following(organ, std::move(*edit), std::move(surface));
  take_solver_along(follows);
  if (organ.complex().is_sheet()) {
    const PieceMotion was[] = {
        {std::span(mesh.nodes).first(nodes_before), &mass_before, &motion_before.x, &motion_before.v}};
    const PieceMotion is[] = {{mesh.nodes, &solver.node_mass(), &motion.x, &motion.v}};
    keep_momentum(was, is, true);
  }
  soft[body] = solver.initial_state();
  set_going(body, organ.pieces().front().body, std::move(motion), std::move(balance));
  history.conservativeResize(soft[body].history.size());
  const std::vector<std::uint32_t>& tets = follows.edit.mesh.tets;
  for (std::size_t i = 0; i < tets.size(); ++i)
    history.segment(numbers * Eigen::Index{tets[i]}, numbers) =
        touched.segment(numbers * static_cast<Eigen::Index>(i), numbers);
  soft[body].history = std::move(history);
  memories[body].clear();
  ++revisions[body];
  take_effect(world, soft_id(body));
  std::uint64_t content_hash = 0;
  tbb::parallel_invoke([&] { content_hash = solver.content_hash(); },
                       [&] {
                         take_surface_along(follows);
                         fit_rest_to_mesh(body, std::move(follows.numbering));
                       });
  tell_of(body, content_hash, cause, author);
  keep_holds({body});
  return true;
}

}  // namespace prosector
