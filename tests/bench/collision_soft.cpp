// Collision detection of soft bodies with rigid bodies and with each other, as in sessions.

#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/stations/compile/compile.h"
#include "server/physics/stations/touching/fit_tissue.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"
#include "server/physics/stations/touching/soft_contact_finder.h"
#include "tests/bench/collision_cases.h"
#include "tests/bench/pair_errors.h"
#include "tests/collision/reference/narrow_phase.h"

namespace prosector {
namespace {

using namespace test;

constexpr double tick = 1.0 / 60;  // s
const Vec3 organ_size(0.12, 0.07, 0.09);

SoftDesc organ(const std::string& name, Fidelity fidelity) {
  SoftDesc out;
  out.name = name;
  out.geometry.shape = "kidney";
  out.geometry.size = organ_size;
  out.geometry.cell = 0.02;
  out.geometry.surface_cell = 0.008;
  out.contact.collision = fidelity;
  return out;
}

CompiledScene compile_organs(Fidelity fidelity) {
  SceneDesc scene;
  scene.soft = {organ("first", fidelity), organ("second", fidelity)};
  CompileOptions options;
  options.threads = 1;
  return compile(scene, options);
}

/// Two organs at the same position, in the state before a session's first tick.
struct Organs {
  explicit Organs(Fidelity fidelity)
      : scene(compile_organs(fidelity)), state(scene.model, std::move(scene.soft)) {
    for (Tissue& tissue : state.bodies.soft) fit_to_mesh(state, tissue.index, {});
  }
  Tissue& first() { return state.bodies.soft[0]; }
  Tissue& second() { return state.bodies.soft[1]; }

  CompiledScene scene;
  State state;
};

/// Returns the organ's undeformed surface for the reference.
CollisionObject reference_of(const Tissue& tissue) {
  return CollisionObject(tissue.anatomy().surface, Fidelity::mesh);
}

/// A rigid body at fidelity `mesh`, as soft bodies collide with it.
class Probe {
 public:
  explicit Probe(const std::vector<collision::ShapePart>& parts)
      : parts_(parts),
        outline_(parts,
                 parts.front().kind == collision::ShapeKind::triangles ? Fidelity::mesh : Fidelity::hull),
        world_(Vec3::Zero()) {
    for (const collision::ShapePart& part : parts_) distances_.push_back(contact::make_signed_distance(part));
    rigid::RigidSetup setup;
    setup.parts = parts_;
    setup.mass = 1;
    setup.inertia = Vec3::Constant(1e-3);
    slot_ = world_.add(setup, {});
  }

  contact::Collider at(const Pose& pose) {
    rigid::RigidMotion motion;
    motion.pose = pose;
    world_.set_motion(slot_, motion);
    contact::Collider out;
    out.slot = slot_;
    out.pose = pose;
    out.parts = &parts_;
    out.distances = &distances_;
    for (const collision::ShapePart& part : parts_) out.part_poses.push_back(part.pose);
    std::tie(out.lo, out.hi) = world_.bounds(slot_, 0);
    out.outline = &outline_;
    return out;
  }

 private:
  std::vector<collision::ShapePart> parts_;
  std::vector<std::unique_ptr<contact::SignedDistance>> distances_;
  collision::RigidOutline outline_;
  rigid::RigidWorld world_;
  std::size_t slot_ = 0;
};

/// Returns a random pose around `middle`, up to the distance at which objects of these sizes may just touch.
Pose pose_around(Random& random, const Vec3& middle, double size, double other_size) {
  const Vec3 away = between(random, 0.2, 1) * (size + other_size) / 2 * random_unit(random);
  return {middle + away, random_turn(random)};
}

ReportRow row_of(const char* name, Fidelity fidelity, double us, int pairs, const PairErrors& errors) {
  ReportRow row;
  row["case"] = name;
  row["fidelity"] = fidelity_name(fidelity);
  row["us_per_pair"] = us / pairs;
  errors.tell(row);
  return row;
}

}  // namespace

ReportRow measure_organ_and_rigid(Fidelity fidelity, const NamedParts& shape, int pairs) {
  Organs organs(fidelity);
  Probe probe(shape.parts);
  const Tissue& tissue = organs.first();
  const CollisionObject own = reference_of(tissue);
  CollisionObject other = test::rigid(shape.parts, Fidelity::mesh);
  const double size = organ_size.norm(), other_size = 2 * other.box().half().norm();
  Random random(3);
  PairErrors errors(size);
  double us = 0;
  std::vector<contact::Contact> found;
  for (int i = 0; i < pairs; ++i) {
    const Pose pose = pose_around(random, own.box().center(), size, other_size);
    const contact::Collider collider = probe.at(pose);
    found.clear();
    const double start = cpu_ms();
    add_contacts(tissue, collider, contact::contact_margin, tissue.memories, tick, found);
    us += 1e3 * (cpu_ms() - start);
    std::optional<PairContact> deepest;
    for (const contact::Contact& c : found) keep_deepest(deepest, {c.gap, c.normal});
    other.place(pose);
    errors.add(deepest, proximity(own, other, 0));
  }
  ReportRow row = row_of("organ_rigid", fidelity, us, pairs, errors);
  row["shape"] = shape.name;
  return row;
}

ReportRow measure_two_organs(Fidelity fidelity, int pairs) {
  Organs organs(fidelity);
  Tissue &a = organs.first(), &b = organs.second();
  const CollisionObject own = reference_of(a);
  CollisionObject other = reference_of(b);
  const VecX rest = b.state.motion.x;
  const std::vector<Vec3> surface = b.anatomy().surface.positions;
  const Vec3 middle = own.box().center();
  const double size = organ_size.norm();
  SoftContactFinder finder(2);
  Random random(4);
  PairErrors errors(size);
  double us = 0;
  std::vector<contact::Contact> found;
  for (int i = 0; i < pairs; ++i) {
    const Pose around = pose_around(random, middle, size, size);
    const Pose pose = around * Pose{-middle, Quat::Identity()};
    for (Eigen::Index n = 0; n < rest.size(); n += 3)
      b.state.motion.x.segment<3>(n) = pose * Vec3(rest.segment<3>(n));
    a.begin_tick();
    b.begin_tick();
    b.place_surface();
    found.clear();
    const double start = cpu_ms();
    finder.add_pair_contacts(organs.state, 0, 1, contact::contact_margin, tick, found);
    us += 1e3 * (cpu_ms() - start);
    std::optional<PairContact> deepest;
    for (const contact::Contact& c : found)
      keep_deepest(deepest, {c.gap, c.a.body == a.index ? c.normal : Vec3(-c.normal)});
    std::vector<Vec3> moved_surface = surface;
    for (Vec3& x : moved_surface) x = pose * x;
    other.move(moved_surface);
    errors.add(deepest, proximity(own, other, 0));
  }
  return row_of("two_organs", fidelity, us, pairs, errors);
}

}  // namespace prosector
