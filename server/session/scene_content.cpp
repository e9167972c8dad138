#include "server/session/scene_content.h"

#include <algorithm>
#include <random>
#include <set>

#include "server/physics/collision/fidelity.h"
#include "server/physics/soft/rungs.h"
#include "server/physics/soft/soft_body.h"
#include "server/session/collision_model.h"

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
  body.fidelity = fidelity_of(desc.collision);
  return body;
}

TopologyRevision first_revision(BodyId body, std::uint64_t content_hash) {
  TopologyRevision out;
  out.body = body;
  out.content_hash = content_hash;
  StateHasher chain;
  chain.add(out.previous_hash);
  chain.add(out.content_hash);
  out.chain_hash = chain.digest();
  return out;
}

}  // namespace

SceneContent make_scene_content(const Simulation& simulation, const std::vector<Choice>& choices) {
  const SceneDesc& desc = simulation.scene();
  SceneContent out;
  out.scene.name = desc.name;
  out.scene.description = desc.description;
  out.scene.camera = desc.camera;
  for (const LightDesc& light : desc.lights)
    out.scene.lights.emplace_back(light).body = find_body(simulation, light.carrier);

  std::set<ContentHash> known;
  const auto keep = [&](Asset asset) {
    const ContentHash hash = asset.hash;
    if (known.insert(hash).second) out.assets.push_back(std::move(asset));
    return hash;
  };
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    const bool rigid = simulation.kind(b) == BodyKind::rigid;
    SceneBody body = rigid ? describe(simulation, desc.rigid[b], BodyKind::rigid)
                           : describe(simulation, desc.soft[b - desc.rigid.size()], BodyKind::soft);
    body.moves = !rigid || !desc.rigid[b].fixed;
    body.mesh = keep(encode(simulation.surface(b)));
    if (rigid)
      if (const auto outline = collision_outline(desc.rigid[b], simulation.surface(b)))
        body.outline = keep(encode(*outline));
    out.triangles += simulation.surface(b).triangles.size();
    if (!rigid) {
      const SoftDesc& description = desc.soft[b - desc.rigid.size()];
      body.method = in_words(description);
      for (const Choice& c : choices)
        if (c.body == description.name) body.method = explain(c, description);
      body.show_figures = description.show_figures;
      const SoftBody& soft = simulation.soft(b);
      SurfaceStream stream =
          make_surface_stream(soft.anatomy(), static_cast<std::uint32_t>(soft_chunk_points));
      body.map = keep(encode(stream.surface));
      body.points = stream.points;
      body.chunk_points = stream.chunk_points;
      body.tube_diameter = tube_diameter(soft.anatomy());
      out.streams.emplace(b, std::move(stream));
      out.topology.push_back(first_revision(b, soft.content_hash()));
    }
    out.scene.bodies.push_back(std::move(body));
  }
  return out;
}

std::size_t SceneContent::asset_bytes() const {
  std::size_t sum = 0;
  for (const Asset& a : assets) sum += a.bytes.size();
  return sum;
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

std::uint64_t random_server_run() {
  std::random_device entropy;
  return (std::uint64_t{entropy()} << 32 | entropy()) | 1;
}

}  // namespace prosector
