#include "server/physics/mechanics/panel/panel_motion.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "common/rotation_between.h"
#include "server/physics/mechanics/rigid/bullet_types.h"

namespace prosector::panel {
namespace {

constexpr double cap_mass = 0.02;   // kg
constexpr double cap_depth = 0.03;  // m, of the caps' boxes, mostly behind the board
// Factor on a cap's inertia, so that friction pulls the cap without tilting it.
constexpr double no_tilting = 1000;
constexpr double button_damping = 5;       // N·s/m: slightly below critical damping of cap and spring
constexpr double knob_friction = 1.5;      // N
constexpr double finger_friction = 1.2;    // of skin on rubber
constexpr double margin = 0.0005;          // m: Bullet's collision margin of boxes
constexpr double slop = 0.001;             // m: penetration at which a finger is stopped
constexpr double longest_substep = 0.002;  // s
constexpr int most_substeps = 32;
constexpr int iterations = 40;  // of the solver: the knob follows the finger's speed within 1 %
// m/s; fraction of travel: below both, a free button is at rest.
constexpr double rest_speed = 1e-3, rest_position = 1e-3;
// Bullet's GJK treats support points less than 1 cm apart as equal, since
// VORONOI_DEFAULT_EQUAL_VERTEX_THRESHOLD is a squared distance. That loses contacts of fingers with buttons,
// so one Bullet length unit is a centimetre here.
constexpr double units = 100;  // Bullet length units per metre
constexpr short caps_group = 1, fingers_group = 2;

constexpr double board_reach = 0.04;  // m: distance in front of the board within which a segment may touch it

/// Returns the interval [first, second] of the segment from a to b, as fractions, over a rectangle; none: not
/// over it.
std::optional<std::pair<double, double>> over(const Capsule& c, double x, double y, double half_x,
                                              double half_y) {
  double first = 0, last = 1;
  const std::array<double, 2> middle = {x, y}, half = {half_x, half_y};
  for (int axis = 0; axis < 2; ++axis) {
    const double start = c.a[axis] - middle[static_cast<std::size_t>(axis)];
    const double way = c.b[axis] - c.a[axis];
    const double reach = half[static_cast<std::size_t>(axis)];
    if (std::abs(way) < 1e-9) {
      if (std::abs(start) > reach) return std::nullopt;
      continue;
    }
    const double t0 = (-reach - start) / way, t1 = (reach - start) / way;
    first = std::max(first, std::min(t0, t1));
    last = std::min(last, std::max(t0, t1));
  }
  if (first > last) return std::nullopt;
  return std::pair(first, last);
}

/// Returns by how much the segment must be lifted so that its portion over the rectangle is above `floor`.
double lift_over(const Capsule& c, double x, double y, double half_x, double half_y, double floor) {
  const auto share = over(c, x, y, half_x, half_y);
  if (!share) return 0;
  const auto z_at = [&](double t) { return c.a.z() + t * (c.b.z() - c.a.z()); };
  return floor - (std::min(z_at(share->first), z_at(share->second)) - c.radius);
}

/// Returns the finger, stopped by board, pressed buttons and knob. Returns none if it is too deep behind the
/// board or away from it.
std::optional<Capsule> stopped(Capsule c, const ControlMotions& motions) {
  if (!near_panel(c)) return std::nullopt;
  double lift = lift_over(c, 0, 0, panel_width / 2, panel_height / 2, -slop);
  for (const ControlDesc& control : panel_controls) {
    const bool button = control.kind == ControlKind::button;
    const double position = button ? 1 : motions[static_cast<std::size_t>(control.control)].position;
    const Vec3 face = control_face(control, position);
    lift = std::max(
        lift, lift_over(c, face.x(), face.y(), control.half_width, control.half_height, face.z() - slop));
  }
  if (lift > finger_depth) return std::nullopt;
  c.a.z() += std::max(lift, 0.0);
  c.b.z() += std::max(lift, 0.0);
  return c;
}

Capsule between(const Capsule& from, const Capsule& to, double share) {
  return {from.a + share * (to.a - from.a), from.b + share * (to.b - from.b), to.radius};
}

btVector3 scaled(const Vec3& v) {
  return rigid::to_bullet(Vec3(units * v));
}
btScalar scaled(double length) {
  return static_cast<btScalar>(units * length);
}
btTransform scaled(const Pose& pose) {
  return rigid::to_bullet(Pose{units * pose.p, pose.q});
}
Vec3 unscaled(const btVector3& v) {
  return rigid::from_bullet(v) / units;
}

Pose pose_of(const Capsule& c) {
  const Vec3 along = c.b - c.a;
  const Vec3 middle = (c.a + c.b) / 2;
  if (along.norm() < 1e-9) return {middle, Quat::Identity()};
  return {middle, rotation_between(Vec3::UnitY(), along)};  // Bullet's capsules are along y
}

/// Bullet's world for one tick of one panel, in the panel's frame.
class TickWorld {
 public:
  TickWorld(const ControlMotions& motions, std::size_t finger_count)
      : configuration_(small_pools()),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &pairs_, &solver_, &configuration_),
        motions_(motions) {
    world_.setGravity({0, 0, 0});
    // Split impulses would separate finger and knob without a contact force, and so without friction.
    world_.getSolverInfo().m_splitImpulse = 0;
    world_.getSolverInfo().m_numIterations = iterations;
    fingers_.reserve(finger_count);
    for (const ControlDesc& control : panel_controls) add(control);
  }
  ~TickWorld() {
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const Finger& finger : fingers_)
      if (finger.present) world_.removeRigidBody(finger.body.get());
    for (const auto& cap : caps_) world_.removeRigidBody(cap.get());
  }
  TickWorld(const TickWorld&) = delete;
  TickWorld& operator=(const TickWorld&) = delete;

  void add_finger(const Capsule& c) {
    Finger& finger = fingers_.emplace_back();
    finger.shape = std::make_unique<btCapsuleShape>(scaled(c.radius), scaled((c.b - c.a).norm()));
    finger.body = std::make_unique<btRigidBody>(0, nullptr, finger.shape.get());
    finger.body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    finger.body->setActivationState(DISABLE_DEACTIVATION);
    finger.body->setFriction(static_cast<btScalar>(finger_friction));
  }

  /// Sets a finger's pose at the substep's start and end. A new finger has zero speed.
  void place_finger(std::size_t index, const std::optional<Capsule>& from, const std::optional<Capsule>& to) {
    Finger& finger = fingers_[index];
    if (finger.present && !to) world_.removeRigidBody(finger.body.get());
    if (to) {
      finger.body->setWorldTransform(scaled(pose_of(*to)));
      if (!finger.present) {
        finger.body->setInterpolationWorldTransform(scaled(pose_of(from ? *from : *to)));
        world_.addRigidBody(finger.body.get(), fingers_group, caps_group);
      }
    }
    finger.present = to.has_value();
  }

  void step(double h) {
    world_.stepSimulation(static_cast<btScalar>(h), 0);
    for (std::size_t k = 0; k < caps_.size(); ++k) read(panel_controls[k]);
    note_touches();
  }

  const ControlMotions& motions() const { return motions_; }
  const std::bitset<panel_control_count>& touched() const { return touched_; }

 private:
  struct Finger {
    std::unique_ptr<btCapsuleShape> shape;
    std::unique_ptr<btRigidBody> body;
    bool present = false;
  };

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase pairs_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btBoxShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> caps_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::vector<Finger> fingers_;
  btRigidBody board_{0, nullptr, nullptr};
  ControlMotions motions_;
  std::bitset<panel_control_count> touched_;

  static btDefaultCollisionConstructionInfo small_pools() {
    btDefaultCollisionConstructionInfo info;
    info.m_defaultMaxPersistentManifoldPoolSize = 64;
    info.m_defaultMaxCollisionAlgorithmPoolSize = 64;
    return info;
  }

  static Vec3 direction(const ControlDesc& control) {
    return control.kind == ControlKind::button ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitX());
  }

  /// Returns the centre of a cap's box, whose front face is the control's face.
  static Pose middle(const ControlDesc& control, double position) {
    return {control_face(control, position) - Vec3(0, 0, cap_depth / 2), Quat::Identity()};
  }

  void add(const ControlDesc& control) {
    shapes_.push_back(
        std::make_unique<btBoxShape>(scaled(Vec3(control.half_width, control.half_height, cap_depth / 2))));
    shapes_.back()->setMargin(scaled(margin));
    btVector3 inertia;
    shapes_.back()->calculateLocalInertia(static_cast<btScalar>(cap_mass), inertia);
    inertia *= static_cast<btScalar>(no_tilting);
    caps_.push_back(std::make_unique<btRigidBody>(static_cast<btScalar>(cap_mass), nullptr,
                                                  shapes_.back().get(), inertia));
    btRigidBody& cap = *caps_.back();
    cap.setActivationState(DISABLE_DEACTIVATION);
    cap.setFriction(1);
    put(control);
    world_.addRigidBody(&cap, caps_group, fingers_group);
    joints_.push_back(control.kind == ControlKind::button ? spring(control, cap) : rail(control, cap));
    world_.addConstraint(joints_.back().get(), true);
  }

  std::unique_ptr<btTypedConstraint> spring(const ControlDesc& control, btRigidBody& cap) {
    auto joint = std::make_unique<btGeneric6DofSpring2Constraint>(board_, cap, scaled(middle(control, 0)),
                                                                  btTransform::getIdentity());
    joint->setLinearLowerLimit({0, 0, scaled(-control.travel)});
    joint->setLinearUpperLimit({0, 0, 0});
    joint->setAngularLowerLimit({0, 0, 0});
    joint->setAngularUpperLimit({0, 0, 0});
    joint->enableSpring(2, true);
    joint->setStiffness(2, static_cast<btScalar>(button_stiffness));
    joint->setDamping(2, static_cast<btScalar>(button_damping));
    joint->setEquilibriumPoint(2, 0);
    return joint;
  }

  std::unique_ptr<btTypedConstraint> rail(const ControlDesc& control, btRigidBody& cap) {
    auto joint = std::make_unique<btSliderConstraint>(board_, cap, scaled(middle(control, 0.5)),
                                                      btTransform::getIdentity(), true);
    joint->setLowerLinLimit(scaled(-control.travel / 2));
    joint->setUpperLinLimit(scaled(control.travel / 2));
    joint->setLowerAngLimit(0);
    joint->setUpperAngLimit(0);
    joint->setPoweredLinMotor(true);
    joint->setTargetLinMotorVelocity(0);
    joint->setMaxLinMotorForce(scaled(knob_friction));
    return joint;
  }

  /// Sets a cap's pose and velocity from the control's motion.
  void put(const ControlDesc& control) {
    const ControlMotion& motion = motions_[static_cast<std::size_t>(control.control)];
    btRigidBody& cap = *caps_[static_cast<std::size_t>(control.control)];
    cap.setCenterOfMassTransform(scaled(middle(control, motion.position)));
    cap.setLinearVelocity(scaled(Vec3(motion.velocity * direction(control))));
    cap.setAngularVelocity({0, 0, 0});
  }

  /// Reads the control's motion from its cap. Discards residual motion in constrained directions, and
  /// enforces the stops exactly.
  void read(const ControlDesc& control) {
    const auto k = static_cast<std::size_t>(control.control);
    const Vec3 moved = unscaled(caps_[k]->getWorldTransform().getOrigin()) - middle(control, 0).p;
    ControlMotion motion;
    motion.position = moved.dot(direction(control)) / control.travel;
    motion.velocity = unscaled(caps_[k]->getLinearVelocity()).dot(direction(control));
    if (!std::isfinite(motion.position) || !std::isfinite(motion.velocity)) motion = {};
    motion.velocity = std::clamp(motion.velocity, -max_control_speed, max_control_speed);
    if (motion.position <= 0) motion.velocity = std::max(motion.velocity, 0.0);
    if (motion.position >= 1) motion.velocity = std::min(motion.velocity, 0.0);
    motion.position = std::clamp(motion.position, 0.0, 1.0);
    motions_[k] = motion;
    put(control);
  }

  void note_touches() {
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      if (manifold.getNumContacts() == 0) continue;
      for (std::size_t k = 0; k < caps_.size(); ++k)
        if (manifold.getBody0() == caps_[k].get() || manifold.getBody1() == caps_[k].get()) touched_.set(k);
    }
  }
};

bool at_rest(const ControlMotions& motions) {
  return std::all_of(panel_controls.begin(), panel_controls.end(), [&](const ControlDesc& control) {
    const ControlMotion& m = motions[static_cast<std::size_t>(control.control)];
    return m.velocity == 0 && (control.kind == ControlKind::slider || m.position == 0);
  });
}

/// Settles controls: an untouched button near its rest position is set to rest; an untouched slow knob is
/// stopped.
void settle(MovedControls& moved) {
  for (const ControlDesc& control : panel_controls) {
    const auto k = static_cast<std::size_t>(control.control);
    ControlMotion& m = moved.motions[k];
    if (moved.touched[k] || std::abs(m.velocity) > rest_speed) continue;
    if (control.kind == ControlKind::slider) m.velocity = 0;
    if (control.kind == ControlKind::button && m.position < rest_position) m = {};
  }
}

}  // namespace

bool near_panel(const Capsule& c) {
  if (!c.a.allFinite() || !c.b.allFinite()) return false;
  const Vec3 low = c.a.cwiseMin(c.b).array() - c.radius, high = c.a.cwiseMax(c.b).array() + c.radius;
  return low.x() < panel_width / 2 && high.x() > -panel_width / 2 && low.y() < panel_height / 2 &&
         high.y() > -panel_height / 2 && low.z() < board_reach && high.z() > -finger_depth;
}

AtBoard at_board(const Capsule& c) {
  double highest = 0;  // m: the highest point above the board
  for (const ControlDesc& control : panel_controls) highest = std::max(highest, control_face(control, 0).z());
  const auto is_below = [&](double height) {
    return lift_over(c, 0, 0, panel_width / 2, panel_height / 2, height) > 0;
  };
  if (!is_below(-graze) && std::min(c.a.z(), c.b.z()) - c.radius < -graze) return AtBoard::beside;
  return is_below(highest) ? AtBoard::under : AtBoard::over;
}

MovedControls move_controls(const ControlMotions& before, std::span<const FingerSweep> fingers, double h) {
  std::vector<FingerSweep> close;
  for (FingerSweep sweep : fingers) {
    const bool jumped = !sweep.from.a.allFinite() || !sweep.from.b.allFinite() ||
                        (sweep.to.a - sweep.from.a).norm() > max_finger_way ||
                        (sweep.to.b - sweep.from.b).norm() > max_finger_way;
    if (jumped) sweep.from = sweep.to;
    if (near_panel(sweep.from) || near_panel(sweep.to)) close.push_back(sweep);
  }
  MovedControls out{before, {}};
  if (close.empty() && at_rest(before)) return out;

  const int substeps = std::clamp(static_cast<int>(std::ceil(h / longest_substep)), 1, most_substeps);
  TickWorld world(before, close.size());
  for (const FingerSweep& sweep : close) world.add_finger(sweep.to);
  for (int s = 1; s <= substeps; ++s) {
    for (std::size_t f = 0; f < close.size(); ++f) {
      const auto at = [&](int k) {
        return stopped(between(close[f].from, close[f].to, static_cast<double>(k) / substeps),
                       world.motions());
      };
      world.place_finger(f, at(s - 1), at(s));
    }
    world.step(h / substeps);
  }
  out = {world.motions(), world.touched()};
  settle(out);
  return out;
}

}  // namespace prosector::panel
