#include "server/session/run/playback.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "common/clock.h"
#include "common/server_run.h"
#include "server/session/recording/recorded_users.h"
#include "server/session/run/publishing.h"
#include "server/session/run/server_loop.h"
#include "server/session/run/session_lines.h"
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
  constexpr std::uint64_t told_each = 36000;
  return [&say, last = journal.last_tick()](std::uint64_t tick) {
    if (tick % told_each == 0) say(fmt::format("  read tick {} of {}", tick, last));
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
      content_(make_scene_content(source.simulation, source.journal.header().choices)),
      topology_(content_, source.simulation, index_),
      session_(rules_for(source.simulation, session)),
      meter_(source.simulation.scene().tick_rate),
      expected_(expectations_of(source.journal.header().choices)),
      body_meter_(source.simulation, expected_),
      metered_(source.simulation.body_count()),
      people_(SessionRules{}),
      publisher_(bus, describe_session(source.simulation, session, first_reign), content_) {
  session_.set_pace(0);
  publisher_.say({{index_.recording()}});
  offer_snapshot(true);
}

void Playback::turn() {
  bool news = hear();
  std::vector<Outgoing> told;
  if (way_to_)
    told = go_on_the_way();
  else if (!session_.pacing().stands() && !player_.at_end())
    told = play_tick();
  news |= !told.empty();
  topology_.log().send_keyframes(displayed_time(), told);
  append(told, session_.take_outgoing());
  publisher_.say(std::move(told));
  news |= stand_at_the_end();
  if (!way_to_) offer_snapshot(news);
}

/// Processes received messages. Returns whether there is news to publish.
bool Playback::hear() {
  bus_.take(received_);
  (void)session_.consume(received_, ++turns_);
  for (const BodyId body : session_.take_keyframe_requests()) topology_.log().ask_keyframe(body);
  begin_with_the_first();
  take_wishes();
  const std::vector<SessionEvent> events = session_.take_events();
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
  std::optional<std::uint64_t> wish = session_.take_seek();
  if (!wish && !way_to_ && begun_ && session_.pacing().pace() > 0 && player_.tick() >= player_.last_tick())
    wish = 0;
  if (!wish) return;
  if (!way_to_) epoch_left_ = displayed_time().epoch;
  way_begun_ns_ = monotonic_ns();
  way_to_ = std::min(*wish, player_.last_tick());
  player_.approach(*way_to_);
}

std::vector<Outgoing> Playback::play_tick() {
  const std::int64_t begun = monotonic_ns();
  const bool was_near_enough = player_.is_near_enough();
  epoch_left_ = displayed_time().epoch;
  const StepReport& report = player_.step();
  session_.finish_tick({});
  if (was_near_enough && !player_.is_near_enough()) return arrive();
  std::vector<Outgoing> out;
  meet_people(out);
  topology_.follow(report.topology, displayed_time(), people_, out);
  for (; metered_ < simulation_.body_count(); ++metered_)
    body_meter_.add_body(simulation_, static_cast<BodyId>(metered_));
  meter(report, begun);
  append(out, words_of_bodies());
  return out;
}

/// Runs ticks of a seek without publishing them, for up to `way_ns`. Returns the changes when the seek is
/// complete.
std::vector<Outgoing> Playback::go_on_the_way() {
  const std::int64_t until = monotonic_ns() + way_ns;
  while (player_.tick() < *way_to_ && !player_.at_end() && monotonic_ns() < until) player_.step();
  const bool there = player_.tick() >= *way_to_ || player_.at_end();
  return there ? arrive() : std::vector<Outgoing>();
}

/// Returns messages for everything that differs from the time before the seek. Clients get a new epoch, as
/// after a rewind.
std::vector<Outgoing> Playback::arrive() {
  const double rate = simulation_.scene().tick_rate;
  if (way_to_)
    say_(fmt::format("at {}, computed in {:.2f} s", clock_of(player_.tick(), rate),
                     seconds_since(way_begun_ns_)));
  way_to_.reset();
  epoch_shift_ = epoch_left_ + 1 - simulation_.time().epoch;
  std::vector<Outgoing> out;
  meet_people(out);
  topology_.jump(displayed_time(), people_, out);
  body_meter_ = BodyMeter(simulation_, expected_);
  metered_ = simulation_.body_count();
  append(out, words_of_bodies());
  return out;
}

/// Appends the changes of the roster between the previous and the present time of the recording.
void Playback::meet_people(std::vector<Outgoing>& out) {
  Roster now = index_.people_at(player_.tick());
  for (const auto& [id, member] : people_.members())
    if (now.find(id) == nullptr) out.push_back({Roster::entry(member), true});
  for (const auto& [id, member] : now.members()) {
    const Participant* before = people_.find(id);
    if (before == nullptr || before->role != member.role) out.push_back({Roster::entry(member)});
  }
  people_ = std::move(now);
}

void Playback::meter(const StepReport& report, std::int64_t begun_ns) {
  meter_.add(report, report.awake_bodies > 0, begun_ns, monotonic_ns());
  body_meter_.add(simulation_, report);
}

std::vector<Outgoing> Playback::words_of_bodies() {
  std::vector<Outgoing> out = parts_.take(simulation_);
  for (const BodyStatus& status : body_meter_.take(simulation_)) out.push_back({status});
  return out;
}

/// Stops time at the end of the recording. Returns whether it was running.
bool Playback::stand_at_the_end() {
  if (way_to_ || !player_.at_end()) return false;
  if (player_.differs() && !std::exchange(reported_difference_, true))
    say_(fmt::format("DIFFERENT: the first tick whose state hash differs is {}; playback stops here",
                     *player_.difference()));
  if (!player_.differs()) reported_difference_ = false;
  const bool ran = session_.pacing().pace() > 0;
  session_.set_pace(0);
  return ran;
}

/// Publishes the present state, at most as often as displays show it.
void Playback::offer_snapshot(bool news) {
  const std::int64_t now = monotonic_ns();
  const bool status_due = now - status_ns_ >= status_period_ns;
  const bool moved = last_snapshot_ == nullptr || last_snapshot_->time != displayed_time();
  if (!news && !status_due && !(moved && now - offered_ns_ >= picture_period_ns)) return;
  auto snapshot = reported_snapshot();
  if (status_due) {
    snapshot->status = status();
    status_ns_ = now;
  }
  offered_ns_ = now;
  publisher_.offer(snapshot);
  last_snapshot_ = std::move(snapshot);
}

std::shared_ptr<Snapshot> Playback::reported_snapshot() const {
  auto out = take_snapshot(simulation_, session_, topology_.log(), last_snapshot_.get());
  out->time = displayed_time();
  for (UserState& user : recorded_users(simulation_, people_, index_)) out->users.push_back(std::move(user));
  for (UserState& user : out->users) user.time = out->time;
  for (ContactSample& contact : out->contacts) contact.time = out->time;
  for (Panel& panel : out->panels) panel.time = out->time;
  return out;
}

SimTime Playback::displayed_time() const {
  SimTime out = simulation_.time();
  out.epoch += epoch_shift_;
  return out;
}

ServerStatus Playback::status() const {
  ServerStatus out = status_of(meter_, session_, bus_);
  out.time = displayed_time();
  if (session_.pacing().pace() == 0) out.real_time_factor = 0;
  out.state_hash = simulation_.state_hash();
  out.error = body_meter_.worst_error();
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
      fmt::format("{} of {}  x{:.2f} real time | step {:.1f} ms p50, {:.1f} p99 | observers: {}",
                  clock_of(player_.tick(), rate), clock_of(player_.last_tick(), rate), s.real_time_factor,
                  s.step_ms_p50, s.step_ms_p99, session_.roster().members().size());
  if (!s.degraded.empty()) line += " | degraded: " + s.degraded;
  return line;
}

}  // namespace prosector
