#include "server/physics/stations/dissecting/undone_motion.h"

#include <algorithm>
#include <span>
#include <vector>

#include "server/physics/mechanics/organs/rejoin.h"
#include "server/physics/stations/hands/hands.h"

namespace prosector {
namespace {

/// Returns the piece in `now` that contains the piece `before`, by its body.
std::size_t joined_to(const organs::Organ& organ, const organs::PieceMesh& before,
                      std::span<const std::size_t> now) {
  cutting::TetId tet = before.tets.front();
  while (!organ.complex().has_tet(tet)) tet = organ.complex().lineage(tet).parent;
  const cutting::TetId place = organ.complex().lineage(tet).place;
  const auto has_it = [&](std::size_t body) {
    const std::vector<cutting::TetId>& places = organ.piece(body).mesh.places;
    return std::binary_search(places.begin(), places.end(), place);
  };
  return *std::find_if(now.begin(), now.end(), has_it);
}

/// Returns the motion with all nodes moved rigidly and set to one velocity.
soft::Motion moved(const soft::Motion& motion, const organs::ReturnMotion& way) {
  soft::Motion out = motion;
  for (Eigen::Index i = 0; i < out.x.size(); i += 3) {
    out.x.segment<3>(i) = way.motion * Vec3(motion.x.segment<3>(i));
    out.v.segment<3>(i) = way.velocity;
  }
  out.x_prev = out.x;
  out.v_prev = out.v;
  return out;
}

}  // namespace

UndoneMotion undone_motion(const Bodies& bodies, const organs::Organ& organ,
                           const organs::Regrouped& changed) {
  UndoneMotion out;
  if (organ.log().back().cause != TopologyCause::undo) return out;
  std::vector<organs::SeparatedPiece> apart;
  for (const organs::OrganPiece& old : changed.before) {
    const soft::Motion& motion = bodies.soft[old.body].state.motion;
    apart.push_back({&old.mesh, joined_to(organ, old.mesh, changed.bodies), &motion.x, &motion.v,
                     bodies.soft[old.body].solver->attached()});
  }
  const auto ways = organs::ways_back(organ.complex(), apart);
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (ways[i]) {
      const std::size_t body = changed.before[i].body;
      out.emplace(body, moved(bodies.soft[body].state.motion, *ways[i]));
    }
  return out;
}

const soft::Motion& motion_before(const Bodies& bodies, std::size_t body, const UndoneMotion& back) {
  const auto found = back.find(body);
  return found == back.end() ? bodies.soft[body].state.motion : found->second;
}

void release_moved_bodies(State& state, const UndoneMotion& back, StepReport& report) {
  for (const auto& [body, motion] : back)
    if ((motion.x - state.bodies.soft[body].state.motion.x).lpNorm<Eigen::Infinity>() >
        hands::grasp_reach_soft)
      let_go_of(state, state.bodies.soft_id(body), "it was put back", report);
}

}  // namespace prosector
