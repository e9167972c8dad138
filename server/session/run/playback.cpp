#include "server/session/run/playback.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "common/clock.h"
#include "common/server_run.h"
#include "server/session/recording/recorded_users.h"
#include "server/session/run/publishing.h"
#include "server/session/run/session_lines.h"
#include "server/session/run/session_rules.h"
#include "server/session/run/session_status.h"
#include "server/session/run/timed_turns.h"

namespace prosector {
namespace {

constexpr std::int64_t picture_period_ns =
    second_ns / 75;                          // a faster pace publishes fewer of its ticks, not more snapshots
constexpr std::int64_t way_ns = 30'000'000;  // longest run of ticks of a seek between two polls of the bus

SessionRules rules_for(const Simulation& simulation, const std::string& session) {
  SessionRules rules = rules_of(simulation.scene(), session);
  rules.observers = rules.capacity;
  rules.recording = true;
  return rules;
}

std::function<void(std::uint64_t)> progress(const JournalReader& journal,
                                            const std::function<void(const std::string&)>& say) {
  constexpr std::uint64_t report_interval = 36000;
  return [&say, last = journal.last_tick()](std::uint64_t tick) {
    if (tick % report_interval == 0) say(fmt::format("  read tick {} of {}", tick, last));
  };
}

std::string clock_of(std::uint64_t tick, double tick_rate) {
  const double seconds = static_cast<double>(tick) / tick_rate;
  const int minutes = static_cast<int>(seconds / 60);
  return fmt::format("{}:{:04.1f}", minutes, seconds - 60 * minutes);
}

}  // namespace

Playback::Playback(const Source& source, Bus& bus, const std::string& session,
                   std::function<void(const std::string&)> say)
    : simulation_(source.simulation),
      bus_(bus),
      say_(std::move(say)),
      player_(source.journal, source.simulation),
      index_(source.journal, progress(source.journal, say_)),
      content_(std::make_shared<const SceneContent>(
          make_scene_content(source.simulation, source.journal.header().choices))),
      topology_(*content_, source.simulation, index_),
      session_(rules_for(source.simulation, session)),
      meter_(source.simulation.scene().tick_rate),
      bodies_(source.simulation, expectations_of(source.journal.header().choices)),
      people_(index_),
      feed_(bus, describe_session(source.simulation, session, first_reign), content_) {
  session_.set_pace(0);
  feed_.say({{index_.recording()}});
  offer_snapshot(true);
}

void Playback::turn() {
  bool news = hear();
  std::vector<Outgoing> messages;
  if (seek_)
    messages = go_on_the_way();
  else if (!session_.pacing().is_stopped() && !player_.at_end())
    messages = play_tick();
  news |= !messages.empty();
  topology_.log().send_keyframes(displayed_time(), messages);
  append(messages, session_.output().take_outgoing());
  feed_.say(std::move(messages));
  news |= stand_at_the_end();
  if (!seek_) offer_snapshot(news);
}

/// Processes received messages. Returns whether there is news to publish.
bool Playback::hear() {
  bus_.take(received_);
  (void)session_.consume(received_, ++turns_);
  for (const BodyId body : session_.requests().take_keyframes()) topology_.log().ask_keyframe(body);
  begin_with_the_first();
  take_wishes();
  const std::vector<SessionEvent> events = session_.output().take_events();
  for (const SessionEvent& event : events) say_(line_of(event));
  return !events.empty();
}

void Playback::begin_with_the_first() {
  if (begun_ || session_.roster().members().empty()) return;
  begun_ = true;
  session_.set_pace(1);
}

/// Begins a seek that a viewer requested. If time is started again at the end, playback seeks to the
/// beginning.
void Playback::take_wishes() {
  std::optional<std::uint64_t> wish = session_.requests().take_seek();
  if (!wish && !seek_ && begun_ && session_.pacing().pace() > 0 && player_.tick() >= player_.last_tick())
    wish = 0;
  if (!wish) return;
  if (!seek_) shown_.leave(simulation_.time());
  seek_ = {std::min(*wish, player_.last_tick()), monotonic_ns()};
  player_.approach(seek_->tick);
}

std::vector<Outgoing> Playback::play_tick() {
  const std::int64_t begun = monotonic_ns();
  const bool was_near_enough = player_.is_near_enough();
  shown_.leave(simulation_.time());
  const StepReport& report = player_.step();
  session_.finish_tick({});
  if (was_near_enough && !player_.is_near_enough()) return arrive();
  std::vector<Outgoing> out;
  people_.go_to(player_.tick(), out);
  topology_.follow(report.topology, displayed_time(), people_.now(), out);
  bodies_.add_pieces();
  meter_.add(report, report.awake_bodies > 0, begun, monotonic_ns());
  bodies_.add(report);
  append(out, bodies_.take());
  return out;
}

/// Runs ticks of a seek without publishing them, for up to `way_ns`. Returns the changes when the seek is
/// complete.
std::vector<Outgoing> Playback::go_on_the_way() {
  const std::int64_t until = monotonic_ns() + way_ns;
  while (player_.tick() < seek_->tick && !player_.at_end() && monotonic_ns() < until) player_.step();
  const bool there = player_.tick() >= seek_->tick || player_.at_end();
  return there ? arrive() : std::vector<Outgoing>();
}

/// Returns messages for everything that differs from the time before the seek. Clients get a new epoch, as
/// after a rewind.
std::vector<Outgoing> Playback::arrive() {
  const double rate = simulation_.scene().tick_rate;
  if (seek_)
    say_(fmt::format("at {}, computed in {:.2f} s", clock_of(player_.tick(), rate),
                     seconds_since(seek_->begun_ns)));
  seek_.reset();
  shown_.arrive(simulation_.time());
  std::vector<Outgoing> out;
  people_.go_to(player_.tick(), out);
  topology_.jump(displayed_time(), people_.now(), out);
  bodies_.restart();
  append(out, bodies_.take());
  return out;
}

/// Stops time at the end of the recording. Returns whether it was running.
bool Playback::stand_at_the_end() {
  if (seek_ || !player_.at_end()) return false;
  if (player_.differs() && !std::exchange(reported_difference_, true))
    say_(fmt::format(
        "DIFFERENT: the first tick whose state hash differs from the recorded one is {}; playback stops here",
        *player_.difference()));
  if (!player_.differs()) reported_difference_ = false;
  const bool ran = session_.pacing().pace() > 0;
  session_.set_pace(0);
  return ran;
}

/// Publishes the present state, at most as often as displays show it.
void Playback::offer_snapshot(bool news) {
  const std::int64_t now = monotonic_ns();
  const bool moved = feed_.last() == nullptr || feed_.last()->time != displayed_time();
  if (!news && !feed_.status_due(now) && !(moved && now - offered_ns_ >= picture_period_ns)) return;
  feed_.offer(reported_snapshot(), now, [this] { return status(); });
  offered_ns_ = now;
}

std::shared_ptr<Snapshot> Playback::reported_snapshot() const {
  auto out = take_snapshot(simulation_, session_, topology_.log(), feed_.last());
  out->time = displayed_time();
  for (UserState& user : recorded_users(simulation_, people_.now(), index_))
    out->users.push_back(std::move(user));
  for (UserState& user : out->users) user.time = out->time;
  for (ContactSample& contact : out->contacts) contact.time = out->time;
  for (Panel& panel : out->panels) panel.time = out->time;
  return out;
}

ServerStatus Playback::status() const {
  ServerStatus out = status_of(meter_, session_, bus_);
  out.time = displayed_time();
  if (session_.pacing().pace() == 0) out.real_time_factor = 0;
  out.state_hash = simulation_.state_hash();
  out.error = bodies_.meter().worst_error();
  if (player_.differs())
    out.degraded =
        fmt::format("from tick {} on, this machine or build computes another state than was recorded",
                    *player_.difference());
  return out;
}

void Playback::run(const std::atomic<bool>& stop, double seconds,
                   const std::function<void(const std::string&)>& each_second) {
  take({.tick_rate = simulation_.scene().tick_rate,
        .seconds = seconds,
        .turn = [&] { turn(); },
        .pace = [&] { return session_.pacing().pace(); },
        .each_second = [&] { each_second(console_line()); }},
       stop);
}

std::string Playback::console_line() const {
  const ServerStatus s = status();
  const double rate = simulation_.scene().tick_rate;
  std::string line =
      fmt::format("played {} of {}  x{:.2f} real time | step {:.1f} ms p50, {:.1f} p99 | observers: {}",
                  clock_of(player_.tick(), rate), clock_of(player_.last_tick(), rate), s.real_time_factor,
                  s.step_ms_p50, s.step_ms_p99, session_.roster().members().size());
  if (!s.degraded.empty()) line += " | degraded: " + s.degraded;
  return line;
}

}  // namespace prosector
