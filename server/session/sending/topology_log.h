#pragma once
// The scene's changes by cuts, as sent to clients: revisions of each soft body, keyframes for clients that
// join late or can't follow, and pieces as bodies of the scene.

#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "server/physics/simulation.h"
#include "server/session/people/session.h"
#include "server/session/sending/scene_content.h"
#include "server/session/sending/surface_log.h"

namespace prosector {

// A late joiner receives a keyframe and at most this many revisions after it; older ones are not stored.
inline constexpr std::uint32_t keyframe_revisions = 16;
inline constexpr double keyframe_interval = 1;  // s: least time between two requested keyframes of a body

/// Interface through which the topology log reads the current shapes of soft bodies.
class SoftShapes {
 public:
  struct Shape {
    const Anatomy& anatomy;
    const Numbering& numbering;
    const VecX& x;  // of the nodes, m
  };
  virtual ~SoftShapes() = default;
  virtual Shape shape(BodyId body) const = 0;
  /// Returns the description for clients of a piece that was cut off, whose surface is `surface`.
  virtual SceneBody describe(BodyId body, const SurfaceLog& surface) const = 0;
};

class TopologyLog {
 public:
  /// Starts with the scene content that was announced to clients. `tick_rate` is in 1/s.
  TopologyLog(const SceneContent& content, double tick_rate);

  /// Processes the topology changes of a step that ended at `time`. Appends the messages for clients to
  /// `out`, in order. `roster` provides the names of the authors of cuts.
  void follow(const SoftShapes& shapes, std::span<const TopologyChange> changes, SimTime time,
              const Roster& roster, std::vector<Outgoing>& out);
  /// Requests a keyframe (the complete surface) of the body, because a client's copy of the body does not
  /// match.
  void ask_keyframe(BodyId body);
  /// Appends the requested keyframes (complete surfaces) to `out`. A body's keyframe waits until
  /// keyframe_interval has passed since its last one.
  void send_keyframes(SimTime now, std::vector<Outgoing>& out);

  /// Returns the topology revisions that follow() created since the last call, for the journal. They have no
  /// patches (differences of the surface).
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
    std::uint32_t first_kept = 0;       // first stored revision; earlier ones were disposed of
    std::vector<KeptAsset> keyframe{};  // assets of the newest keyframe that isn't the scene's
    std::uint64_t keyframe_tick = 0;    // tick of the last requested one
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
