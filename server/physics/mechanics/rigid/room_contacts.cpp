#include "server/physics/mechanics/rigid/room_contacts.h"

#include <limits>

namespace prosector::rigid {

RoomContacts::RoomContacts(btCollisionDispatcher& dispatcher, std::span<const RoomSide> sides)
    : dispatcher_(dispatcher) {
  for (const RoomSide& plane : sides) {
    Side& side = sides_.emplace_back();
    side.plane = plane;
    side.shape = std::make_unique<btStaticPlaneShape>(to_bullet(plane.normal),
                                                      static_cast<btScalar>(plane.normal.dot(plane.point)));
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, side.shape.get());
    info.m_friction = static_cast<btScalar>(room_friction);
    side.body = std::make_unique<btRigidBody>(info);
    const std::size_t number = sides_.size() - 1;
    side.body->setUserIndex(static_cast<int>(room_slot(number)));  // slot_of() recovers the slot
    side.body->setActivationState(ISLAND_SLEEPING);
    side.proxy = std::make_unique<btBroadphaseProxy>();
    side.proxy->m_uniqueId = std::numeric_limits<int>::max() - static_cast<int>(number);
    side.body->setBroadphaseHandle(side.proxy.get());
  }
}

RoomContacts::~RoomContacts() {
  for (auto& [pair, algorithm] : near_) free(algorithm);
}

void RoomContacts::free(btCollisionAlgorithm* algorithm) {
  algorithm->~btCollisionAlgorithm();
  dispatcher_.freeCollisionAlgorithm(algorithm);
}

void RoomContacts::forget(std::size_t slot) {
  const auto first = near_.lower_bound({slot, 0}), last = near_.lower_bound({slot + 1, 0});
  for (auto at = first; at != last; ++at) free(at->second);
  near_.erase(first, last);
}

void RoomContacts::detect(std::size_t slot, btRigidBody& body, RoomSides passes,
                          const btDispatcherInfo& info) {
  if (body.isStaticObject() || !body.isActive()) return;
  btVector3 lo, hi;
  body.getAabb(lo, hi);
  for (std::size_t number = 0; number < sides_.size(); ++number) {
    Side& side = sides_[number];
    const Vec3 &n = side.plane.normal, nearest = n.cwiseMax(0).cwiseProduct(from_bullet(lo)) +
                                                 n.cwiseMin(0).cwiseProduct(from_bullet(hi));
    const bool apart =
        nearest.sum() - n.dot(side.plane.point) > static_cast<double>(gContactBreakingThreshold);
    const auto known = near_.find({slot, number});
    if (apart || has_side(passes, number)) {
      if (known == near_.end()) continue;
      free(known->second);
      near_.erase(known);
      continue;
    }
    const btCollisionObjectWrapper a(nullptr, body.getCollisionShape(), &body, body.getWorldTransform(), -1,
                                     -1);
    const btCollisionObjectWrapper b(nullptr, side.shape.get(), side.body.get(),
                                     side.body->getWorldTransform(), -1, -1);
    btCollisionAlgorithm*& algorithm = near_[{slot, number}];
    if (algorithm == nullptr)
      algorithm = dispatcher_.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    btManifoldResult result(&a, &b);
    algorithm->processCollision(&a, &b, info, &result);
  }
}

}  // namespace prosector::rigid
