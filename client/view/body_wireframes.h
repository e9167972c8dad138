#pragma once
// Wireframes of the bodies of a session.

#include <cstdint>
#include <map>

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/wireframe.h"
#include "common/ids.h"

namespace prosector {

/// Wireframes of the bodies' collision shapes, with the edges of each shape cached until the shape changes.
class BodyWireframes {
 public:
  /// Adds the wireframes of all bodies at the replica's `tick` to the list, except of parts that take no part
  /// in contact.
  void add(DrawList& list, Replica& replica, double tick);

 private:
  std::map<BodyId, Edges> edges_;
  std::map<BodyId, std::uint64_t> shapes_;  // SoftReplica::shape() for which edges_ was built

  void add_soft(DrawList& list, const SoftReplica& soft, BodyId body);
  void add_rigid(DrawList& list, const TriangleMesh& outline, BodyId body, const Pose& pose);
};

}  // namespace prosector
