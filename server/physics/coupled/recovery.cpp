#include "server/physics/coupled/recovery.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/physics/soft/incremental_potential.h"
#include "server/physics/soft/mechanical_energy.h"
#include "server/physics/soft/recovery_law.h"
#include "server/physics/soft/rungs.h"
#include "server/physics/soft/unfold.h"

namespace prosector {
namespace {

constexpr double ruined_share = 0.05;        // of the volume: at once
constexpr double slivers_share = 1e-3;       // of the volume: slivers beside an open cut stay flat
constexpr double ruined_seconds = 0.25;      // however little of it
constexpr double whole = 0.3;                // of its rest volume each element has, in a body that is whole
constexpr double calm_energy = 0.05;         // times E and the volume: stored, at most, in such a body
constexpr double like_equilibrium = 1.5;     // times what the body's own equilibrium has of both
constexpr double whole_seconds = 0.25;       // for so long, until its own law takes over
constexpr double least_volume = 0.7;         // of its own equilibrium's, that a body at peace has
constexpr double most_volume = 1.3;          // of its own equilibrium's, at most
constexpr double absurd_volume = 3;          // of that at rest: or none at all
constexpr double absurd_seconds = 0.1;       // for so long: unfolded
constexpr double ruined_for_seconds = 0.75;  // ruined, or quiet and out of shape, for so long: unfolded
constexpr double crumpled_seconds = 4;       // a sheet or rope that isn't quiet, for so long: unfolded
constexpr double quiet_speed = 1e-3;         // m/s, of the fastest node
constexpr double most_turn = 1.05;           // rad, of an attached body whose law is for small rotations
constexpr double most_free_turn = 0.5;       // rad, of a free one: that law makes 1.3 times its volume of it
constexpr double false_turn = 0.05;          // rad: at rest so turned, such a body is 0.1 % too long
constexpr double shivering = 0.05;           // of the stored energy, at most, in motion
constexpr double stuck_energy = 1e-5;        // times E and the volume: a mean strain of about half a per cent

void enter(SoftBodyState& state, bool recovering) {
  state.recovering = recovering;
  state.law_seconds = state.energy_slack = 0;
  state.motion.has_history = false;
  state.warm_start.setZero();
  state.history.setZero();
}

double stiffness(const SoftBody& body) {
  return body.desc().youngs_modulus * body.total_mass() / body.desc().density;  // J
}

/// Returns the share of the volume that is inside out or flat; 0 where the body's own equilibrium has as
/// much.
double ruined(const SoftBody& body, const SoftMember& m) {
  const double share = inverted_share(body.linear_tets(), m.state->motion.x);
  const bool own = share > 0 && m.equilibrium &&
                   share <= like_equilibrium * inverted_share(body.linear_tets(), *m.equilibrium);
  return own ? 0 : share;
}

/// Tells whether the body stores and moves no more than what is calm, or than its own equilibrium asks for.
bool calm(SoftBody& body, const SoftMember& m) {
  const double most = calm_energy * stiffness(body);
  const double now = body.potential().elastic_energy(m.state->motion.x) +
                     kinetic_energy(body.node_mass(), m.state->motion.v);
  return now < most ||
         (m.equilibrium && now < like_equilibrium * body.potential().elastic_energy(*m.equilibrium));
}

/// Tells whether no more of the body is thin than of its own equilibrium.
bool is_whole(const SoftBody& body, const SoftMember& m) {
  const double share = inverted_share(body.linear_tets(), m.state->motion.x, whole);
  return share == 0 ||
         (m.equilibrium && ruined(body, m) == 0 &&
          share <= like_equilibrium * inverted_share(body.linear_tets(), *m.equilibrium, whole));
}

/// Tells whether the body under the law that leads out has come to a stop with nothing inside out. Something
/// presses it, or it bears its weight, and it would stay so for ever.
bool stands(const SoftBody& body, const SoftMember& m) {
  return m.state->quiet_ticks == quiet_ticks_to_sleep && ruined(body, m) == 0;
}

/// Tells whether the body is quiet, but in another shape than the one it rests in: a minimum that is not the
/// least. Sheets and ropes are told as well while what moves them is little of what strains them: crumpled
/// ones shiver and spin.
bool stuck(const SoftMember& s, const VecX& equilibrium) {
  const bool quiet = s.state->quiet_ticks == quiet_ticks_to_sleep;
  SoftBody& body = s.body->in_force(*s.state);
  if (!quiet && mesh_kind(body.anatomy()) == MeshKind::tets) return false;
  const double stored = body.potential().elastic_energy(s.state->motion.x);
  if (!quiet && kinetic_energy(body.node_mass(), s.state->motion.v) > shivering * stored) return false;
  return stored > 2 * body.potential().elastic_energy(equilibrium) + stuck_energy * stiffness(body);
}

/// Tells whether the body is in a shape that a law for small rotations takes for a turned one: stretched by
/// 1/cos of the angle. Tissue under tension stores energy at rest, too.
bool falsely_turned(const SoftMember& s) {
  const VecX& x = s.state->motion.x;
  if (s.state->recovering || !turned_by(*s.body, false_turn, x)) return false;
  IncrementalPotential& potential = s.body->potential();
  return potential.elastic_energy(x) <
         potential.elastic_energy(s.body->rest()) + stuck_energy * stiffness(*s.body);
}

/// Tells whether the body has another volume than what its equilibrium has, by more than any press leaves.
bool has_lost_volume(double volume, const SoftBody& body, const VecX& equilibrium) {
  const double own = volume_share(body.linear_tets(), equilibrium);
  return volume < least_volume * own || volume > most_volume * own;
}

/// Returns how long the body may stay as it is, s; infinite: for good.
double seconds_until_unfolded(const SoftMember& s, const Surroundings& about, const VecX& equilibrium) {
  const double volume = volume_share(s.body->linear_tets(), s.state->motion.x), share = ruined(*s.body, s);
  if (volume > absurd_volume) return absurd_seconds;
  if (about.jammed) return std::numeric_limits<double>::infinity();
  if (volume <= 0) return absurd_seconds;
  if (share > (about.blind ? 0 : about.company ? ruined_share : slivers_share)) return ruined_for_seconds;
  if (!about.crushed && has_lost_volume(volume, *s.body, equilibrium)) return ruined_for_seconds;
  if (about.company || about.touched || !(stuck(s, equilibrium) || falsely_turned(s)))
    return std::numeric_limits<double>::infinity();
  return s.state->quiet_ticks == quiet_ticks_to_sleep ? ruined_for_seconds : crumpled_seconds;
}

/// Returns the turn, rad, up to which a law for small rotations keeps the body. A free body goes back under
/// it as it rests under it: nothing would turn it there.
double turn_allowed(const SoftBody& body, const SoftBodyState& state) {
  if (body.attached()) return most_turn;
  return state.recovering ? false_turn : most_free_turn;
}

}  // namespace

void choose_law(SoftMember& member, double h) {
  SoftBody& body = *member.body;
  SoftBodyState& state = *member.state;
  member.degraded = member.refused = member.guarded = member.limited = false;
  member.note.clear();
  if (!body.recovery().exists() || !state.motion.x.allFinite()) return;
  if (body.recovery().is_kept()) {
    if (!state.recovering) enter(state, true);
    member.degraded = true;
    member.note = "its own weight would crush it: stepped as fem_corotational by implicit_euler";
    return;
  }
  const bool turned = turned_by(body, turn_allowed(body, state), state.motion.x);
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
  member.note = turned ? "turned too far for fem_linear: stepped as fem_corotational by implicit_euler"
                       : "inside out or crushed: recovering as fem_corotational by implicit_euler";
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
  const double patience = seconds_until_unfolded(s, about, equilibrium);
  s.state->tangled_ticks = std::isfinite(patience) ? s.state->tangled_ticks + ticks : 0;
  if (s.state->tangled_ticks * h < patience) return false;
  unfold(*s.body, *s.state);
  s.state->tangled_ticks = s.state->quiet_ticks =
      0;  // what bears its weight has yet to sink to where it rests
  s.note = "stayed inside out or tangled: unfolded into its rest shape where it was";
  return true;
}

}  // namespace prosector
