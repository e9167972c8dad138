#pragma once
// What cuts make of the scene, as clients are told. There are revisions of each soft body, keyframes for
// those who come late or lost their way, and pieces as bodies of the scene.

#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "server/physics/simulation.h"
#include "server/session/scene_content.h"
#include "server/session/session.h"
#include "server/session/surface_log.h"

namespace prosector {

// A late joiner takes a keyframe and at most this many revisions after it; older ones are no longer kept.
inline constexpr std::uint32_t keyframe_revisions = 16;
inline constexpr double keyframe_interval = 1;  // s, at least, between two of a body that clients ask for

/// Where the log looks up what soft bodies have become.
class SoftShapes {
 public:
  struct Shape {
    const Anatomy& anatomy;
    const Numbering& numbering;
    const VecX& x;  // of the nodes, m
  };
  virtual ~SoftShapes() = default;
  virtual Shape shape(BodyId body) const = 0;
  /// Describes a piece, as clients are told of it.
  virtual SceneBody describe(BodyId body, const SurfaceLog& surface) const = 0;
};

class TopologyLog {
 public:
  /// Takes the content that was announced.
  TopologyLog(const SceneContent& content, double tick_rate);

  /// Follows what a step did that ended at `time`; appends what has to be said of it, in order.
  void follow(const SoftShapes& shapes, std::span<const TopologyChange> changes, SimTime time,
              const Roster& roster, std::vector<Outgoing>& out);
  /// Notes that somebody's copy of the body doesn't fit.
  void ask_keyframe(BodyId body);
  /// Appends the keyframes that were asked for and are due.
  void send_keyframes(SimTime now, std::vector<Outgoing>& out);

  /// Returns the revisions that follow() made since the last call, without patches: what the journal keeps.
  std::vector<TopologyRevision> take_records();

  bool knows(BodyId body) const { return bodies_.contains(body); }
  std::uint32_t revision(BodyId body) const { return at(body).surface.newest().revision; }
  std::shared_ptr<const SurfaceStream> stream(BodyId body) const { return at(body).surface.stream(); }
  const SceneInfo& scene() const { return scene_; }

 private:
  struct KeptAsset {
    ContentHash hash{};
    std::size_t bytes = 0;
  };
  struct Body {
    SurfaceLog surface;
    std::uint32_t first_kept = 0;       // revision; those before were disposed of
    std::vector<KeptAsset> keyframe{};  // of the newest keyframe that isn't the scene's
    std::uint64_t keyframe_tick = 0;    // of the last one that was asked for
  };
  double tick_rate_;
  SceneInfo scene_;
  std::set<ContentHash> scene_assets_;
  std::map<BodyId, Body> bodies_;
  std::set<BodyId> asked_;
  std::vector<TopologyRevision> records_;

  const Body& at(BodyId body) const { return bodies_.at(body); }
  void add_piece(const SoftShapes& shapes, const TopologyChange& change, SimTime time, const Roster& roster,
                 std::vector<Outgoing>& out);
  void send_keyframe(Body& body, std::vector<Outgoing>& out);
  bool in_use(const ContentHash& asset) const;
};

}  // namespace prosector
