#pragma once
// A client's copy of a rigid body.

#include <vector>

#include "client/replica/track.h"
#include "common/body_messages.h"
#include "common/math.h"
#include "common/mesh.h"

namespace prosector {

/// Straight cutting edge of an instrument: its end points in the body frame, m.
struct CuttingEdge {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

struct RigidReplica {
  TriangleMesh mesh;
  std::vector<CuttingEdge> edges;  // cut tissue while a hand holds the body
  Pose scene_pose;                 // pose until the first RigidState
  Track<RigidState> track;
};

}  // namespace prosector
