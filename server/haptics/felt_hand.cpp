#include "server/haptics/felt_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/physics/mechanics/coupled/island_joints.h"
#include "server/physics/mechanics/hands/hand.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

constexpr double plane_distance =
    0.03;                               // m: surfaces closer to the hand than this get a plane before contact
constexpr double same_place = 0.04;     // m: a plane that moved farther in a tick gets a new id
constexpr double least_radius = 0.005;  // m: lower bound of a plane's radius
constexpr double slips_from = 0.95;     // share of the friction bound; above it a contact counts as sliding
constexpr double softest = 1e-3;        // N/m: lower bound of slopes
constexpr double farthest = 0.1;        // m: upper bound of a held plane's radius
constexpr double smoothing = 0.1;       // s: time constant of the surface's smoothed speed
constexpr double least_speed = 5e-3, most_speed = 0.5;  // m/s: slower counts as at rest, faster is clamped

/// Returns the stiffness of a flat punch of the patch's area on a half-space of the body's material, N/m:
/// 2·E*·a (Johnson 1985, "Contact Mechanics", 3.36). It is used until the worker has computed the body's
/// slopes.
double punch_stiffness(const soft::SoftBody& body, double area, double strength) {
  const SoftDesc& desc = body.desc();
  const double plane = strength * desc.material.youngs_modulus /
                       (1 - desc.material.poisson_ratio * desc.material.poisson_ratio);
  return 2 * plane * std::sqrt(area / std::numbers::pi);
}

/// Returns the area of the body's surface that the touches represent, m²: at least a disc of `least_radius`.
double area_of(const soft::SoftBody& body, const std::vector<HandTouch>& touches) {
  const std::span<const double> areas = body.surface_area();
  double mean = 0;
  for (const double area : areas) mean += area;
  mean /= static_cast<double>(std::max<std::size_t>(1, areas.size()));
  return std::max(static_cast<double>(touches.size()) * mean, std::numbers::pi * least_radius * least_radius);
}

/// Returns the sum of the contacts' stiffness along the group's normal, N/m. If any touch presses, only those
/// that press or hold count. 0: no contact.
double joint_stiffness(const TouchGroup& group) {
  double sum = 0;
  for (const HandTouch& t : group.touches)
    if (t.holds || t.force > 0 || group.pressing == 0)
      sum += t.stiffness * (t.holds ? 1 : std::pow(t.normal.dot(group.normal), 2));
  return sum;
}

/// Returns the mean compliance of the group's points on the hand along `direction` (unit), m/N, while the arm
/// does not move.
double give_along(const TouchGroup& group, const Vec3& direction) {
  double sum = 0;
  for (const HandTouch& t : group.touches) sum += direction.dot(t.give * direction);
  return sum / static_cast<double>(group.touches.size());
}

/// Returns how much farther the held body can be moved until all its holds reach their force bound, m.
double reach_of(const TouchGroup& group, double stiffness) {
  double bound = 0;
  for (const HandTouch& t : group.touches) bound += t.bound;
  return std::clamp((bound - group.pressing) / stiffness, 0., farthest);
}

/// Returns the springs that represent a touch: along its normal, and along its plane while friction sticks.
Patch::Point point_of(const HandTouch& t) {
  if (t.holds) return {t.side, t.stiffness * Mat3::Identity(), Mat3::Zero()};
  const Mat3 along = t.normal * t.normal.transpose();
  const Vec3 rubbing = t.exchanged - along * t.exchanged;
  const double bound = t.friction * t.force;
  const double holds =
      t.force > 0 && rubbing.norm() < slips_from * bound ? bound / coupled::slip_threshold : 0;
  return {t.side, t.stiffness * along, holds * (Mat3::Identity() - along)};
}

/// Returns the friction coefficient relative to a group's resultant. It exceeds the contacts' own where
/// tissue surrounds a finger and presses on its sides, too.
double friction_of(const TouchGroup& group) {
  double most = 0, all = 0;
  for (const HandTouch& t : group.touches) {
    most = std::max(most, t.friction);
    all += t.force;
  }
  return group.pressing > 0 ? most * all / group.pressing : most;
}

/// Turns the plane into a hard surface at its known position. The arm renders the force alone: it can't
/// display the stiffness of a solver's contact, and a solver's force over any delay is unstable.
void make_hard(const TouchGroup& group, ContactPlane& plane) {
  const double contact = joint_stiffness(group);
  const double inside =
      group.pressing > 0 && contact > 0 ? group.pressing / contact : -group.touches.front().gap;
  plane.point = group.point + inside * group.normal;
  plane.force = Vec3::Zero();
  plane.stiffness = plane.tangential = hard_stiffness;
}

}  // namespace

FeltPlanes FeltHand::follow(const Simulation& simulation, const HandState& hand) {
  around_ = simulation.around(ref_, plane_distance);
  std::vector<TouchGroup> groups = grouped(around_.touches);
  std::vector<Place> before = std::move(places_);
  places_.clear();
  for (TouchGroup& group : groups) {
    Place place;
    const auto same = std::find_if(before.begin(), before.end(), [&](const Place& p) {
      return p.id != 0 && p.group.body == group.body && p.group.holds == group.holds &&
             (group.holds || p.group.normal.dot(group.normal) > same_side) &&
             (p.group.point - group.point).norm() < same_place;
    });
    if (same != before.end()) {
      place = *same;
      same->id = 0;  // already assigned
    } else {
      place.id = ++last_id_;
    }
    place.group = std::move(group);
    places_.push_back(std::move(place));
  }
  FeltPlanes out;
  out.participant = ref_.participant;
  out.hand = ref_.hand;
  out.time = simulation.time();
  Vec3 all = Vec3::Zero();  // N, on the hand: sum over all planes
  for (const Place& place : places_) all += place.group.force;
  for (Place& place : places_) out.planes.push_back(plane_of(simulation, hand.pose, all, place));
  count_energy(hand);
  out.taken = taken_;
  out.given = given_;
  return out;
}

/// Returns whether another hand presses or holds the body, and so may move it.
bool FeltHand::others_act(BodyId body) const {
  return std::any_of(around_.supports.begin(), around_.supports.end(),
                     [&](const Support& s) { return s.body == body && s.hand && *s.hand != ref_; });
}

/// Returns a plane's slopes: as computed by the worker, else those of a flat punch on the body's material. A
/// rigid body yields in its contacts only.
Slopes FeltHand::slopes_of(const Simulation& simulation, const Place& place) const {
  if (place.slopes) return *place.slopes;
  const BodyId id = place.group.body;
  const double contact = joint_stiffness(place.group);
  if (simulation.kind(id) != BodyKind::soft) return {contact, contact};
  const soft::SoftBody& body = simulation.soft(id);
  const double punch =
      punch_stiffness(body, area_of(body, place.group.touches), simulation.part(id).stiffness);
  return {contact > 0 ? 1 / (1 / punch + 1 / contact) : punch, punch};
}

ContactPlane FeltHand::plane_of(const Simulation& simulation, const Pose& hand, const Vec3& all,
                                Place& place) const {
  const TouchGroup& group = place.group;
  const Slopes slopes = slopes_of(simulation, place);
  const double give = give_along(group, group.normal) + 1 / std::max(slopes.normal, softest);
  const double sideways =
      give_along(group, group.normal.unitOrthogonal()) + 1 / std::max(slopes.tangential, softest);
  double damping = 0;  // N·s/m
  double radius = least_radius;
  if (simulation.kind(group.body) == BodyKind::soft) {
    const soft::SoftBody& body = simulation.soft(group.body);
    radius = std::max(radius, 2 * std::sqrt(area_of(body, group.touches) / std::numbers::pi));
    damping = body.desc().material.damping_stiffness / give;
  }
  ContactPlane plane;
  plane.id = place.id;
  plane.body = group.body;
  plane.normal = group.normal;
  plane.force = group.force;
  plane.arm = hand.inverse() * group.point;
  // Under load, the arm's point is the hand's point plus the deflection of the coupling between them.
  plane.point = group.pressing > 0 || group.holds
                    ? Vec3(group.point - all / hands::arm_coupling)
                    : Vec3(group.point - group.touches.front().gap * group.normal);
  plane.stiffness = std::min(1 / give, max_plane_stiffness);
  plane.tangential = std::min(1 / sideways, max_plane_stiffness);
  plane.damping = std::min(damping, max_plane_damping);
  plane.friction = std::min(friction_of(group), max_plane_friction);
  plane.holds = group.holds;
  plane.radius = group.holds ? reach_of(group, plane.stiffness) : radius;
  // A contact far from a tool's grip is as soft as the grip: a push rotates the tool in the hand.
  const bool grip_is_softer = give_along(group, group.normal) > 1 / hard_stiffness;
  if (simulation.kind(group.body) != BodyKind::soft && !group.holds && !grip_is_softer)
    make_hard(group, plane);

  const double h = 1 / simulation.scene().tick_rate;
  const double surface = plane.point.dot(plane.normal) + plane.force.dot(plane.normal) / plane.stiffness;
  if (place.known && others_act(group.body))
    place.speed += std::min(1., h / smoothing) * ((surface - place.surface) / h - place.speed);
  else
    place.speed = 0;
  place.surface = surface;
  place.known = true;
  if (std::abs(place.speed) > least_speed)
    plane.velocity = std::clamp(place.speed, -most_speed, most_speed) * plane.normal;
  return plane;
}

/// Adds the work between the hand and bodies over the hand's motion since the last tick.
void FeltHand::count_energy(const HandState& hand) {
  if (last_point_) {
    const double work = hand.contact.force.dot(hand.pose.p - *last_point_);  // J, of the hand on bodies
    (work > 0 ? taken_ : given_) += std::abs(work);
  }
  last_point_ = hand.pose.p;
}

void FeltHand::patches_on(BodyId body, std::vector<Patch>& patches, std::vector<std::uint64_t>& names) const {
  for (const Place& place : places_) {
    if (place.group.body != body) continue;
    Patch& patch = patches.emplace_back();
    patch.normal = place.group.normal;
    patch.hand = ref_;
    patch.presses = place.group.pressing > 0;
    for (const HandTouch& t : place.group.touches) patch.points.push_back(point_of(t));
    names.push_back(name_of(place));
  }
}

void FeltHand::take(const ComplianceAnswer& answer) {
  if (answer.found.size() != answer.names.size()) return;
  for (Place& place : places_) {
    const auto own = std::find(answer.names.begin(), answer.names.end(), name_of(place));
    if (own == answer.names.end()) continue;
    const Slopes& found = answer.found[static_cast<std::size_t>(own - answer.names.begin())];
    if (found.normal > 0 && found.tangential > 0) place.slopes = found;
  }
}

std::uint64_t FeltHand::name_of(const Place& place) const {
  return ref_.participant << 33 ^ std::uint64_t{ref_.hand} << 32 ^ place.id;
}

}  // namespace prosector
