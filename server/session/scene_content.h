#pragma once
// What a client needs to show the scene, made once from the compiled simulation: the scene graph, the meshes
// as assets, and how each deformable streams.

#include <map>
#include <string>
#include <vector>

#include "common/asset.h"
#include "common/messages.h"
#include "server/calibration/choose_rung.h"
#include "server/physics/simulation.h"
#include "server/session/surface_stream.h"

namespace prosector {

struct SceneContent {
  SceneInfo scene;
  std::vector<Asset> assets;                // each content once
  std::map<BodyId, SurfaceStream> streams;  // of every soft body
  std::vector<TopologyRevision> topology;   // revision 0 of every soft body
  std::size_t triangles = 0;

  std::size_t asset_bytes() const;
};

/// `choices`: of bodies that were chosen by need.
SceneContent make_scene_content(const Simulation& simulation, const std::vector<Choice>& choices = {});

/// The asset in pieces that the network carries.
std::vector<AssetChunk> chunks_of(const Asset& asset);

/// A fresh number for SessionInfo::server_run.
std::uint64_t random_server_run();

}  // namespace prosector
