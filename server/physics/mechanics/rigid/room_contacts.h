#pragma once
// Contacts of rigid bodies with the sides of the room. Only for the .cpp files of this folder.
//
// The sides are not in Bullet's world. An additional object there would change the order of Bullet's
// broad-phase pairs, and so the hashes of scenes that touch no side.

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/mechanics/rigid/bullet_types.h"
#include "server/physics/mechanics/rigid/room.h"

namespace prosector::rigid {

/// Contact detection of rigid bodies with the sides of the room (floor and walls), which are not in Bullet's
/// world.
class RoomContacts {
 public:
  /// Prepares a Bullet plane for each side of the room. Keeps a reference to `dispatcher`, which must outlive
  /// this object.
  RoomContacts(btCollisionDispatcher& dispatcher, std::span<const RoomSide> sides);
  ~RoomContacts();
  RoomContacts(const RoomContacts&) = delete;
  RoomContacts& operator=(const RoomContacts&) = delete;

  /// Finds the contact points of the body in a slot with the sides of the room, except the sides in `passes`,
  /// through which the body may pass. The contact points are stored in Bullet's dispatcher. Fixed and
  /// sleeping bodies are skipped.
  void detect(std::size_t slot, btRigidBody& body, RoomSides passes, const btDispatcherInfo& info);
  /// Discards the cached contacts of the body in this slot with the sides of the room.
  void forget(std::size_t slot);

 private:
  struct Side {
    RoomSide plane;
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btBroadphaseProxy> proxy;  // determines the order of Bullet's contacts
    std::unique_ptr<btRigidBody> body;
  };
  void free(btCollisionAlgorithm* algorithm);

  btCollisionDispatcher& dispatcher_;
  std::vector<Side> sides_;
  std::map<std::pair<std::size_t, std::size_t>, btCollisionAlgorithm*> near_;  // by slot and side
};

}  // namespace prosector::rigid
