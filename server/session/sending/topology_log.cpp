#include "server/session/sending/topology_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/assert.h"

namespace prosector {
namespace {

void send(const Asset& asset, std::vector<Outgoing>& out) {
  for (AssetChunk& chunk : chunks_of(asset)) out.push_back({std::move(chunk)});
}

std::string description_of_piece(const SceneBody& whole, ParticipantId author, const Roster& roster) {
  std::string out = fmt::format("Cut off {}", whole.name);
  if (const auto member = roster.members().find(author); member != roster.members().end())
    out += fmt::format(" by {}", member->second.presence.name);
  return whole.description.empty() ? out : beginning(out + "\n" + whole.description, max_text_length);
}

}  // namespace

TopologyLog::TopologyLog(const SceneContent& content, double tick_rate)
    : tick_rate_(tick_rate), scene_(content.scene) {
  for (const SceneBody& body : scene_.bodies) scene_assets_.insert({body.mesh, body.map, body.outline});
  for (const auto& [body, surface] : content.surfaces)
    bodies_.try_emplace(body, Body{surface, surface.newest().revision});
}

void TopologyLog::follow(const SoftShapes& shapes, std::span<const TopologyChange> changes, SimTime time,
                         const Roster& roster, std::vector<Outgoing>& out) {
  for (const TopologyChange& change : changes) {
    const auto known = bodies_.find(change.body);
    if (known == bodies_.end()) {
      add_piece(shapes, change, time, roster, out);
      continue;
    }
    Body& body = known->second;
    const SoftShapes::Shape now = shapes.shape(change.body);
    PROSECTOR_ASSERT(change.revision > body.surface.newest().revision);
    body.surface.follow(now.anatomy, now.numbering, now.x, change, time);
    if (change.revision % keyframe_revisions == 0)
      send_keyframe(body, out);
    else
      out.push_back({body.surface.newest()});
    records_.push_back(body.surface.newest());
    records_.back().patch = {};
  }
}

/// Adds a piece. Its meshes and its first revision are sent before the scene that names it.
void TopologyLog::add_piece(const SoftShapes& shapes, const TopologyChange& change, SimTime time,
                            const Roster& roster, std::vector<Outgoing>& out) {
  PROSECTOR_ASSERT(change.body == scene_.bodies.size());
  const SoftShapes::Shape now = shapes.shape(change.body);
  Body& body = bodies_
                   .try_emplace(change.body,
                                Body{SurfaceLog(now.anatomy, now.numbering, change, time), change.revision})
                   .first->second;
  SceneBody described = shapes.describe(change.body, body.surface);
  name_piece(described, scene_);
  if (change.piece_of)
    described.description = description_of_piece(scene_.bodies.at(*change.piece_of), change.author, roster);
  const auto [mesh, map] = body.surface.keyframe();
  TopologyRevision first = body.surface.newest();
  first.mesh = described.mesh = mesh.hash;
  first.map = described.map = map.hash;
  scene_assets_.insert({mesh.hash, map.hash});
  send(mesh, out);
  send(map, out);
  records_.push_back(first);
  out.push_back({std::move(first)});
  scene_.bodies.push_back(std::move(described));
  out.push_back({scene_});
}

void TopologyLog::ask_keyframe(BodyId body) {
  if (bodies_.contains(body)) asked_.insert(body);
}

void TopologyLog::send_keyframes(SimTime now, std::vector<Outgoing>& out) {
  std::erase_if(asked_, [&](BodyId id) {
    Body& body = bodies_.at(id);
    const double since = static_cast<double>(now.tick - body.keyframe_tick) / tick_rate_;
    if (body.keyframe_tick > 0 && since < keyframe_interval) return false;  // too early: it stays requested
    body.keyframe_tick = now.tick;
    send_keyframe(body, out);
    return true;
  });
}

/// Sends the newest revision as a keyframe, which clients can use without earlier revisions. These and the
/// last keyframe are disposed of.
void TopologyLog::send_keyframe(Body& body, std::vector<Outgoing>& out) {
  TopologyRevision revision = body.surface.newest();
  PROSECTOR_ASSERT(body.first_kept <= revision.revision);
  const auto assets = body.surface.keyframe();
  revision.mesh = assets[0].hash;
  revision.map = assets[1].hash;
  const std::vector<KeptAsset> before = std::exchange(body.keyframe, {});
  for (const Asset& asset : assets) {
    send(asset, out);
    body.keyframe.push_back({asset.hash, asset.bytes.size()});
  }
  for (; body.first_kept < revision.revision; ++body.first_kept) {
    TopologyRevision old;
    old.body = revision.body;
    old.revision = body.first_kept;
    out.push_back({std::move(old), true});
  }
  out.push_back({std::move(revision)});
  for (const KeptAsset& asset : before)
    if (!in_use(asset.hash))
      for (AssetChunk& chunk : chunks_of({asset.hash, std::vector<std::uint8_t>(asset.bytes)}))
        out.push_back({std::move(chunk), true});
}

bool TopologyLog::in_use(const ContentHash& asset) const {
  return scene_assets_.contains(asset) || std::ranges::any_of(bodies_, [&](const auto& entry) {
           return std::ranges::any_of(entry.second.keyframe,
                                      [&](const KeptAsset& kept) { return kept.hash == asset; });
         });
}

std::vector<TopologyRevision> TopologyLog::take_records() {
  return std::exchange(records_, {});
}

}  // namespace prosector
