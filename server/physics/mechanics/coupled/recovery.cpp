#include "server/physics/mechanics/coupled/recovery.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/assert.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"
#include "server/physics/mechanics/soft/recovery_law.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/unfold.h"

namespace prosector::coupled {
namespace {

constexpr double ruined_share = 0.05;  // fraction of the volume inverted or flat: recovery starts immediately
constexpr double slivers_share = 1e-3;  // fraction of the volume: slivers at an open cut stay flat
// s: recovery starts after this time with any inverted or flat volume.
constexpr double ruined_seconds = 0.25;
constexpr double whole = 0.3;  // of its rest volume: least volume of each element of a recovered body
// Times E and the volume: largest elastic and kinetic energy of a recovered body.
constexpr double calm_energy = 0.05;
constexpr double like_equilibrium = 1.5;  // factor on the same quantities in the body's own equilibrium
constexpr double whole_seconds = 0.25;    // s: the body's own law is used again after this time
constexpr double least_volume = 0.7;      // of the volume in equilibrium, below which a body has lost volume
constexpr double most_volume = 1.3;  // of the volume in equilibrium, above which a body has gained volume
constexpr double absurd_volume = 3;  // times the rest volume: volumes above this, or not above 0, are absurd
constexpr double absurd_seconds = 0.1;  // s: time with an absurd volume after which a body is unfolded
// s: time ruined, or quiet in a wrong shape, after which a body is unfolded.
constexpr double ruined_for_seconds = 0.75;
// s: time in a wrong shape after which a sheet or rope that isn't quiet is unfolded.
constexpr double crumpled_seconds = 4;
constexpr double quiet_speed = 1e-3;  // m/s, of the fastest node
constexpr double most_turn = 1.05;  // rad: rotation limit of an attached body under a law for small rotations
// rad: limit of a free body; the law increases its volume 1.3-fold there.
constexpr double most_free_turn = 0.5;
constexpr double false_turn = 0.05;  // rad: a body at rest with this apparent rotation is 0.1 % too long
// Largest ratio of kinetic to stored energy of a body that counts as stuck.
constexpr double shivering = 0.05;
constexpr double stuck_energy = 1e-5;  // times E and the volume: a mean strain of about half a per cent

void enter(soft::SoftBodyState& state, bool recovering) {
  state.recovering = recovering;
  state.law_seconds = state.energy_slack = 0;
  state.motion.has_history = false;
  state.warm_start.setZero();
  state.history.setZero();
}

double stiffness(const soft::SoftBody& body) {
  return body.desc().material.youngs_modulus * body.total_mass() / body.desc().material.density;  // J
}

/// Returns the fraction of the volume that is inverted or flat; 0 if the body's own equilibrium has about as
/// much.
double ruined(const soft::SoftBody& body, const SoftMember& m) {
  const double share = soft::inverted_share(body.linear_tets(), m.state->motion.x);
  const bool own = share > 0 && m.equilibrium &&
                   share <= like_equilibrium * soft::inverted_share(body.linear_tets(), *m.equilibrium);
  return own ? 0 : share;
}

/// Returns whether the body's elastic and kinetic energy is low, or about that of its equilibrium.
bool calm(soft::SoftBody& body, const SoftMember& m) {
  const double most = calm_energy * stiffness(body);
  const double now = body.potential().elastic_energy(m.state->motion.x) +
                     soft::kinetic_energy(body.node_mass(), m.state->motion.v);
  return now < most ||
         (m.equilibrium && now < like_equilibrium * body.potential().elastic_energy(*m.equilibrium));
}

/// Returns whether no element is flat, or about as many as in the body's own equilibrium.
bool is_whole(const soft::SoftBody& body, const SoftMember& m) {
  const double share = soft::inverted_share(body.linear_tets(), m.state->motion.x, whole);
  return share == 0 ||
         (m.equilibrium && ruined(body, m) == 0 &&
          share <= like_equilibrium * soft::inverted_share(body.linear_tets(), *m.equilibrium, whole));
}

/// Returns whether a recovering body has come to rest with nothing inverted. A press or its weight holds it,
/// and it would otherwise recover forever.
bool stands(const soft::SoftBody& body, const SoftMember& m) {
  return m.state->quiet_ticks == quiet_ticks_to_sleep && ruined(body, m) == 0;
}

/// Returns whether the body is quiet in a shape other than its equilibrium: a local minimum. Crumpled sheets
/// and ropes shiver and spin, so they count already while their kinetic energy is small compared with their
/// elastic energy.
bool stuck(const SoftMember& s, const VecX& equilibrium) {
  const bool quiet = s.state->quiet_ticks == quiet_ticks_to_sleep;
  soft::SoftBody& body = s.body->in_force(*s.state);
  if (!quiet && soft::mesh_kind(body.anatomy()) == soft::MeshKind::tets) return false;
  const double stored = body.potential().elastic_energy(s.state->motion.x);
  if (!quiet && soft::kinetic_energy(body.node_mass(), s.state->motion.v) > shivering * stored) return false;
  return stored > 2 * body.potential().elastic_energy(equilibrium) + stuck_energy * stiffness(body);
}

/// Returns whether the body's shape is one that a law for small rotations treats as a rotation: stretched by
/// 1/cos of the angle. Tissue under tension stores energy at rest, too.
bool falsely_turned(const SoftMember& s) {
  const VecX& x = s.state->motion.x;
  if (s.state->recovering || !soft::rotated_by(*s.body, false_turn, x)) return false;
  soft::IncrementalPotential& potential = s.body->potential();
  return potential.elastic_energy(x) <
         potential.elastic_energy(s.body->rest()) + stuck_energy * stiffness(*s.body);
}

/// Returns whether the body's volume differs from that of its equilibrium by more than any press causes.
bool has_lost_volume(double volume, const soft::SoftBody& body, const VecX& equilibrium) {
  const double own = soft::volume_share(body.linear_tets(), equilibrium);
  return volume < least_volume * own || volume > most_volume * own;
}

/// Returns how long the body may stay in its current shape, s; infinite: permanently.
double seconds_until_unfolded(const SoftMember& s, const Surroundings& about, const VecX& equilibrium) {
  const double volume = soft::volume_share(s.body->linear_tets(), s.state->motion.x),
               share = ruined(*s.body, s);
  if (volume > absurd_volume) return absurd_seconds;
  if (about.jammed) return std::numeric_limits<double>::infinity();
  if (volume <= 0) return absurd_seconds;
  if (share > (about.blind ? 0 : about.company ? ruined_share : slivers_share)) return ruined_for_seconds;
  if (!about.crushed && has_lost_volume(volume, *s.body, equilibrium)) return ruined_for_seconds;
  if (about.company || about.touched || !(stuck(s, equilibrium) || falsely_turned(s)))
    return std::numeric_limits<double>::infinity();
  return s.state->quiet_ticks == quiet_ticks_to_sleep ? ruined_for_seconds : crumpled_seconds;
}

/// Returns the rotation, rad, up to which the body stays under a law for small rotations. A free body returns
/// to that law only if it is nearly unrotated, because nothing would rotate it back there.
double turn_allowed(const soft::SoftBody& body, const soft::SoftBodyState& state) {
  if (body.attached()) return most_turn;
  return state.recovering ? false_turn : most_free_turn;
}

}  // namespace

void choose_law(SoftMember& member, double h) {
  PROSECTOR_ASSERT(member.body != nullptr && member.state != nullptr && h > 0);
  soft::SoftBody& body = *member.body;
  soft::SoftBodyState& state = *member.state;
  member.degraded = member.refused = member.guarded = member.limited = false;
  member.note.clear();
  if (!body.recovery().exists() || !state.motion.x.allFinite()) return;
  if (body.recovery().is_kept()) {
    if (!state.recovering) enter(state, true);
    member.degraded = true;
    member.note =
        "its own weight would crush it: stepped with fem_corotational and implicit_euler instead of the "
        "configured model";
    return;
  }
  const bool turned = soft::rotated_by(body, turn_allowed(body, state), state.motion.x);
  if (state.recovering) {
    const bool out =
        !turned && ((is_whole(body, member) && calm(body.in_force(state), member)) || stands(body, member));
    state.law_seconds = out ? state.law_seconds + h : 0;
    if (state.law_seconds > whole_seconds) enter(state, false);
  } else {
    const double share = turned ? 0 : ruined(body, member);
    state.law_seconds = share > 0 ? state.law_seconds + h : 0;
    if (turned || share > ruined_share || state.law_seconds > ruined_seconds) enter(state, true);
  }
  if (!state.recovering) return;
  member.degraded = turned;
  member.note = turned ? "the body's rotation is too large for fem_linear: stepped with fem_corotational and "
                         "implicit_euler"
                       : "elements are inverted or crushed: the body is recovering with fem_corotational and "
                         "implicit_euler";
}

bool may_sleep(const SoftMember& member) {
  const bool leaves_recovery = member.state->recovering && member.state->law_seconds > 0;
  return member.state->tangled_ticks == 0 && !leaves_recovery &&
         ruined(*member.body, member) <= slivers_share;
}

void count_quiet_ticks(SoftMember& s) {
  const double speed = s.state->motion.v.lpNorm<Eigen::Infinity>();
  s.state->quiet_ticks = speed < quiet_speed ? std::min(s.state->quiet_ticks + 1, quiet_ticks_to_sleep) : 0;
}

bool unfold_if_tangled(SoftMember& s, const Surroundings& about, const VecX& equilibrium, double h,
                       int ticks) {
  PROSECTOR_ASSERT(h > 0 && ticks > 0 && equilibrium.size() == 3 * s.body->nodes());
  const double time_limit = seconds_until_unfolded(s, about, equilibrium);
  s.state->tangled_ticks = std::isfinite(time_limit) ? s.state->tangled_ticks + ticks : 0;
  if (s.state->tangled_ticks * h < time_limit) return false;
  soft::unfold(*s.body, *s.state);
  // A body under load must still settle in its equilibrium.
  s.state->tangled_ticks = s.state->quiet_ticks = 0;
  s.note =
      "elements remained inverted or tangled: the body was reset to its rest shape at its current position";
  return true;
}

}  // namespace prosector::coupled
