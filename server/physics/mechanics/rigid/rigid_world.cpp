#include "server/physics/mechanics/rigid/rigid_world.h"

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>

#include <algorithm>
#include <limits>
#include <map>

#include "common/rotation.h"
#include "server/physics/mechanics/rigid/bullet_shape.h"
#include "server/physics/mechanics/rigid/bullet_types.h"
#include "server/physics/mechanics/rigid/convex_pair.h"
#include "server/physics/mechanics/rigid/phased_world.h"
#include "server/physics/mechanics/rigid/rolling.h"
#include "server/physics/mechanics/rigid/room_contacts.h"
#include "server/physics/mechanics/rigid/sweep.h"

namespace prosector::rigid {
namespace {

// Bullet's default of 0.8 m/s suits bodies of metre size; here they are instruments and bones.
constexpr btScalar sleep_linear = 0.02F;  // m/s
constexpr btScalar sleep_angular = 0.1F;  // rad/s
// s, below the 2 s after which Bullet puts bodies to sleep.
constexpr btScalar most_quiet_while_coupled = 1.5F;
constexpr btScalar lost_per_second = 0.98F;  // fraction of a balanced body's speed lost per second by damping

std::size_t slot_of(const btCollisionObject* object) {
  return static_cast<std::size_t>(object->getUserIndex());
}

constexpr collision::CollisionMask room_mask{~0U,
                                             ~0U};  // the room collides with every body that collides at all

// Bullet's sequential impulses converge slowly where a body bears one of many times its mass. Islands with
// such contacts are solved by the coupled solver, whose factorisation is exact for any ratio.
constexpr double most_mass_ratio = 2;

/// Returns half of the least extent of the parts, m; 0: no parts.
double half_thickness(std::span<const collision::ShapePart> parts) {
  double least = parts.empty() ? 0 : std::numeric_limits<double>::max();
  for (const collision::ShapePart& part : parts)
    least = std::min(least, collision::part_extent(part).half.minCoeff());
  return least;
}

RigidContact make_contact(const btPersistentManifold& manifold, int i) {
  const btManifoldPoint& p = manifold.getContactPoint(i);
  return {slot_of(manifold.getBody0()),
          slot_of(manifold.getBody1()),
          from_bullet(p.getPositionWorldOnA()),
          from_bullet(p.getPositionWorldOnB()),
          from_bullet(p.m_normalWorldOnB),
          static_cast<double>(p.getDistance()),
          static_cast<double>(p.m_combinedFriction),
          static_cast<double>(p.m_combinedRestitution),
          p.m_index0,
          p.m_index1};
}

/// Passes rigid islands to Bullet's solver and stores the mixed ones.
class SplitIslands final : public btSimulationIslandManager::IslandCallback {
 public:
  SplitIslands(PhasedWorld& world, const std::vector<char>& coupled, std::vector<MixedIsland>& mixed)
      : world_(world), coupled_(coupled), mixed_(mixed) {}

  void processIsland(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                     int manifold_count, int) override {
    const auto is_coupled = [&](const btCollisionObject* b) { return coupled_[slot_of(b)] != 0; };
    if (std::none_of(bodies, bodies + body_count, is_coupled)) {
      world_.getConstraintSolver()->solveGroup(bodies, body_count, manifolds, manifold_count, nullptr, 0,
                                               world_.getSolverInfo(), nullptr, world_.getDispatcher());
      return;
    }
    MixedIsland& island = mixed_.emplace_back();
    for (int i = 0; i < body_count; ++i) island.bodies.push_back(slot_of(bodies[i]));
    std::sort(island.bodies.begin(), island.bodies.end());
    for (int m = 0; m < manifold_count; ++m)
      for (int i = 0; i < manifolds[m]->getNumContacts(); ++i)
        island.contacts.push_back(make_contact(*manifolds[m], i));
  }

 private:
  PhasedWorld& world_;
  const std::vector<char>& coupled_;
  std::vector<MixedIsland>& mixed_;
};

}  // namespace

struct RigidWorld::Impl {
  struct Body {
    BulletShape shape;
    std::unique_ptr<btRigidBody> body;  // null: free slot
    RigidSetup setup;                   // without parts
    double half_thickness = 0;          // m: half of the least extent of a part; 0: no parts
    BodyPresence presence = BodyPresence::free;
    Quat given = Quat::Identity();  // rotation of the last set_motion()
    btTransform as_given{};         // that motion's pose, as Bullet stores it
    std::optional<Pose> driven_to;
  };

  CollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  PairFilter filter;
  PhasedWorld world{&dispatcher, &broadphase, &solver, &configuration};
  RoomContacts room;
  std::vector<Body> bodies;
  std::vector<char> coupled;
  std::vector<MixedIsland> mixed;

  Impl(const Vec3& gravity, std::span<const RoomSide> sides) : room(dispatcher, sides) {
    configuration.setPlaneConvexMultipointIterations();
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher);
    world.setGravity(to_bullet(gravity));
    broadphase.getOverlappingPairCache()->setOverlapFilterCallback(&filter);
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    solver.setRandSeed(0);
  }
  ~Impl() {
    for (Body& b : bodies)
      if (b.body) world.removeRigidBody(b.body.get());
  }
  btRigidBody& at(std::size_t slot) { return *bodies[slot].body; }

  RollingSide rolling_side(const btCollisionObject& object) const {
    const std::size_t slot = slot_of(&object);
    if (slot >= bodies.size() || !bodies[slot].body) return {};  // the room
    return {bodies[slot].setup.rolling_resistance, from_bullet(object.getWorldTransform().getOrigin())};
  }

  /// Sets the rolling-resistance lever of this tick's contacts.
  void resist_rolling() {
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
      const RollingSide a = rolling_side(*manifold.getBody0()), b = rolling_side(*manifold.getBody1());
      if (a.resistance == 0 && b.resistance == 0) continue;
      for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& p = manifold.getContactPoint(i);
        p.m_combinedRollingFriction = static_cast<btScalar>(
            rolling_lever(a, b, from_bullet(p.getPositionWorldOnB()), from_bullet(p.m_normalWorldOnB)));
      }
    }
  }

  /// Couples bodies that touch one of much smaller mass.
  void couple_unequal() {
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
      const auto *a = btRigidBody::upcast(manifold.getBody0()), *b = btRigidBody::upcast(manifold.getBody1());
      if (manifold.getNumContacts() == 0 || a->isStaticOrKinematicObject() || b->isStaticOrKinematicObject())
        continue;
      const auto [heavy, light] = std::minmax({a->getInvMass(), b->getInvMass()});
      if (static_cast<double>(light) <= most_mass_ratio * static_cast<double>(heavy)) continue;
      coupled[slot_of(a)] = coupled[slot_of(b)] = 1;
    }
  }

  static bool may_be_swept(const Body& b) {
    return b.body && !b.body->isStaticOrKinematicObject() && b.body->isActive() && !b.setup.hand &&
           b.half_thickness > 0;
  }

  /// Returns a mark for each slot whose body is in a mixed island. Such bodies are not swept: one that tissue
  /// bears would keep the velocity that gravity gives it while it is stopped, and a hand would tear away.
  std::vector<char> coupled_bodies() const {
    std::vector<char> out(bodies.size(), 0);
    for (const MixedIsland& island : mixed)
      for (const std::size_t slot : island.bodies) out[slot] = 1;
    return out;
  }

  /// Integrates all poses. Fast bodies stop where they meet others, and keep their velocity for the contact
  /// that the next step finds there.
  void integrate(double h) {
    const std::vector<char> unswept = coupled_bodies();
    StoppedBodies stopped(world, filter, h);
    for (std::size_t slot = 0; slot < bodies.size(); ++slot)
      if (unswept[slot] == 0 && may_be_swept(bodies[slot]))
        stopped.sweep(*bodies[slot].body, bodies[slot].half_thickness);
    stopped.slow_down();
    world.integrate(static_cast<btScalar>(h));
    stopped.give_velocities_back();
  }

  /// Adds the body to the world with its current masks, gravity and activation state.
  void enter(Body& b) {
    const bool fixed = b.body->isStaticObject();
    const collision::CollisionMask mask =
        b.presence == BodyPresence::absent ? collision::CollisionMask{0, 0} : b.setup.mask;
    world.addRigidBody(b.body.get(), static_cast<int>(mask.group), static_cast<int>(mask.mask));
    if (!fixed && (b.setup.hand || b.setup.balanced)) b.body->setGravity(btVector3(0, 0, 0));
    if (b.setup.hand) b.body->setActivationState(DISABLE_DEACTIVATION);
  }
};

RigidWorld::RigidWorld(const Vec3& gravity, std::span<const RoomSide> room)
    : impl_(std::make_unique<Impl>(gravity, room)) {}
RigidWorld::~RigidWorld() = default;
RigidWorld::RigidWorld(RigidWorld&&) noexcept = default;
RigidWorld& RigidWorld::operator=(RigidWorld&&) noexcept = default;

std::size_t RigidWorld::add(const RigidSetup& setup, const RigidMotion& motion) {
  auto& bodies = impl_->bodies;
  std::size_t slot = 0;
  while (slot < bodies.size() && bodies[slot].body) ++slot;
  if (slot == bodies.size()) bodies.emplace_back();
  Impl::Body& made = bodies[slot];
  made.shape = make_bullet_shape(setup.parts, setup.mass > 0);
  if (!made.shape.root) {
    made.shape.parts.push_back(std::make_unique<btEmptyShape>());
    made.shape.root = made.shape.parts.back().get();
  }
  btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(setup.mass), nullptr, made.shape.root,
                                                to_bullet(setup.inertia));
  info.m_startWorldTransform = to_bullet(motion.pose);
  info.m_friction = static_cast<btScalar>(setup.friction);
  info.m_restitution = static_cast<btScalar>(setup.restitution);
  info.m_linearSleepingThreshold = sleep_linear;
  info.m_angularSleepingThreshold = sleep_angular;
  if (setup.balanced) info.m_linearDamping = info.m_angularDamping = lost_per_second;
  made.body = std::make_unique<btRigidBody>(info);
  made.body->setUserIndex(static_cast<int>(slot));
  if (setup.hand) PairFilter::mark_hand(*made.body);
  made.half_thickness = half_thickness(setup.parts);
  made.setup = setup;
  made.setup.parts.clear();
  made.presence = BodyPresence::free;
  impl_->enter(made);
  set_motion(slot, motion);
  return slot;
}

void RigidWorld::remove(std::size_t slot) {
  for (auto& other : impl_->bodies)
    if (other.body && other.body.get() != &impl_->at(slot))
      other.body->setIgnoreCollisionCheck(&impl_->at(slot), false);
  impl_->room.forget(slot);
  impl_->world.removeRigidBody(&impl_->at(slot));
  impl_->bodies[slot].body.reset();
  impl_->bodies[slot].shape = {};
  impl_->bodies[slot].driven_to.reset();
}

std::size_t RigidWorld::slots() const {
  return impl_->bodies.size();
}
bool RigidWorld::used(std::size_t slot) const {
  return slot < impl_->bodies.size() && impl_->bodies[slot].body != nullptr;
}
bool RigidWorld::dynamic(std::size_t slot) const {
  return !is_room(slot) && !impl_->at(slot).isStaticObject();
}
const collision::CollisionMask& RigidWorld::mask(std::size_t slot) const {
  return is_room(slot) ? room_mask : impl_->bodies[slot].setup.mask;
}

void RigidWorld::set_presence(std::size_t slot, BodyPresence presence) {
  Impl::Body& b = impl_->bodies[slot];
  if (b.presence == presence) return;
  b.presence = presence;
  impl_->room.forget(slot);
  impl_->world.removeRigidBody(b.body.get());
  const bool stays = presence != BodyPresence::free || !(b.setup.mass > 0);
  b.body->setMassProps(stays ? 0 : static_cast<btScalar>(b.setup.mass),
                       stays ? btVector3(0, 0, 0) : to_bullet(b.setup.inertia));
  RigidMotion still = motion(slot, Rounding::none);
  still.linear_velocity = still.angular_velocity = Vec3::Zero();
  still.asleep = false;
  still.quiet_seconds = 0;
  impl_->enter(b);
  set_motion(slot, still);
}

BodyPresence RigidWorld::presence(std::size_t slot) const {
  return impl_->bodies[slot].presence;
}

RigidMotion RigidWorld::motion(std::size_t slot, Rounding rounding) const {
  const Impl::Body& body = impl_->bodies[slot];
  const btRigidBody& b = *body.body;
  Pose pose = from_bullet(b.getWorldTransform());
  if (rounding == Rounding::none && b.getWorldTransform() == body.as_given) pose.q = body.given;
  return {pose, from_bullet(b.getLinearVelocity()), from_bullet(b.getAngularVelocity()),
          b.getActivationState() == ISLAND_SLEEPING, static_cast<double>(b.getDeactivationTime())};
}

void RigidWorld::set_motion(std::size_t slot, const RigidMotion& motion) {
  btRigidBody& b = impl_->at(slot);
  const btTransform pose = to_bullet(motion.pose);
  impl_->bodies[slot].given = motion.pose.q;
  impl_->bodies[slot].as_given = pose;
  b.setWorldTransform(pose);
  b.setInterpolationWorldTransform(pose);
  set_velocity(slot, motion.linear_velocity, motion.angular_velocity);
  b.setInterpolationLinearVelocity(b.getLinearVelocity());
  b.setInterpolationAngularVelocity(b.getAngularVelocity());
  b.updateInertiaTensor();
  if (b.isStaticObject() || b.getActivationState() == DISABLE_DEACTIVATION) return;
  b.forceActivationState(motion.asleep ? ISLAND_SLEEPING : ACTIVE_TAG);
  b.setDeactivationTime(static_cast<btScalar>(motion.quiet_seconds));
}

void RigidWorld::set_velocity(std::size_t slot, const Vec3& linear, const Vec3& angular) {
  btRigidBody& b = impl_->at(slot);
  b.setLinearVelocity(to_bullet(linear));
  b.setAngularVelocity(to_bullet(angular));
}

void RigidWorld::wake(std::size_t slot) {
  impl_->at(slot).activate();
}

void RigidWorld::sleep(std::size_t slot, Sleep when) {
  btRigidBody& b = impl_->at(slot);
  if (b.getActivationState() == DISABLE_DEACTIVATION) return;
  b.forceActivationState(when == Sleep::at_once ? ISLAND_SLEEPING : WANTS_DEACTIVATION);
  set_velocity(slot, Vec3::Zero(), Vec3::Zero());
}

void RigidWorld::stay_awake(std::size_t slot) {
  btRigidBody& b = impl_->at(slot);
  if (b.getActivationState() == DISABLE_DEACTIVATION) return;
  b.setDeactivationTime(std::min(b.getDeactivationTime(), most_quiet_while_coupled));
  b.forceActivationState(ACTIVE_TAG);
}

void RigidWorld::drive(std::size_t slot, const Pose& to, double h) {
  btRigidBody& b = impl_->at(slot);
  impl_->bodies[slot].driven_to = to;
  b.setCollisionFlags(b.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  b.forceActivationState(DISABLE_DEACTIVATION);
  const Pose from = from_bullet(b.getWorldTransform());
  set_velocity(slot, (to.p - from.p) / h, turn(from.q, to.q) / h);
}

const std::optional<Pose>& RigidWorld::driven_to(std::size_t slot) const {
  static const std::optional<Pose> stands_still;
  return is_room(slot) ? stands_still : impl_->bodies[slot].driven_to;
}

void RigidWorld::set_part_pose(std::size_t slot, std::size_t part, const Pose& pose) {
  impl_->bodies[slot].shape.compound->updateChildTransform(static_cast<int>(part), to_bullet(pose), true);
  // Cached contact points at the part's old pose are invalid.
  for (int m = 0; m < impl_->dispatcher.getNumManifolds(); ++m) {
    btPersistentManifold& manifold = *impl_->dispatcher.getManifoldByIndexInternal(m);
    const bool first = manifold.getBody0() == &impl_->at(slot);
    if (!first && manifold.getBody1() != &impl_->at(slot)) continue;
    for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
      const btManifoldPoint& p = manifold.getContactPoint(i);
      if ((first ? p.m_index0 : p.m_index1) == static_cast<int>(part)) manifold.removeContactPoint(i);
    }
  }
}

void RigidWorld::set_collides(std::size_t a, std::size_t b, bool collides) {
  impl_->at(a).setIgnoreCollisionCheck(&impl_->at(b), !collides);
  impl_->at(b).setIgnoreCollisionCheck(&impl_->at(a), !collides);
  // Cached contact points of the pair would still push.
  impl_->broadphase.getOverlappingPairCache()->cleanProxyFromPairs(impl_->at(a).getBroadphaseHandle(),
                                                                   &impl_->dispatcher);
}

std::pair<Vec3, Vec3> RigidWorld::bounds(std::size_t slot, double margin) const {
  btVector3 lo, hi;
  impl_->at(slot).getAabb(lo, hi);
  return {from_bullet(lo) - Vec3::Constant(margin), from_bullet(hi) + Vec3::Constant(margin)};
}

void RigidWorld::detect(double h) {
  impl_->world.detect(static_cast<btScalar>(h));
  for (std::size_t slot = 0; slot < slots(); ++slot)
    if (used(slot))
      impl_->room.detect(slot, impl_->at(slot), impl_->bodies[slot].setup.passes,
                         impl_->world.getDispatchInfo());
  impl_->resist_rolling();
}

void RigidWorld::find_islands(std::span<const std::pair<std::size_t, std::size_t>> links,
                              std::span<const std::size_t> coupled) {
  std::vector<std::pair<btRigidBody*, btRigidBody*>> bodies;
  for (const auto& [a, b] : links) bodies.emplace_back(&impl_->at(a), &impl_->at(b));
  impl_->world.find_islands(bodies);
  impl_->coupled.assign(impl_->bodies.size(), 0);
  for (const std::size_t slot : coupled) {
    impl_->coupled[slot] = 1;
    // Otherwise Bullet would put the body to sleep in this step and pass over its island.
    if (btRigidBody& b = impl_->at(slot); b.getActivationState() == WANTS_DEACTIVATION)
      b.forceActivationState(ACTIVE_TAG);
  }
  impl_->couple_unequal();
}

const std::vector<MixedIsland>& RigidWorld::solve(double h) {
  impl_->mixed.clear();
  SplitIslands split(impl_->world, impl_->coupled, impl_->mixed);
  impl_->world.solve(static_cast<btScalar>(h), split);
  return impl_->mixed;
}

std::pair<Vec3, Vec3> RigidWorld::predicted_velocity(std::size_t slot, double h) const {
  const btRigidBody& b = impl_->at(slot);
  const auto step = static_cast<btScalar>(h);
  const btVector3 linear = b.getLinearVelocity() + b.getTotalForce() * b.getInvMass() * step;
  const btVector3 angular = b.getAngularVelocity() + b.computeGyroscopicImpulseImplicit_Body(step);
  return {from_bullet(linear), from_bullet(angular)};
}

void RigidWorld::integrate(double h) {
  impl_->integrate(h);
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    if (!used(slot) || !driven_to(slot)) continue;
    btRigidBody& b = impl_->at(slot);
    set_motion(slot, {*driven_to(slot)});
    b.setCollisionFlags(b.getCollisionFlags() & ~btCollisionObject::CF_KINEMATIC_OBJECT);
    b.forceActivationState(ACTIVE_TAG);
    impl_->bodies[slot].driven_to.reset();
  }
}

std::vector<RigidImpulse> RigidWorld::impulses(std::size_t slot) const {
  std::vector<RigidImpulse> out;
  for (int m = 0; m < impl_->dispatcher.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *impl_->dispatcher.getManifoldByIndexInternal(m);
    const bool first = slot_of(manifold.getBody0()) == slot;
    if (!first && slot_of(manifold.getBody1()) != slot) continue;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      const btManifoldPoint& p = manifold.getContactPoint(i);
      const btVector3 impulse = p.m_appliedImpulse * p.m_normalWorldOnB +
                                p.m_appliedImpulseLateral1 * p.m_lateralFrictionDir1 +
                                p.m_appliedImpulseLateral2 * p.m_lateralFrictionDir2;
      out.push_back({from_bullet(first ? p.getPositionWorldOnA() : p.getPositionWorldOnB()),
                     from_bullet(first ? impulse : -impulse)});
    }
  }
  return out;
}

void RigidWorld::hash(StateHasher& hasher) const {
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    if (!used(slot)) continue;
    const btRigidBody& b = impl_->at(slot);
    hasher.add(slot);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) hasher.add(b.getWorldTransform().getBasis()[row][column]);
    for (int i = 0; i < 3; ++i) {
      hasher.add(b.getWorldTransform().getOrigin()[i]);
      hasher.add(b.getLinearVelocity()[i]);
      hasher.add(b.getAngularVelocity()[i]);
    }
    hasher.add(b.getActivationState());
    hasher.add(b.getDeactivationTime());
  }
  for (int m = 0; m < impl_->dispatcher.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *impl_->dispatcher.getManifoldByIndexInternal(m);
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      hasher.add(manifold.getContactPoint(i).m_distance1);
      hasher.add(manifold.getContactPoint(i).m_appliedImpulse);
    }
  }
}

}  // namespace prosector::rigid
