#pragma once
// The loop of a live session: in each tick it receives, consumes, steps, journals, publishes a snapshot, and
// waits. The only place where the session, the physics and a clock meet.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/clock.h"
#include "common/server_run.h"
#include "idl/bus.h"
#include "server/haptics/felt_hands.h"
#include "server/physics/simulation.h"
#include "server/session/people/session.h"
#include "server/session/run/body_reports.h"
#include "server/session/run/event_log.h"
#include "server/session/run/overload_control.h"
#include "server/session/run/remodel_requests.h"
#include "server/session/run/run_meter.h"
#include "server/session/run/session_lines.h"
#include "server/session/run/tick_journal.h"
#include "server/session/sending/scene_content.h"
#include "server/session/sending/snapshot_feed.h"
#include "server/session/sending/topology_log.h"

namespace prosector {

/// Optional settings of the server's loop: chosen model configurations, clock, number of starts of the
/// session, and functions that replace the default ones.
struct LoopOptions {
  std::vector<Choice> choices;                         // of the scene's bodies that were chosen by need
  std::function<std::int64_t()> clock = monotonic_ns;  // measures how late ticks are
  std::uint32_t reign = first_reign;                   // of the session: see common/server_run.h
  Remodeller* remodeller = nullptr;                    // null: models of bodies can't be changed
  // Makes a checkpoint; throws InputError where it can't be restored. Null: Simulation::checkpoint().
  std::function<std::vector<std::uint8_t>()> checkpoint = nullptr;
};

class ServerLoop {
 public:
  /// Stores references: all arguments must outlive the loop. `journal` may be null. `say` is called with the
  /// lines of the session's log: joins, leaves, and bodies that are solved less exactly.
  ServerLoop(Simulation& simulation, Bus& bus, const std::string& session, Journal* journal,
             std::function<void(const std::string&)> say, LoopOptions options = {});

  /// Runs one tick immediately. While simulated time is stopped, only processes messages.
  void turn() { session_.pacing().is_stopped() ? listen() : tick(); }
  /// Runs one tick of the session immediately: receives, steps, journals and publishes.
  void tick();
  /// Processes and answers received messages without running a tick.
  void listen();
  /// Runs ticks at the scene's rate until `stop` is true, or for `seconds` of wall time if above 0.
  /// `each_second` is called once a second with a line for the console.
  void run(const std::atomic<bool>& stop, double seconds,
           const std::function<void(const std::string&)>& each_second);
  /// Writes a checkpoint as the journal's last entry, so that a resumed session continues exactly here.
  void finish();

  RunFigures figures() const;
  ServerStatus status() const;
  std::string console_line() const { return line_of(status(), simulation_, bodies_.meter()); }
  const StepMeter& meter() const { return meter_.steps(); }
  const BodyMeter& body_meter() const { return bodies_.meter(); }
  const Session& session() const { return session_; }
  const SceneContent& content() const { return *content_; }
  std::uint64_t server_run() const { return feed_.publisher().info().server_run; }
  const TopologyLog& topology() const { return topology_; }
  Publisher& publisher() { return feed_.publisher(); }

 private:
  Simulation& simulation_;
  Bus& bus_;
  std::function<std::int64_t()> clock_;
  std::shared_ptr<const SceneContent> content_;
  TopologyLog topology_;
  Session session_;
  RunMeter meter_;
  BodyReports bodies_;
  OverloadControl overload_;
  RemodelRequests requests_;
  EventLog log_;
  TickJournal journal_;
  FeltHands felt_;
  std::vector<SessionEvent> heard_;  // while time was stopped: for the next tick's record
  std::vector<Received> received_;
  std::uint64_t state_hash_ = 0;
  std::int64_t own_pace_ns_ = 0;  // from then on a slow pace is not the host's choice
  SnapshotFeed feed_;

  std::vector<SessionEvent> events_of(const StepReport& report);
  void journal(ConsumedInput input, TickJournal::State checkpoint, std::vector<SessionEvent> events);
  void send_keyframes(std::vector<Outgoing>& out);
  std::vector<Outgoing> follow_cuts(const StepReport& report);
  void offer_snapshot(std::vector<FeltPlanes> felt = {});
};

}  // namespace prosector
