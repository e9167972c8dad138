#pragma once
// Where rigid bodies meet the room's sides. Only for the .cpp files of this folder.
//
// The sides are not in Bullet's world. One more object there would change the order in which its broad phase
// finds pairs of others, and with it the hashes of scenes that touch no side.

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/rigid/bullet_types.h"
#include "server/physics/rigid/room.h"

namespace prosector {

class RoomContacts {
 public:
  /// Keeps a reference: the dispatcher outlives this.
  RoomContacts(btCollisionDispatcher& dispatcher, std::span<const RoomSide> sides);
  ~RoomContacts();
  RoomContacts(const RoomContacts&) = delete;
  RoomContacts& operator=(const RoomContacts&) = delete;

  /// Finds the points where the body of a slot meets the sides that it doesn't pass.
  void detect(std::size_t slot, btRigidBody& body, RoomSides passes, const btDispatcherInfo& info);
  /// Forgets what the body that was in the slot met.
  void forget(std::size_t slot);

 private:
  struct Side {
    RoomSide plane;
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btBroadphaseProxy> proxy;  // by which Bullet orders contacts
    std::unique_ptr<btRigidBody> body;
  };
  void free(btCollisionAlgorithm* algorithm);

  btCollisionDispatcher& dispatcher_;
  std::vector<Side> sides_;
  std::map<std::pair<std::size_t, std::size_t>, btCollisionAlgorithm*> near_;  // by slot and side
};

}  // namespace prosector
