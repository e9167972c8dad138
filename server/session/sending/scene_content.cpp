#include "server/session/sending/scene_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

#include "common/fidelity.h"
#include "common/server_run.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/session/sending/collision_model.h"

namespace prosector {
namespace {

std::int32_t find_body(const Simulation& simulation, const std::string& name) {
  for (BodyId b = 0; b < simulation.body_count(); ++b)
    if (!name.empty() && simulation.name(b) == name) return static_cast<std::int32_t>(b);
  return -1;
}

template <class Desc>
SceneBody describe(const Simulation& simulation, const Desc& desc, BodyKind kind) {
  SceneBody body;
  body.name = desc.name;
  body.description = desc.description;
  body.kind = kind;
  body.parent = find_body(simulation, desc.parent);
  body.pose = kind == BodyKind::rigid ? desc.pose : Pose{};
  body.appearance = desc.appearance;
  body.part = desc.part;
  body.fidelity = desc.contact.collision;
  body.names = desc.names;
  body.term = desc.term;
  return body;
}

/// Returns the end points of the body's cutting edges, in pairs, without triangles. Beams have no edge.
TriangleMesh ends_of_edges(const RigidDesc& desc) {
  TriangleMesh out;
  for (const EdgeDesc& edge : desc.edges)
    if (!edge.ray) out.positions.insert(out.positions.end(), {edge.from, edge.to});
  return out;
}

}  // namespace

SessionInfo describe_session(const Simulation& simulation, const std::string& session, std::uint32_t reign) {
  SessionInfo info;
  info.session = session;
  info.scene = simulation.scene().name;
  info.scene_hash = simulation.content_hash();
  info.tick_rate = simulation.scene().tick_rate;
  info.capacity = static_cast<std::uint32_t>(simulation.scene().session.capacity);
  info.server_run = make_server_run(reign);
  return info;
}

std::string beginning(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xc0) == 0x80) --bytes;
  return text.substr(0, bytes);
}

std::string free_name(const SceneInfo& scene, const std::string& wanted) {
  const auto taken = [&](const std::string& name) {
    return std::ranges::any_of(scene.bodies, [&](const SceneBody& body) { return body.name == name; });
  };
  std::string name = wanted;
  for (int piece = 1; taken(name); ++piece) {
    const std::string suffix = fmt::format(" piece {}", piece);
    name = beginning(wanted, max_name_length - suffix.size()) + suffix;
  }
  return name;
}

void name_piece(SceneBody& piece, const SceneInfo& scene) {
  const std::string whole = std::exchange(piece.name, free_name(scene, piece.name));
  if (piece.name == whole) return;
  const std::string number = piece.name.substr(piece.name.rfind(' '));
  for (LocalName& local : piece.names)
    local.name = beginning(local.name, max_name_length - number.size()) + number;
}

SceneBody describe_soft(const Simulation& simulation, BodyId body, const SurfaceLog& log) {
  const SoftDesc& desc = simulation.soft(body).desc();
  SceneBody out = describe(simulation, desc, BodyKind::soft);
  out.moves = true;
  out.method = soft::in_words(desc);
  out.show_figures = desc.show_figures;
  out.points = log.stream()->points;
  out.chunk_points = log.stream()->chunk_points;
  out.tube_diameter = tube_diameter(simulation.soft(body).anatomy());
  return out;
}

SceneContent make_scene_content(const Simulation& simulation, const std::vector<Choice>& choices) {
  const SceneDesc& desc = simulation.scene();
  SceneContent out;
  out.scene.name = desc.name;
  out.scene.description = desc.description;
  out.scene.camera = desc.camera;
  out.scene.patient = desc.patient;
  for (const LightDesc& light : desc.lights)
    out.scene.lights.emplace_back(light).body = find_body(simulation, light.carrier);

  std::set<ContentHash> known;
  const auto keep = [&](Asset asset) {
    const ContentHash hash = asset.hash;
    if (known.insert(hash).second) out.assets.push_back(std::move(asset));
    return hash;
  };
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    out.triangles += simulation.surface(b).triangles.size();
    if (simulation.kind(b) == BodyKind::rigid) {
      SceneBody body = describe(simulation, desc.rigid[b], BodyKind::rigid);
      body.moves = !desc.rigid[b].fixed;
      body.mesh = keep(encode(simulation.surface(b)));
      if (const TriangleMesh ends = ends_of_edges(desc.rigid[b]); !ends.positions.empty())
        body.map = keep(encode(ends));
      if (const auto outline = collision_outline(desc.rigid[b], simulation.surface(b)))
        body.outline = keep(encode(*outline));
      out.scene.bodies.push_back(std::move(body));
      continue;
    }
    const soft::SoftBody& soft = simulation.soft(b);
    const TopologyChange begin{.body = b,
                               .revision = simulation.revision(b),
                               .content_hash = simulation.topology_hash(b),
                               .cause = TopologyCause::compiled,
                               .author = 0,
                               .piece_of = {}};
    const SurfaceLog& log =
        out.surfaces
            .try_emplace(
                b, soft.anatomy(), simulation.numbering(b), begin, simulation.time(),
                soft.desc().refinement.at == SoftDesc().refinement.at ? Streamed::fewest : Streamed::vertices)
            .first->second;
    SceneBody body = describe_soft(simulation, b, log);
    for (const Choice& c : choices)
      if (c.body == body.name) body.method = explain(c, soft.desc());
    if (b >= desc.rigid.size() + desc.soft.size()) name_piece(body, out.scene);
    TopologyRevision first = log.newest();
    auto [mesh, map] = log.keyframe();
    first.mesh = body.mesh = keep(std::move(mesh));
    first.map = body.map = keep(std::move(map));
    out.topology.push_back(std::move(first));
    out.scene.bodies.push_back(std::move(body));
  }
  return out;
}

std::vector<AssetChunk> chunks_of(const Asset& asset) {
  std::vector<AssetChunk> out;
  const std::size_t count = (asset.bytes.size() + asset_chunk_bytes - 1) / asset_chunk_bytes;
  for (std::size_t c = 0; c < count; ++c) {
    const auto begin = asset.bytes.begin() + static_cast<std::ptrdiff_t>(c * asset_chunk_bytes);
    const auto end = asset.bytes.begin() +
                     static_cast<std::ptrdiff_t>(std::min((c + 1) * asset_chunk_bytes, asset.bytes.size()));
    out.push_back({asset.hash,
                   static_cast<std::uint32_t>(c),
                   static_cast<std::uint32_t>(count),
                   static_cast<std::uint32_t>(asset.bytes.size()),
                   {begin, end}});
  }
  return out;
}

}  // namespace prosector
