#pragma once
// Plays back a recorded session: runs its ticks again and publishes them as those of a live session, with the
// recorded participants. Viewers join as observers. They control time: the pace, single steps, and jumps to
// any tick.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/session/recording/displayed_time.h"
#include "server/session/recording/published_topology.h"
#include "server/session/recording/recorded_people.h"
#include "server/session/recording/recording_index.h"
#include "server/session/recording/recording_player.h"
#include "server/session/run/body_reports.h"
#include "server/session/run/step_meter.h"
#include "server/session/sending/snapshot_feed.h"

namespace prosector {

class Playback {
 public:
  /// Journal to play, and the simulation that was compiled from its scene.
  struct Source {
    const JournalReader& journal;
    Simulation& simulation;  // at the journal's beginning
  };
  /// Reads the whole journal, and announces the session on the bus. All arguments must outlive the playback.
  /// `say` is called with lines of text for the console. Throws InputError if the journal is damaged or of
  /// another scene or build.
  Playback(const Source& source, Bus& bus, const std::string& session,
           std::function<void(const std::string&)> say);

  /// Processes received messages, and runs one tick, or several ticks during a jump to another time. Playback
  /// starts when the first viewer joins, and stops at the end.
  void turn();
  /// Runs turns at the pace that viewers set until `stop` is true, or for `seconds` of wall time if above 0.
  /// `each_second` is called once a second with a line for the console.
  void run(const std::atomic<bool>& stop, double seconds,
           const std::function<void(const std::string&)>& each_second);

  std::string console_line() const;
  std::uint64_t server_run() const { return feed_.publisher().info().server_run; }
  const Session& session() const { return session_; }
  const RecordingPlayer& player() const { return player_; }
  Publisher& publisher() { return feed_.publisher(); }

 private:
  struct Seek {  // a jump to another tick that is not complete yet
    std::uint64_t tick = 0;
    std::int64_t begun_ns = 0;
  };
  Simulation& simulation_;
  Bus& bus_;
  std::function<void(const std::string&)> say_;
  RecordingPlayer player_;
  RecordingIndex index_;
  std::shared_ptr<const SceneContent> content_;
  PublishedTopology topology_;
  Session session_;
  StepMeter meter_;
  BodyReports bodies_;
  RecordedPeople people_;
  DisplayedTime shown_;
  std::optional<Seek> seek_;
  std::uint64_t turns_ = 0;
  bool begun_ = false, reported_difference_ = false;
  std::vector<Received> received_;
  std::int64_t offered_ns_ = 0;  // time of the last snapshot
  SnapshotFeed feed_;

  bool hear();
  void begin_with_the_first();
  void take_wishes();
  std::vector<Outgoing> play_tick();
  std::vector<Outgoing> go_on_the_way();
  std::vector<Outgoing> arrive();
  bool stand_at_the_end();
  void offer_snapshot(bool news);
  std::shared_ptr<Snapshot> reported_snapshot() const;
  SimTime displayed_time() const { return shown_.of(simulation_.time()); }
  ServerStatus status() const;
};

}  // namespace prosector
