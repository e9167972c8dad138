#pragma once
// The loop of a live session: in each tick it receives, consumes, steps, journals, publishes a snapshot, and
// waits. The only place where the session, the physics and a clock meet.

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "common/clock.h"
#include "common/rate_limited_flag.h"
#include "common/repeated_line_filter.h"
#include "common/server_run.h"
#include "idl/bus.h"
#include "server/haptics/felt_hands.h"
#include "server/physics/simulation.h"
#include "server/session/journal/journal.h"
#include "server/session/people/session.h"
#include "server/session/run/body_meter.h"
#include "server/session/run/effort_dial.h"
#include "server/session/run/governor.h"
#include "server/session/run/remodeller.h"
#include "server/session/run/step_meter.h"
#include "server/session/sending/part_sender.h"
#include "server/session/sending/publisher.h"
#include "server/session/sending/scene_content.h"
#include "server/session/sending/topology_log.h"

namespace prosector {

/// Returns the session rules of a scene. `remodels`: models of bodies can be changed while it runs.
SessionRules rules_of(const SceneDesc& scene, const std::string& session, bool remodels = false);

struct RunFigures {
  std::uint64_t ticks = 0, late_ticks = 0, slips = 0;
  std::uint32_t participants = 0, observers = 0;      // most at a time; observers separately
  double real_time_factor = 0;                        // over the whole run
  double real_time_factor_with_participants = 0;      // since the first member joined; 0: none did
  std::map<std::string, double> max_displacement_mm;  // by soft body: maximum over the run
  std::uint64_t invalid_dropped = 0, hand_timeouts = 0;
  std::uint64_t refused_checkpoints = 0;  // checkpoints of this run that can't be restored
  CommandCounts commands{};
  std::uint64_t state_hash = 0;  // of the last tick
};

/// Optional settings of a loop.
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
  /// Keeps references: all arguments outlive the loop; `journal` may be null. `say` gets the session's log
  /// lines: joins, leaves, and bodies that are solved less exactly.
  ServerLoop(Simulation& simulation, Bus& bus, const std::string& session, Journal* journal,
             std::function<void(const std::string&)> say, LoopOptions options = {});

  /// Runs one tick immediately; while time is stopped, only processes messages.
  void turn() { session_.pacing().stands() ? listen() : tick(); }
  /// Runs one tick immediately.
  void tick();
  /// Processes and answers messages without a tick.
  void listen();
  /// Runs ticks at the scene's rate until `stop`, or for `seconds` of wall time when above 0. `each_second`
  /// gets a line for the console.
  void run(const std::atomic<bool>& stop, double seconds,
           const std::function<void(const std::string&)>& each_second);
  /// Ends the journal at a checkpoint, so that a resumed session continues exactly here.
  void finish();

  RunFigures figures() const;
  ServerStatus status() const;
  std::string console_line() const;
  const StepMeter& meter() const { return meter_; }
  const BodyMeter& body_meter() const { return body_meter_; }
  const Session& session() const { return session_; }
  const SceneContent& content() const { return content_; }
  std::uint64_t server_run() const { return publisher_.info().server_run; }
  const TopologyLog& topology() const { return topology_; }
  Publisher& publisher() { return publisher_; }

 private:
  struct Count {  // tick and wall time of an event
    std::uint64_t tick;
    std::int64_t ns;
  };
  Simulation& simulation_;
  Bus& bus_;
  Journal* journal_;
  std::function<void(const std::string&)> say_;
  LoopOptions options_;
  SceneContent content_;
  TopologyLog topology_;
  Session session_;
  StepMeter meter_;
  BodyMeter body_meter_;
  Governor governor_;
  EffortDial dial_;
  PartSender parts_;
  FeltHands felt_;
  std::vector<EffortChange> efforts_;    // changes for the next tick
  std::vector<AccuracyAnswer> unheard_;  // for askers that are not in the session
  std::vector<SessionEvent> heard_;      // while time was stopped: for the next tick's record
  std::vector<Received> received_;
  std::shared_ptr<const Snapshot> last_snapshot_;
  std::uint64_t state_hash_ = 0, last_tick_ = 0;  // last_tick_: the tick that ended at last_end_ns_
  std::int64_t status_ns_ = 0, last_end_ns_ = 0, since_checkpoint_ns_ = 0;
  std::int64_t own_pace_ns_ = 0;  // from then on a slow pace is not the host's choice
  std::optional<Count> start_, first_arrival_;
  RunFigures figures_;
  std::string journal_trouble_;
  bool journal_late_ = false;
  RateLimitedFlag journal_lateness_;
  RepeatedLineFilter repeated_;
  Publisher publisher_;  // last member: its thread ends before the data that it reads

  void keep_beginning();
  void remodel();
  void tell_prices();
  void keep_moment(const StepReport& report);
  void journal(ConsumedInput input, std::vector<std::uint8_t> checkpoint, std::vector<SessionEvent> events);
  std::vector<std::uint8_t> checkpoint_if_due();
  std::vector<std::uint8_t> checkpoint();
  void settle_journal();
  void record(const StepReport& report, std::int64_t begun_ns);
  void offer_snapshot(std::vector<FeltPlanes> felt = {});
  void govern(const StepReport& report, std::int64_t begun_ns);
  std::string stepped_down() const;
  std::vector<Outgoing> words_of_bodies(const StepReport& report);
  std::vector<Outgoing> words_of_cuts(const StepReport& report);
  void announce(const std::vector<SessionEvent>& events);
  double real_time_factor(const std::optional<Count>& since) const;
};

}  // namespace prosector
