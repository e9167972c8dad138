// Last phase: what hangs on a piece's mesh follows a cut that nothing comes off.

#include <tbb/parallel_invoke.h>

#include "server/physics/organs/tet_lineage.h"
#include "server/physics/simulation_impl.h"

namespace prosector {

/// Where one piece was cut and nothing came off it, what hangs on its mesh follows, to the bits that it would
/// have if it were made anew. False, and nothing changed, where that can't be. What can fail fails first.
bool Simulation::Impl::follow_cut(Organ& organ, TopologyCause cause, ParticipantId author) {
  const std::optional<PieceEdit> edit = organ.cut_in_one_piece();
  if (!edit) return false;
  if (organ.complex().is_sheet()) return follow_sheet(organ, *edit, cause, author);
  const std::size_t body = edit->body;
  SoftBody& solver = *model.soft[body];
  const PieceMesh& mesh = organ.piece(body).mesh;
  if (!solver.can_follow(edit->mesh)) return false;
  const NodeTransfer transfer(organ.complex(), mesh, edit->nodes);
  const auto carried = [&](const VecX& field) {
    const VecX* const fields[] = {&field};
    const VecX made = transfer(fields);
    VecX all(field.size() + made.size());
    all << field, made;
    return all;
  };
  Motion motion;
  for (VecX Motion::*field : {&Motion::x, &Motion::v, &Motion::x_prev, &Motion::v_prev})
    motion.*field = carried(soft[body].motion.*field);
  VecX balance = carried(equilibrium[body]);
  VecX history = soft[body].history;
  const PieceMesh* const before[] = {&mesh};
  const VecX* const histories[] = {&soft[body].history};
  const Eigen::Index numbers = history_per_tet(history, mesh);
  const VecX touched = carried_history(organ.complex(), before, histories, numbers, edit->tets);
  std::optional<SurfaceEdit> surface;  // none with the first cut, which makes the tetrahedra's own skin of it
  if (!numberings[body].triangles.empty())
    surface = organ.surface_edit(*edit, solver.anatomy().surface, numberings[body]);
  organ.follow(*edit);
  Numbering numbering;  // with the first cut
  if (surface) {
    numberings[body].nodes = mesh.nodes;
    solver.follow(edit->mesh, *surface);
  } else {
    PieceSurface skin = organ.surface(organ.piece(body));
    numbering = std::move(skin.numbering);
    solver.follow(edit->mesh, std::move(skin.surface), std::move(skin.embedding));
  }
  soft[body] = solver.initial_state();
  set_going(body, organ.pieces().front().body, std::move(motion), std::move(balance));
  history.conservativeResize(soft[body].history.size());
  for (std::size_t i = 0; i < edit->tets.size(); ++i)
    history.segment(numbers * Eigen::Index{edit->mesh.tets[i]}, numbers) =
        touched.segment(numbers * static_cast<Eigen::Index>(i), numbers);
  soft[body].history = std::move(history);
  memories[body].clear();
  ++revisions[body];
  take_effect(world, soft_id(body));
  std::uint64_t content_hash = 0;
  tbb::parallel_invoke([&] { content_hash = solver.content_hash(); },
                       [&] {
                         if (surface)
                           follow_mesh(body, *surface);
                         else
                           fit_to_mesh(body, detector(solver), std::move(numbering));
                       });
  tell_of(body, content_hash, cause, author);
  keep_holds({body});
  return true;
}

}  // namespace prosector
