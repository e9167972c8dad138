#include "client/replica/body_replicas.h"

#include <span>
#include <utility>

#include "common/assert.h"
#include "common/asset.h"
#include "common/error.h"
#include "common/hash.h"

namespace prosector {
namespace {

constexpr std::size_t max_early_chunks = 4096;  // soft-body samples stored until their body is known

/// Returns cutting edges from a mesh whose vertices are their end points, in pairs. Throws InputError if the
/// asset is invalid.
std::vector<CuttingEdge> decode_edges(std::span<const std::uint8_t> bytes) {
  const TriangleMesh ends = decode_triangle_mesh(bytes);
  if (ends.positions.size() % 2 != 0)
    throw InputError("asset of the server is invalid: a cutting edge has no second end point");
  std::vector<CuttingEdge> out;
  for (std::size_t k = 0; k < ends.positions.size(); k += 2)
    out.push_back({ends.positions[k], ends.positions[k + 1]});
  return out;
}

}  // namespace

void BodyReplicas::add(const SoftState& state) {
  SoftReplica* known = soft(state.body);
  if (known != nullptr && known->add(state)) return;
  if (pending_soft_.size() < max_early_chunks) pending_soft_.push_back(state);
}

void BodyReplicas::add(const Settled& settled) {
  settled_[settled.body] = settled;
  if (SoftReplica* known = soft(settled.body)) known->add(settled);
}

void BodyReplicas::build(const SceneInfo& scene, const AssetStore& assets, std::int64_t now_ns) {
  for (BodyId id = 0; id < scene.bodies.size(); ++id) {
    try {
      build(id, scene.bodies[id], assets, now_ns);
    } catch (const InputError&) {
      ++refused_;
    }
  }
}

void BodyReplicas::build(BodyId id, const SceneBody& body, const AssetStore& assets, std::int64_t now_ns) {
  const auto mesh = assets.find(body.mesh);
  if (!mesh) return;
  const auto map_bytes = assets.find(body.map);
  if (body.kind == BodyKind::rigid) {
    const bool has_edges = body.map != ContentHash{};
    RigidReplica& rigid = rigid_[id];
    if (!rigid.mesh.positions.empty() || (has_edges && !map_bytes)) return;
    rigid.mesh = decode_triangle_mesh(*mesh);
    rigid.scene_pose = body.pose;
    if (has_edges) rigid.edges = decode_edges(*map_bytes);
    return;
  }
  if (!map_bytes || soft_.contains(id) || body.points == 0 || body.chunk_points == 0) return;
  TriangleMesh rest = decode_triangle_mesh(*mesh);
  StreamedSurface streamed = decode_streamed_surface(*map_bytes);
  if (streamed.map.rows.size() != rest.positions.size())
    throw InputError(
        "asset of the server is invalid: the embedding map does not have one row for each surface vertex");
  if (streamed.rest.size() != body.points)
    throw InputError(
        "asset of the server is invalid: the number of rest positions differs from the number of streamed "
        "points");
  soft_.emplace(id, SoftReplica(body, std::move(rest), std::move(streamed)));
  apply_pending(id);
  follow_topology(id, assets, now_ns);
}

void BodyReplicas::follow_topology(const AssetStore& assets, std::int64_t now_ns) {
  for (const auto& [body, soft] : soft_) follow_topology(body, assets, now_ns);
}

void BodyReplicas::follow_topology(BodyId body, const AssetStore& assets, std::int64_t now_ns) {
  const auto topology = topology_.find(body);
  if (topology == topology_.end()) return;
  if (topology->second.advance(assets, soft_.at(body), now_ns)) apply_pending(body);
}

/// Applies samples that arrived before the body's assets or topology.
void BodyReplicas::apply_pending(BodyId body) {
  PROSECTOR_ASSERT(soft_.contains(body));
  SoftReplica& soft = soft_.at(body);
  if (const auto settled = settled_.find(body); settled != settled_.end()) soft.add(settled->second);
  std::erase_if(pending_soft_, [&](const SoftState& chunk) { return chunk.body == body && soft.add(chunk); });
}

std::vector<BodyId> BodyReplicas::take_keyframe_requests(std::int64_t now_ns) {
  std::vector<BodyId> out;
  for (auto& [body, topology] : topology_)
    if (topology.needs_keyframe(now_ns)) out.push_back(body);
  return out;
}

const TopologyRevision* BodyReplicas::topology(BodyId body) const {
  const auto found = topology_.find(body);
  return found == topology_.end() ? nullptr : found->second.shown();
}

std::uint64_t BodyReplicas::topology_hash() const {
  StateHasher hasher;
  for (const auto& [body, topology] : topology_) {
    if (topology.shown() == nullptr) continue;
    hasher.add(body);
    hasher.add(topology.shown()->chain_hash);
  }
  return hasher.digest();
}

const TriangleMesh* BodyReplicas::outline(BodyId body, const SceneBody& described, const AssetStore& assets) {
  if (const auto it = outlines_.find(body); it != outlines_.end()) return &it->second;
  const bool has_own = described.outline != ContentHash{};
  if (!has_own && described.fidelity == Fidelity::none) return nullptr;
  const auto bytes = assets.find(has_own ? described.outline : described.mesh);
  if (!bytes) return nullptr;
  try {
    return &outlines_.emplace(body, decode_triangle_mesh(*bytes)).first->second;
  } catch (const InputError&) {
    ++refused_;
    return &outlines_[body];  // an empty mesh, so that decoding is not repeated
  }
}

const RigidReplica* BodyReplicas::rigid(BodyId body) const {
  const auto it = rigid_.find(body);
  return it == rigid_.end() ? nullptr : &it->second;
}

SoftReplica* BodyReplicas::soft(BodyId body) {
  const auto it = soft_.find(body);
  return it == soft_.end() ? nullptr : &it->second;
}

const SoftReplica* BodyReplicas::soft(BodyId body) const {
  const auto it = soft_.find(body);
  return it == soft_.end() ? nullptr : &it->second;
}

std::uint64_t BodyReplicas::refused() const {
  std::uint64_t out = refused_;
  for (const auto& [body, topology] : topology_) out += topology.refused();
  return out;
}

}  // namespace prosector
