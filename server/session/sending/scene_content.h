#pragma once
// Data that a client needs to show the scene, made once from the compiled simulation: the scene graph, the
// meshes as assets, and how each deformable is streamed.

#include <map>
#include <string>
#include <vector>

#include "common/asset.h"
#include "common/body_messages.h"
#include "common/ids.h"
#include "common/scene_messages.h"
#include "common/session_messages.h"
#include "server/calibration/choose_rung.h"
#include "server/physics/simulation.h"
#include "server/session/sending/surface_log.h"

namespace prosector {

struct SceneContent {
  SceneInfo scene;
  std::vector<Asset> assets;               // without duplicates
  std::map<BodyId, SurfaceLog> surfaces;   // of every soft body
  std::vector<TopologyRevision> topology;  // the first revision of every soft body
  std::size_t triangles = 0;
};

/// Returns the announcement of a session that runs on the simulation from now on. `reign` is the number of
/// starts and resumes of the session: see common/server_run.h.
SessionInfo describe_session(const Simulation& simulation, const std::string& session, std::uint32_t reign);

/// Makes the data that clients need to show the scene: scene graph, meshes, and streamed surfaces. `choices`
/// are the model configurations of bodies for which they were chosen by accuracy or budget.
SceneContent make_scene_content(const Simulation& simulation, const std::vector<Choice>& choices = {});

/// Returns the description of a soft body for clients, with its surface from `log`. The hashes of its meshes
/// are not set.
SceneBody describe_soft(const Simulation& simulation, BodyId body, const SurfaceLog& log);

/// Returns a name that no body of the scene has, for a piece that was cut off: `wanted`, or `wanted` with a
/// number if that name is taken.
std::string free_name(const SceneInfo& scene, const std::string& wanted);
/// Gives a piece that was cut off names that no other body of the scene has. In each language, the number
/// that `free_name` finds is appended.
void name_piece(SceneBody& piece, const SceneInfo& scene);

/// Returns the longest prefix of `text` of at most `bytes` bytes that does not end within a UTF-8 character.
std::string beginning(const std::string& text, std::size_t bytes);

/// Returns the asset divided into chunks, each of which fits into a message.
std::vector<AssetChunk> chunks_of(const Asset& asset);

}  // namespace prosector
