#include "server/session/run/server_loop.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "server/physics/mechanics/soft/soft_body.h"
#include "server/session/run/publishing.h"
#include "server/session/run/session_rules.h"
#include "server/session/run/session_status.h"
#include "server/session/run/timed_turns.h"
#include "server/session/sending/simulated_shapes.h"

namespace prosector {
namespace {

/// Returns the hands that haptic arms move, with the number of their newest input.
std::vector<FeelingHand> feeling_hands(const Session& session) {
  std::vector<FeelingHand> out;
  for (const auto& [id, member] : session.roster().members())
    for (const std::size_t hand : {left_hand, right_hand}) {
      if ((member.presence.arms >> hand & 1) == 0 || member.role == Role::observer) continue;
      const HandInput* input = session.newest_input(id);
      out.push_back({{id, static_cast<std::uint8_t>(hand)}, input == nullptr ? 0 : input->sequence});
    }
  return out;
}

/// Stores the state that this run began with: that of the scene, or of the session that it continues.
void keep_beginning(const Simulation& simulation, Moments& moments) {
  std::vector<Moments::Revision> revisions;
  for (BodyId body = 0; body < simulation.body_count(); ++body)
    if (simulation.kind(body) == BodyKind::soft) revisions.push_back({body, simulation.revision(body)});
  moments.keep(simulation.time().tick, std::move(revisions), simulation.save());
}

/// Stores the state after a tick that changed a topology.
void keep_moment(const Simulation& simulation, const StepReport& report, Moments& moments) {
  if (report.topology.empty()) return;
  std::vector<Moments::Revision> revisions;
  for (const TopologyChange& change : report.topology) revisions.push_back({change.body, change.revision});
  moments.keep(report.time.tick, std::move(revisions), simulation.save());
}

/// Adds the pieces that cuts have created to the session's bodies.
void add_pieces(const Simulation& simulation, Session& session) {
  for (auto piece = static_cast<BodyId>(session.bodies()); piece < simulation.body_count(); ++piece)
    session.add_body(simulation.name(piece), simulation.soft(piece).desc().part);
}

}  // namespace

ServerLoop::ServerLoop(Simulation& simulation, Bus& bus, const std::string& session, Journal* journal,
                       std::function<void(const std::string&)> say, LoopOptions options)
    : simulation_(simulation),
      bus_(bus),
      clock_(std::move(options.clock)),
      content_(std::make_shared<const SceneContent>(make_scene_content(simulation, options.choices))),
      topology_(*content_, simulation.scene().tick_rate),
      session_(rules_of(simulation.scene(), session, options.remodeller != nullptr)),
      meter_(simulation.scene().tick_rate),
      bodies_(simulation, expectations_of(options.choices)),
      overload_(simulation, say),
      requests_(simulation, options.remodeller, say),
      log_(say),
      journal_(simulation, journal, {std::move(say), std::move(options.checkpoint)}),
      state_hash_(simulation.state_hash()),
      feed_(bus, describe_session(simulation, session, options.reign), content_) {
  add_pieces(simulation_, session_);
  session_.vanish(simulation.hands());  // hands of a restored state
  session_.see_panels(simulation.panels());
  keep_beginning(simulation_, session_.moments());
  requests_.set_prices(bodies_);
  feed_.offer(take_snapshot(simulation_, session_, topology_, nullptr));
}

void ServerLoop::tick() {
  const std::int64_t begun = clock_();
  bus_.take(received_);
  ConsumedInput input = session_.consume(received_, simulation_.time().tick + 1);
  overload_.apply(input.input.efforts);
  const StepReport& report = simulation_.step(input.input);
  session_.finish_tick(simulation_.hands(), report);
  session_.see_panels(simulation_.panels());

  TickJournal::State saved = journal_.checkpoint_if_due();
  keep_moment(simulation_, report, session_.moments());
  state_hash_ = simulation_.state_hash();
  std::vector<SessionEvent> events = events_of(report);
  std::vector<Outgoing> messages = follow_cuts(report);
  journal(std::move(input), std::move(saved), std::move(events));
  const std::int64_t ended = clock_();
  meter_.add(simulation_, session_.roster(), report, begun, ended);
  journal_.add_duration(ended - begun);
  overload_.judge(report, 1e-9 * static_cast<double>(ended - begun));

  requests_.pass_on(session_, bodies_);
  append(messages, session_.output().take_outgoing());
  bodies_.add(report);
  append(messages, bodies_.take());
  journal_.settle(meter_.last_end());
  feed_.say(std::move(messages));
  offer_snapshot(felt_.follow(simulation_, feeling_hands(session_)));
}

void ServerLoop::listen() {
  const std::int64_t now = clock_();
  meter_.pass(now);
  bus_.take(received_);
  session_.listen(received_);
  std::vector<SessionEvent> events = session_.output().take_events();
  log_.write(events, meter_.last_end());
  std::move(events.begin(), events.end(), std::back_inserter(heard_));
  requests_.pass_on(session_, bodies_);
  std::vector<Outgoing> messages = session_.output().take_outgoing();
  send_keyframes(messages);
  const bool news = !messages.empty();
  feed_.say(std::move(messages));
  if (news || feed_.status_due(now)) offer_snapshot();
}

/// Writes the events of a tick to the log. Returns them for the tick's record, after those of the time before
/// it in which simulated time was stopped.
std::vector<SessionEvent> ServerLoop::events_of(const StepReport& report) {
  std::vector<SessionEvent> events = session_.output().take_events();
  for (const Broken& b : report.broken)
    events.push_back(
        {SessionEvent::Kind::broke, 0, simulation_.name(b.body), fmt::format("at {:.0f} N", b.force)});
  log_.write(events, meter_.last_end());
  std::vector<SessionEvent> out = std::exchange(heard_, {});
  std::move(events.begin(), events.end(), std::back_inserter(out));
  return out;
}

void ServerLoop::journal(ConsumedInput input, TickJournal::State checkpoint,
                         std::vector<SessionEvent> events) {
  journal_.append({.tick = simulation_.time().tick,
                   .input = std::move(input),
                   .state_hash = state_hash_,
                   .events = std::move(events),
                   .topology = topology_.take_records()},
                  std::move(checkpoint));
}

void ServerLoop::send_keyframes(std::vector<Outgoing>& out) {
  for (const BodyId body : session_.requests().take_keyframes()) topology_.ask_keyframe(body);
  topology_.send_keyframes(simulation_.time(), out);
}

/// Returns the messages about cuts. They are sent before the tick's own answers and state: clients need a
/// shape before its positions.
std::vector<Outgoing> ServerLoop::follow_cuts(const StepReport& report) {
  add_pieces(simulation_, session_);
  bodies_.add_pieces();
  std::vector<Outgoing> out;
  topology_.follow(SimulatedShapes(simulation_), report.topology, report.time, session_.roster(), out);
  send_keyframes(out);
  return out;
}

void ServerLoop::offer_snapshot(std::vector<FeltPlanes> felt) {
  auto snapshot = take_snapshot(simulation_, session_, topology_, feed_.last());
  snapshot->felt = std::move(felt);
  feed_.offer(std::move(snapshot), meter_.last_end_ns(), [this] { return status(); });
}

void ServerLoop::run(const std::atomic<bool>& stop, double seconds,
                     const std::function<void(const std::string&)>& each_second) {
  const auto pace = [&] {
    const double now = session_.pacing().pace();
    if (now != 1) own_pace_ns_ = meter_.last_end_ns() + second_ns;
    return now;
  };
  meter_.set_slips(take({.tick_rate = simulation_.scene().tick_rate,
                         .seconds = seconds,
                         .turn = [&] { turn(); },
                         .pace = pace,
                         .each_second = [&] { each_second(console_line()); }},
                        stop));
}

void ServerLoop::finish() {
  const bool just_saved = simulation_.time().tick % checkpoint_ticks == 0;
  if (!journal_.exists() || (just_saved && heard_.empty())) return;
  // The run ends with one more step, at whose end the state is saved.
  const StepReport& report = simulation_.step({});
  TickJournal::State saved = journal_.checkpoint();
  state_hash_ = simulation_.state_hash();
  journal({}, std::move(saved), events_of(report));
}

RunFigures ServerLoop::figures() const {
  RunFigures out = meter_.figures();
  out.invalid_dropped = bus_.counters().dropped_total + session_.output().dropped_total();
  out.hand_timeouts = session_.hand_timeouts();
  out.refused_checkpoints = journal_.refused_checkpoints();
  out.commands = session_.output().commands();
  out.state_hash = state_hash_;
  return out;
}

ServerStatus ServerLoop::status() const {
  ServerStatus out = status_of(meter_.steps(), session_, bus_);
  out.time = simulation_.time();
  out.state_hash = state_hash_;
  out.error = bodies_.meter().worst_error();
  const auto add = [&](const std::string& text) {
    if (!text.empty()) out.degraded += (out.degraded.empty() ? "" : "; ") + text;
  };
  const bool own_pace = meter_.last_end_ns() >= own_pace_ns_;  // else the host has set a slow pace
  if (own_pace && out.real_time_factor > 0 && out.real_time_factor < 0.98)
    add(fmt::format("simulated time slowed to {:.2f} of real time", out.real_time_factor));
  add(overload_.stepped_down());
  add(meter_.steps().last_second().degraded);
  add(journal_.complaint());
  if (out.degraded.size() > max_text_length) out.degraded.resize(max_text_length);
  return out;
}

}  // namespace prosector
