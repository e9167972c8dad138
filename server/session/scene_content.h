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
#include "server/session/surface_log.h"

namespace prosector {

struct SceneContent {
  SceneInfo scene;
  std::vector<Asset> assets;               // each content once
  std::map<BodyId, SurfaceLog> surfaces;   // of every soft body
  std::vector<TopologyRevision> topology;  // the first revision of every soft body
  std::size_t triangles = 0;
};

/// Returns what clients are told of a session that runs on the simulation from now on; `reign`: of
/// common/server_run.h.
SessionInfo describe_session(const Simulation& simulation, const std::string& session, std::uint32_t reign);

/// Makes what clients are told of the scene. `choices`: of bodies that were chosen by need.
SceneContent make_scene_content(const Simulation& simulation, const std::vector<Choice>& choices = {});

/// Describes a soft body as clients are told of it, its surface as `log` has it; without meshes' names and
/// method.
SceneBody describe_soft(const Simulation& simulation, BodyId body, const SurfaceLog& log);

/// Returns a name for a piece: the organ's, with a number where it is taken.
std::string free_name(const SceneInfo& scene, const std::string& wanted);
/// Gives a piece that was cut off names that no body has: in each language the number that `free_name` finds
/// stands behind it.
void name_piece(SceneBody& piece, const SceneInfo& scene);

/// Returns the longest beginning of at most `bytes` bytes that is whole UTF-8.
std::string beginning(const std::string& text, std::size_t bytes);

/// Returns the asset in pieces that the network carries.
std::vector<AssetChunk> chunks_of(const Asset& asset);

}  // namespace prosector
