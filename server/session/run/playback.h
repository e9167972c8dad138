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

#include "server/session/recording/published_topology.h"
#include "server/session/recording/recording_index.h"
#include "server/session/recording/recording_player.h"
#include "server/session/run/body_meter.h"
#include "server/session/run/step_meter.h"
#include "server/session/sending/part_sender.h"
#include "server/session/sending/publisher.h"

namespace prosector {

class Playback {
 public:
  /// The journal to play, and the simulation that was compiled from it.
  struct Source {
    const JournalReader& journal;
    Simulation& simulation;  // at the journal's beginning
  };
  /// Reads the whole journal, and announces the session on the bus. All arguments outlive the playback. `say`
  /// gets lines of text. Throws InputError when the journal is damaged or of another scene or build.
  Playback(const Source& source, Bus& bus, const std::string& session,
           std::function<void(const std::string&)> say);

  /// Processes received messages, and runs a tick, or some ticks of a seek. Time starts when the first viewer
  /// joins, and stops at the end.
  void turn();
  /// Runs turns at the pace that viewers set until `stop`, or for `seconds` of wall time when above 0.
  /// `each_second` gets a line for the console.
  void run(const std::atomic<bool>& stop, double seconds,
           const std::function<void(const std::string&)>& each_second);

  std::string console_line() const;
  std::uint64_t server_run() const { return publisher_.info().server_run; }
  const Session& session() const { return session_; }
  const RecordingPlayer& player() const { return player_; }
  Publisher& publisher() { return publisher_; }

 private:
  Simulation& simulation_;
  Bus& bus_;
  std::function<void(const std::string&)> say_;
  RecordingPlayer player_;
  RecordingIndex index_;
  SceneContent content_;
  PublishedTopology topology_;
  Session session_;
  StepMeter meter_;
  std::map<std::string, Prospect> expected_;
  BodyMeter body_meter_;
  std::size_t metered_;  // number of bodies in body_meter_
  PartSender parts_;
  Roster people_;  // recorded participants at the present tick
  std::optional<std::uint64_t> way_to_;
  std::uint32_t epoch_shift_ = 0;  // added to the simulation's epoch for clients
  std::uint32_t epoch_left_ = 0;   // epoch last sent to clients before the seek began
  std::uint64_t turns_ = 0;
  bool begun_ = false, reported_difference_ = false;
  std::vector<Received> received_;
  std::shared_ptr<const Snapshot> last_snapshot_;
  std::int64_t offered_ns_ = 0, status_ns_ = 0, way_begun_ns_ = 0;
  Publisher publisher_;  // last member: its thread ends before the data that it reads

  bool hear();
  void begin_with_the_first();
  void take_wishes();
  std::vector<Outgoing> play_tick();
  std::vector<Outgoing> go_on_the_way();
  std::vector<Outgoing> arrive();
  void meet_people(std::vector<Outgoing>& out);
  bool stand_at_the_end();
  void meter(const StepReport& report, std::int64_t begun_ns);
  std::vector<Outgoing> words_of_bodies();
  void offer_snapshot(bool news);
  std::shared_ptr<Snapshot> reported_snapshot() const;
  SimTime displayed_time() const;
  ServerStatus status() const;
};

}  // namespace prosector
