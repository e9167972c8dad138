#include "server/haptics/felt_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/physics/hands/hand.h"
#include "server/physics/soft/soft_body.h"

namespace prosector {
namespace {

constexpr double told_from = 0.03;      // m: what is nearer to a hand is told before it is met
constexpr double one_side = 0.7;        // cosine: normals that are nearer to each other are of one plane
constexpr double same_place = 0.04;     // m: a plane that moved by more is another
constexpr double least_radius = 0.005;  // m
constexpr double held_damping = 1;      // N·s/m: of what is held and free
constexpr double smoothing = 0.1;       // s, of the surface's speed
constexpr double least_speed = 5e-3, most_speed = 0.5;  // m/s: slower counts as still, faster as that

/// Returns what a flat punch as large as the patch would find on a half-space of the body's material, N/m:
/// 2·E*·a (Johnson 1985, "Contact Mechanics", 3.36). It serves until the body itself has been asked.
double punch_stiffness(const SoftBody& body, double area, double strength) {
  const SoftDesc& desc = body.desc();
  const double plane = strength * desc.youngs_modulus / (1 - desc.poisson_ratio * desc.poisson_ratio);
  return 2 * plane * std::sqrt(area / std::numbers::pi);
}

/// Returns the area of the body's surface that the touches stand for, m²; at least a fingertip's.
double area_of(const SoftBody& body, const std::vector<HandTouch>& touches) {
  const std::span<const double> areas = body.surface_area();
  double mean = 0;
  for (const double area : areas) mean += area;
  mean /= static_cast<double>(std::max<std::size_t>(1, areas.size()));
  return std::max(static_cast<double>(touches.size()) * mean, std::numbers::pi * least_radius * least_radius);
}

/// Adds a touch. A group that nothing presses yet is where its touches are; else where they press.
void add(TouchGroup& group, const HandTouch& touch) {
  group.touches.push_back(touch);
  Vec3 pressing = Vec3::Zero(), facing = Vec3::Zero(), pressed = Vec3::Zero(), middle = Vec3::Zero();
  double force = 0;
  group.sliding = Vec3::Zero();
  for (const HandTouch& t : group.touches) {
    pressing += t.force * t.normal;
    pressed += t.force * t.point;
    force += t.force;
    facing += t.normal;
    middle += t.point / static_cast<double>(group.touches.size());
    group.sliding += t.exchanged;
  }
  group.force = pressing.norm();
  group.point = force > 0 ? Vec3(pressed / force) : middle;
  const Vec3& direction = group.force > 0 ? pressing : facing;
  group.normal = direction.norm() > 0 ? Vec3(direction.normalized()) : touch.normal;
  group.sliding -= group.sliding.dot(group.normal) * group.normal;
}

/// Puts touches that are of one body and one side together, the strongest first. Once there are as many
/// groups as there may be, what presses goes to the group of its body that faces it most: no force is left
/// out.
std::vector<TouchGroup> grouped(std::vector<HandTouch> touches) {
  std::stable_sort(touches.begin(), touches.end(),
                   [](const HandTouch& a, const HandTouch& b) { return a.force > b.force; });
  std::vector<TouchGroup> out;
  for (const HandTouch& touch : touches) {
    TouchGroup* nearest = nullptr;
    for (TouchGroup& group : out)
      if (group.body == touch.body &&
          (nearest == nullptr || group.normal.dot(touch.normal) > nearest->normal.dot(touch.normal)))
        nearest = &group;
    const bool fits = nearest != nullptr && nearest->normal.dot(touch.normal) > one_side;
    if (!fits && out.size() < max_contact_planes) {
      nearest = &out.emplace_back();
      nearest->body = touch.body;
    }
    if (nearest != nullptr && (fits || nearest->touches.empty() || touch.force > 0)) add(*nearest, touch);
  }
  return out;
}

/// Returns the contacts' own stiffness, N/m; 0: nothing touches.
double contact_stiffness(const TouchGroup& group) {
  double sum = 0;
  for (const HandTouch& t : group.touches) sum += t.stiffness;
  return sum;
}

double friction_of(const TouchGroup& group) {
  double most = 0;
  for (const HandTouch& t : group.touches) most = std::max(most, t.friction);
  return most;
}

}  // namespace

FeltPlanes FeltHand::follow(const Simulation& simulation, const HandState& hand) {
  around_ = simulation.around(ref_, told_from);
  std::vector<TouchGroup> groups = grouped(around_.touches);
  std::vector<Place> before = std::move(places_);
  places_.clear();
  for (TouchGroup& group : groups) {
    Place place;
    const auto same = std::find_if(before.begin(), before.end(), [&](const Place& p) {
      return p.id != 0 && p.group.body == group.body && p.group.normal.dot(group.normal) > one_side &&
             (p.group.point - group.point).norm() < same_place;
    });
    if (same != before.end()) {
      place = *same;
      same->id = 0;  // it is taken
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
  for (Place& place : places_) out.planes.push_back(plane_of(simulation, hand.pose, place));
  count_energy(hand);
  out.taken = taken_;
  out.given = given_;
  return out;
}

/// Tells whether something besides this hand may move what it touches.
bool FeltHand::others_act(BodyId body) const {
  return std::any_of(around_.supports.begin(), around_.supports.end(),
                     [&](const Support& s) { return s.body == body && s.hand && *s.hand != ref_; });
}

ContactPlane FeltHand::plane_of(const Simulation& simulation, const Pose& hand, Place& place) const {
  const TouchGroup& group = place.group;
  const double strength = simulation.part(group.body).stiffness;
  double give = 1 / arm_coupling, sideways = give, damping = 0;  // m/N
  if (const double contact = contact_stiffness(group); contact > 0) give += 1 / contact;
  double radius = least_radius;
  if (simulation.kind(group.body) == BodyKind::soft) {
    const SoftBody& body = simulation.soft(group.body);
    const double area = area_of(body, group.touches);
    radius = std::max(radius, 2 * std::sqrt(area / std::numbers::pi));
    const double guess = 1 / punch_stiffness(body, area, strength);
    give += place.tissue ? place.tissue->normal : guess;
    sideways += place.tissue ? place.tissue->tangential : guess;
    damping = body.desc().damping_stiffness / give;
  }
  ContactPlane plane;
  plane.id = place.id;
  plane.body = group.body;
  plane.normal = group.normal;
  plane.force = group.force * group.normal + group.sliding;
  plane.arm = hand.inverse() * group.point;
  // What presses is where the arm is, but for what the coupling gives way.
  const bool pressed = group.force > 0;
  plane.point = pressed ? Vec3(group.point - plane.force / arm_coupling)
                        : Vec3(group.point - group.touches.front().gap * group.normal);
  plane.stiffness = std::min(1 / give, max_plane_stiffness);
  plane.tangential = std::min(1 / sideways, max_plane_stiffness);
  plane.damping = std::min(damping, max_plane_damping);
  plane.friction = std::min(friction_of(group), max_plane_friction);
  plane.radius = radius;

  const double h = 1 / simulation.scene().tick_rate;
  const double surface = plane.point.dot(plane.normal) + group.force / plane.stiffness;
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

/// Counts what the hand did to bodies on its way since the last tick, and they to it.
void FeltHand::count_energy(const HandState& hand) {
  if (last_point_) {
    const double work = hand.contact.force.dot(hand.pose.p - *last_point_);  // on bodies
    (work > 0 ? taken_ : given_) += std::abs(work);
  }
  last_point_ = hand.pose.p;
}

void FeltHand::patches_on(BodyId body, std::vector<Patch>& patches, std::vector<std::uint64_t>& names) const {
  for (const Place& place : places_) {
    if (place.group.body != body) continue;
    Patch patch;
    patch.normal = place.group.normal;
    double force = 0;
    for (const HandTouch& t : place.group.touches) force += t.force;
    for (const HandTouch& t : place.group.touches) {
      patch.points.push_back(t.side);
      patch.weight.push_back(force > 0 ? t.force / force
                                       : 1 / static_cast<double>(place.group.touches.size()));
    }
    patches.push_back(std::move(patch));
    names.push_back(name_of(place));
  }
}

void FeltHand::take(std::uint64_t name, const Compliance& found) {
  for (Place& place : places_)
    if (name_of(place) == name && found.normal > 0 && found.tangential > 0) place.tissue = found;
}

std::uint64_t FeltHand::name_of(const Place& place) const {
  return ref_.participant << 33 ^ std::uint64_t{ref_.hand} << 32 ^ place.id;
}

}  // namespace prosector
