// Collision detection between rigid bodies by Bullet, as in sessions.

#include <array>
#include <cmath>

#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/rigid/collision_shape.h"
#include "server/physics/mechanics/rigid/rigid_world.h"
#include "tests/bench/collision_cases.h"
#include "tests/bench/memory.h"
#include "tests/bench/pair_errors.h"
#include "tests/collision/reference/narrow_phase.h"

namespace prosector {
namespace {

using namespace test;

constexpr double tick = 1.0 / 60;  // s

double diameter(const std::vector<collision::ShapePart>& parts) {
  const CollisionObject object = test::rigid(parts, Fidelity::sphere);
  return 2 * std::get<collision::SphereShape>(object.pieces().front()).radius;
}

/// Returns the parts that compile() makes for a body with the initial rotation `start`.
std::vector<collision::ShapePart> compiled(std::vector<collision::ShapePart> parts, Fidelity fidelity,
                                           const Quat& start) {
  for (collision::ShapePart& part : parts)
    if (part.kind == collision::ShapeKind::triangles && fidelity != Fidelity::mesh) {
      part.kind = collision::ShapeKind::hull;
      part.mesh = std::make_shared<TriangleMesh>(collision::convex_hull(part.mesh->positions));
    }
  return rigid::at_fidelity(std::move(parts), fidelity, {Vec3::Zero(), start});
}

rigid::RigidSetup setup_of(std::vector<collision::ShapePart> parts) {
  rigid::RigidSetup out;
  out.parts = std::move(parts);
  out.mass = 1;
  out.inertia = Vec3::Constant(1e-3);
  return out;
}

rigid::RigidMotion resting(const Pose& pose) {
  rigid::RigidMotion out;
  out.pose = pose;
  return out;
}

/// Returns all contacts of the last detect().
std::vector<rigid::RigidContact> contacts_of(rigid::RigidWorld& world) {
  std::vector<std::size_t> all;  // all bodies, so that all islands are returned
  for (std::size_t slot = 0; slot < world.slots(); ++slot) all.push_back(slot);
  world.find_islands({}, all);
  std::vector<rigid::RigidContact> out;
  for (const rigid::MixedIsland& island : world.solve(tick))
    out.insert(out.end(), island.contacts.begin(), island.contacts.end());
  return out;
}

std::size_t bytes_of(const rigid::RigidSetup& setup) {
  constexpr std::size_t copies = 32;  // several, because malloc reuses freed memory
  rigid::RigidWorld world(Vec3::Zero());
  const std::size_t before = allocated_bytes();
  for (std::size_t i = 0; i < copies; ++i) world.add(setup, {});
  return (allocated_bytes() - before) / copies;
}

}  // namespace

RigidPairs::RigidPairs(const NamedParts& shape, int pairs)
    : name_(shape.name), parts_(shape.parts), size_(diameter(shape.parts)) {
  Random random(1);
  const std::vector<NamedParts>& table = shape_table();
  for (int i = 0; i < pairs; ++i) {
    const std::size_t other = static_cast<std::size_t>(i) % table.size();
    const double reach = (size_ + diameter(table[other].parts)) / 2;
    const Vec3 away = between(random, 0.2, 1) * reach * random_unit(random);
    Placed& pair = pairs_.emplace_back();
    pair.other = other;
    pair.a = {Vec3::Zero(), random_turn(random)};
    pair.b = {away, random_turn(random)};
    pair.start_a = random_turn(random);
    pair.start_b = random_turn(random);
    pair.truth =
        proximity(test::rigid(parts_, Fidelity::mesh, pair.a), from_table(other, Fidelity::mesh, pair.b), 0);
  }
}

ReportRow RigidPairs::measure(Fidelity fidelity) const {
  rigid::RigidWorld world(Vec3::Zero());
  PairErrors errors(size_);
  double us = 0;
  const auto add = [&](const std::vector<collision::ShapePart>& parts, const Quat& start, const Pose& pose) {
    return world.add(setup_of(compiled(parts, fidelity, start)), resting(pose));
  };
  for (const Placed& pair : pairs_) {
    const std::size_t a = add(parts_, pair.start_a, pair.a);
    const std::size_t b = add(shape_table()[pair.other].parts, pair.start_b, pair.b);
    const double start = cpu_ms();
    world.detect(tick);
    us += 1e3 * (cpu_ms() - start);
    std::optional<PairContact> deepest;
    for (const rigid::RigidContact& c : contacts_of(world))
      keep_deepest(deepest, {c.gap, c.a == a ? c.normal : Vec3(-c.normal)});
    errors.add(deepest, pair.truth);
    world.remove(b);
    world.remove(a);
  }
  ReportRow row;
  row["case"] = "pairs";
  row["shape"] = name_;
  row["fidelity"] = fidelity_name(fidelity);
  row["us_per_pair"] = us / static_cast<double>(pairs_.size());
  errors.tell(row);
  row["bytes_per_object"] = bytes_of(setup_of(compiled(parts_, fidelity, Quat::Identity())));
  return row;
}

ReportRow measure_bodies(Fidelity fidelity, int bodies, int ticks) {
  Random random(2);
  std::vector<rigid::RigidSetup> setups;
  for (const NamedParts& shape : shape_table())
    setups.push_back(setup_of(compiled(shape.parts, fidelity, Quat::Identity())));
  rigid::RigidWorld world(Vec3::Zero());
  const std::size_t before = allocated_bytes();
  const double side = 0.13 * std::cbrt(bodies);  // m: dense enough that most bodies touch a neighbour
  std::vector<Pose> poses;
  for (int i = 0; i < bodies; ++i) {
    poses.push_back(random_pose(random, side / 2));
    world.add(setups[static_cast<std::size_t>(i) % setups.size()], resting(poses.back()));
  }
  std::vector<double> place, detect;
  for (int k = 0; k < ticks + 1; ++k) {
    const double start = cpu_ms();
    for (std::size_t slot = 0; slot < poses.size(); ++slot) {
      poses[slot].p += random_point(random, 0.002);
      world.set_motion(slot, resting(poses[slot]));
    }
    const double placed = cpu_ms();
    world.detect(tick);
    if (k == 0) continue;  // the first tick builds the trees
    place.push_back(placed - start);
    detect.push_back(cpu_ms() - placed);
  }
  ReportRow row;
  row["case"] = "bodies";
  row["fidelity"] = fidelity_name(fidelity);
  row["bodies"] = bodies;
  row["ms_place"] = median(place);
  row["ms_detect"] = median(detect);
  row["ms_scene"] = median(place) + median(detect);
  row["contacts"] = contacts_of(world).size();
  row["bytes_per_body"] = static_cast<double>(allocated_bytes() - before) / bodies;
  return row;
}

}  // namespace prosector
