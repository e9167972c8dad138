// Last phase: what hangs on a sheet's piece follows a cut that nothing comes off.

#include <tbb/parallel_invoke.h>

#include "server/physics/organs/momentum.h"
#include "server/physics/simulation_impl.h"

namespace prosector {

/// As follow_cut(), of a sheet.
bool Simulation::Impl::follow_sheet(Organ& organ, const PieceEdit& edit, TopologyCause cause,
                                    ParticipantId author) {
  const std::size_t body = edit.body;
  SoftBody& solver = *model.soft[body];
  const PieceMesh& mesh = organ.piece(body).mesh;
  const std::size_t nodes_before = mesh.nodes.size();
  if (static_cast<std::size_t>(solver.nodes()) != nodes_before || !solver.can_follow_sheet()) return false;
  const NodeTransfer transfer(organ.complex(), mesh, edit.nodes);
  const auto carried = [&](const VecX& field) {
    const VecX* const fields[] = {&field};
    const VecX made = transfer(fields);
    VecX all(field.size() + made.size());
    all << field, made;
    return all;
  };
  Motion motion, motion_before = std::move(soft[body].motion);
  for (VecX Motion::*field : {&Motion::x, &Motion::v, &Motion::x_prev, &Motion::v_prev})
    motion.*field = carried(motion_before.*field);
  VecX balance = carried(equilibrium[body]);
  const VecX mass_before = solver.node_mass();
  organ.follow(edit);
  Numbering numbering;
  solver.follow_sheet(organ.anatomy(organ.piece(body), numbering), edit.touched);
  const PieceMotion before[] = {
      {std::span(mesh.nodes).first(nodes_before), &mass_before, &motion_before.x, &motion_before.v}};
  const PieceMotion now[] = {{mesh.nodes, &solver.node_mass(), &motion.x, &motion.v}};
  keep_momentum(before, now, true);
  soft[body] = solver.initial_state();
  set_going(body, organ.pieces().front().body, std::move(motion), std::move(balance));
  memories[body].clear();
  ++revisions[body];
  take_effect(world, soft_id(body));
  std::uint64_t content_hash = 0;
  tbb::parallel_invoke([&] { content_hash = solver.content_hash(); },
                       [&] { fit_to_mesh(body, detector(solver), std::move(numbering)); });
  tell_of(body, content_hash, cause, author);
  keep_holds({body});
  return true;
}

}  // namespace prosector
