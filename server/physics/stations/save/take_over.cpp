#include "server/physics/stations/save/take_over.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "server/physics/mechanics/organs/locate.h"
#include "server/physics/mechanics/rigid/room.h"
#include "server/physics/stations/save/saved_cuts.h"

namespace prosector {

Refusal cut_stays(const std::string& body) {
  return fmt::format(
      "{} was cut, and its cuts belong to its mesh, which another model would replace: its model is "
      "unchanged",
      body);
}

namespace {

/// Carries a field of a body's nodes over to those of another mesh of it.
class FieldTransfer {
 public:
  FieldTransfer(const soft::SoftBody& from, const soft::SoftBody& to) {
    const Eigen::Index nodes = to.nodes();
    collision::Aabb box;
    for (Eigen::Index i = 0; i < nodes; ++i) box.add(to.rest().segment<3>(3 * i));
    const organs::Locator locator(from.linear_tets(), from.rest(), box);
    for (Eigen::Index i = 0; i < nodes; ++i) {
      const Vec3 place = to.rest().segment<3>(3 * i);
      const auto within = locator.at(place);
      rows_.push_back(within ? *within : nearest(from, place));
    }
  }
  VecX operator()(const VecX& field) const {
    VecX out(3 * static_cast<Eigen::Index>(rows_.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t k = 0; k < rows_[i].node.size(); ++k)
        sum += rows_[i].weight[k] * field.segment<3>(3 * static_cast<Eigen::Index>(rows_[i].node[k]));
      out.segment<3>(3 * static_cast<Eigen::Index>(i)) = sum;
    }
    return out;
  }

 private:
  std::vector<SparseMap::Row> rows_;

  /// Returns the node that stands for a place which only the other mesh has.
  static SparseMap::Row nearest(const soft::SoftBody& body, const Vec3& place) {
    SparseMap::Row row{};
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < body.nodes(); ++i) {
      const double distance = (body.rest().segment<3>(3 * i) - place).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      row.node[0] = static_cast<std::uint32_t>(i);
    }
    row.weight[0] = 1;
    return row;
  }
};

bool same_rung(const SoftDesc& a, const SoftDesc& b) {
  return a.configuration.model == b.configuration.model &&
         a.configuration.element == b.configuration.element &&
         a.configuration.integrator == b.configuration.integrator;
}

bool modelled_alike(const Tissue& a, const Tissue& b) {
  const soft::SoftBodyState &s = a.state, &t = b.state;
  return same_rung(a.desc(), b.desc()) && a.solver->content_hash() == b.solver->content_hash() &&
         s.motion.x.size() == t.motion.x.size() && s.history.size() == t.history.size() &&
         s.mode.size() == t.mode.size();
}

/// Returns whether a body that was cut would be the same if it were whole.
bool whole_alike(const State& from, const State& to, std::size_t i) {
  const auto fresh = to.dissection.uncut.find(i);
  if (fresh == to.dissection.uncut.end()) return false;
  const TetMesh &a = from.dissection.organs.at(i).whole().tets, &b = fresh->second.whole().tets;
  return same_rung(from.bodies.soft[i].desc(), to.bodies.soft[i].desc()) && a.positions == b.positions &&
         a.tets == b.tets;
}

/// Bodies whose model differs between two states of a scene.
struct Remodelled {
  std::vector<std::size_t> bodies;  // soft ones, ascending
  Refusal refusal;                  // of one that was cut

  Remodelled(const State& from, const State& to) {
    for (std::size_t i = 0; i < to.bodies.soft.size(); ++i) {
      const bool cut = from.dissection.organs.contains(i);
      if (cut ? whole_alike(from, to, i) : modelled_alike(from.bodies.soft[i], to.bodies.soft[i])) continue;
      bodies.push_back(i);
      if (cut) refusal = cut_stays(to.bodies.soft[i].desc().name);
    }
  }
  bool has(std::size_t i) const { return std::binary_search(bodies.begin(), bodies.end(), i); }
};

bool same_bodies(const State& from, const State& to) {
  const Bodies &a = from.bodies, &b = to.bodies;
  if (a.model.rigid.size() != b.model.rigid.size() || a.soft.size() < b.soft.size()) return false;
  for (BodyId body = 0; body < b.count(); ++body)
    if (a.name_of(body) != b.name_of(body)) return false;
  return true;
}

/// Gives the new body the shape and motion of the old one.
void follow(const Tissue& from, Tissue& to) {
  const FieldTransfer transfer(*from.solver, *to.solver);
  soft::SoftBodyState& state = to.state;
  state.motion.x = to.equilibrium + transfer(from.state.motion.x - from.equilibrium);
  state.motion.v = transfer(from.state.motion.v);
  state.motion.x_prev = state.motion.x;
  state.motion.v_prev = state.motion.v;
  state.motion.has_history = false;
  state.steps_down = from.state.steps_down;
  state.asleep = from.state.asleep && state.motion.x == to.equilibrium;
}

/// Takes over what was cut, with the pieces that came off.
void take_cuts(const State& from, State& to) {
  if (!from.dissection.ever_cut()) return;
  ByteWriter written;
  RecordWriter out(written);
  save_cuts(from, out);
  ByteReader bytes(written.bytes(), "cuts");
  RecordReader in(bytes);
  RestoredCuts cuts(to);
  cuts.read(in);
  cuts.take_effect();
  to.dissection.blades.clear();  // hands stay behind
}

}  // namespace

Refusal take_over(const State& from, State& to) {
  if (!same_bodies(from, to))
    return "the state cannot be transferred: the two scenes do not have the same bodies";
  const Remodelled changed(from, to);
  if (changed.refusal) return changed.refusal;

  take_cuts(from, to);
  Bodies& bodies = to.bodies;
  to.time = from.time;
  rigid::RigidWorld world(bodies.model.scene.gravity, rigid::room_sides(bodies.model.scene.room));
  for (std::size_t slot = 0; slot < bodies.model.rigid.size(); ++slot)
    world.add(bodies.model.rigid[slot].setup,
              from.bodies.rigid.motion(slot, rigid::RigidWorld::Rounding::none));
  bodies.rigid = std::move(world);
  for (std::size_t i = 0; i < bodies.soft.size(); ++i) {
    const Tissue& old = from.bodies.soft[i];
    if (changed.has(i)) {
      follow(old, bodies.soft[i]);
    } else {
      bodies.soft[i].state = old.state;
      bodies.soft[i].memories = old.memories;
    }
  }
  bodies.parts = from.bodies.parts;
  bodies.lost = from.bodies.lost;
  for (const auto& [pair, how] : from.entangled)
    if (!changed.has(pair.first) && !changed.has(pair.second)) to.entangled[pair] = how;
  for (const auto& [pair, sides] : from.layer_sides)
    if (!changed.has(pair.first) && !changed.has(pair.second)) to.layer_sides[pair] = sides;
  to.lingerers.set(from.lingerers.watched());
  for (const std::size_t i : changed.bodies) to.lingerers.forget(bodies.soft_id(i));
  to.room_lights = from.room_lights;
  for (BodyId body = 0; body < bodies.count(); ++body) bodies.take_effect(bodies.rigid, body);
  for (Tissue& tissue : bodies.soft) tissue.place_surface();
  return {};
}

}  // namespace prosector
