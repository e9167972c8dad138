#pragma once
// Messages that describe the scene: bodies, lights, camera, patient, and assets in chunks. SI units; colours
// are linear RGB in [0, 1].

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/appearance.h"
#include "common/fidelity.h"
#include "common/hash.h"
#include "common/local_name.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::size_t max_local_names = 16;  // of one body
inline constexpr std::size_t max_term_length = 31;  // bytes: an entry of Terminologia Anatomica
inline constexpr std::size_t max_bodies = 4096;

enum class BodyKind : std::uint8_t { rigid, soft };

struct SceneBody {
  std::string name;
  std::string description;
  BodyKind kind = BodyKind::rigid;
  std::int32_t parent = -1;  // parent body in the scene graph; −1: the room
  bool moves = false;        // false: never sent as RigidState
  Pose pose;                 // at scene start (rigid) / frame of the quantisation (soft)
  ContentHash mesh{};  // Asset: triangle surface, in the body's frame (rigid) or the room's rest shape (soft)
  ContentHash map{};   // Asset; soft: StreamedSurface (common/asset.h), rigid: end points of cutting edges
  std::uint32_t points = 0;        // soft only: number of streamed points
  std::uint32_t chunk_points = 0;  // soft only: points per SoftState chunk (the last may hold fewer)
  double tube_diameter = 0;  // m: of a soft body without triangles, whose vertices in order are a tube's axis
  Appearance appearance;
  std::string method;         // soft only, text for users: the simulation method, and why the server chose it
  bool show_figures = false;  // soft only: display its BodyStatus above it
  bool part = false;          // anatomical part: a touch opens its panel
  Fidelity fidelity = Fidelity::mesh;  // collision shape
  ContentHash outline{};  // Asset: collision shape in the frame of `mesh`; zero: none, or `mesh` itself
  std::vector<LocalName> names;  // `name` in other languages, each language once
  std::string term;              // entry of Terminologia Anatomica (1998): "A05.8.01.001"; empty: none
};

/// Message from the server to all clients: the scene graph, that is, the bodies, lights, camera and patient.
/// Reliable, transient-local. Meshes are sent separately as Assets.
struct SceneInfo {
  std::string name;
  std::string description;
  std::vector<SceneBody> bodies;
  std::vector<LightInfo> lights;
  CameraInfo camera;
  std::optional<PatientFrame> patient;  // nullopt: the scene has no patient
};

inline constexpr std::size_t asset_chunk_bytes = 256 * 1024;
inline constexpr std::size_t max_asset_bytes = 256u * 1024 * 1024;

/// Message from the server to all clients: one chunk of an asset (a mesh or an embedding). Reliable,
/// transient-local, keyed by (hash, chunk). Clients receive all meshes this way and need no files.
struct AssetChunk {
  ContentHash hash{};
  std::uint32_t chunk = 0;
  std::uint32_t chunks = 0;
  std::uint32_t total_bytes = 0;
  std::vector<std::uint8_t> bytes;  // asset_chunk_bytes each, the last one shorter
};

}  // namespace prosector
