#include "server/session/run/server_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "common/count_text.h"
#include "common/error.h"
#include "common/percent_text.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/stations/save/take_over.h"
#include "server/session/run/publishing.h"
#include "server/session/run/session_lines.h"
#include "server/session/run/session_status.h"
#include "server/session/run/timed_turns.h"
#include "server/session/sending/simulated_shapes.h"

namespace prosector {
namespace {

constexpr std::int64_t longest_replay_ns = second_ns;  // longest replay of ticks when a session is resumed
constexpr const char* journal_is_late = "journal writing is behind the session: the disk is too slow";
constexpr double journal_interval = 60;  // s between two reports that the journal is late
constexpr double line_interval = 10;     // s between two lines of one kind
constexpr double death_timeout = 1.5;    // s after which a dead client has been detected: its lease is 1 s
constexpr double stall_timeout = 5;      // s that the hands of a silent client stay while its lease is valid
constexpr double regrasp_timeout = 30;   // s for which a hand may grasp again what it lost in a stall
constexpr double presence_timeout = 2;   // s that a join waits for its Presence

/// Returns the bodies whose scene allows stepping down, with their steps in a restored state.
std::map<BodyId, int> may_step_down(const Simulation& simulation) {
  std::map<BodyId, int> out;
  for (BodyId b = 0; b < simulation.body_count(); ++b)
    if (simulation.kind(b) == BodyKind::soft && simulation.soft(b).desc().step_down)
      out[b] = simulation.soft_state(b).steps_down;
  return out;
}

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

}  // namespace

SessionRules rules_of(const SceneDesc& scene, const std::string& session, bool remodels) {
  SessionRules rules;
  rules.remodels = remodels;
  rules.session = session;
  rules.capacity = scene.session.capacity;
  rules.observers = scene.session.observers;
  const auto ticks = [&](double seconds) {
    return static_cast<std::uint64_t>(std::ceil(seconds * scene.tick_rate));
  };
  rules.input_timeout = ticks(scene.session.input_timeout);
  rules.stall_timeout = std::max(rules.input_timeout, ticks(stall_timeout));
  rules.regrasp_timeout = ticks(regrasp_timeout);
  rules.presence_timeout = ticks(presence_timeout);
  rules.death_timeout = ticks(death_timeout);
  const auto add = [&](const auto& body) {
    rules.parts.push_back(body.part);
    rules.names.push_back(body.name);
  };
  for (const RigidDesc& rigid : scene.rigid) add(rigid);
  for (const SoftDesc& soft : scene.soft) add(soft);
  rules.bodies = rules.parts.size();
  rules.rigid_bodies = scene.rigid.size();
  return rules;
}

ServerLoop::ServerLoop(Simulation& simulation, Bus& bus, const std::string& session, Journal* journal,
                       std::function<void(const std::string&)> say, LoopOptions options)
    : simulation_(simulation),
      bus_(bus),
      journal_(journal),
      say_(std::move(say)),
      options_(std::move(options)),
      content_(make_scene_content(simulation, options_.choices)),
      topology_(content_, simulation.scene().tick_rate),
      session_(rules_of(simulation.scene(), session, options_.remodeller != nullptr)),
      meter_(simulation.scene().tick_rate),
      body_meter_(simulation, expectations_of(options_.choices)),
      governor_(simulation.scene().tick_rate, may_step_down(simulation)),
      state_hash_(simulation.state_hash()),
      journal_lateness_(journal_interval),
      repeated_(line_interval),
      publisher_(bus, describe_session(simulation, session, options_.reign), content_) {
  for (auto piece = static_cast<BodyId>(session_.bodies()); piece < simulation.body_count(); ++piece)
    session_.add_body(simulation.name(piece), simulation.soft(piece).desc().part);
  for (const auto& [body, steps] : governor_.steps_down()) (void)dial_.overload({body, steps});
  session_.vanish(simulation.hands());  // hands of a restored state
  session_.see_panels(simulation.panels());
  keep_beginning();
  tell_prices();
  last_snapshot_ = take_snapshot(simulation_, session_, topology_, nullptr);
  publisher_.offer(last_snapshot_);
}

/// Passes the host's requests for accuracy to the remodeller, and the results of earlier requests to the
/// askers that are in the session.
void ServerLoop::remodel() {
  Remodeller* remodeller = options_.remodeller;
  if (remodeller == nullptr) return;
  for (const auto& [participant, wanted] : session_.take_accuracy_wishes()) {
    const std::string& name = simulation_.name(wanted.body);
    if (wanted.percent > 0 && simulation_.revision(wanted.body) > 0)
      session_.tell(participant, cut_stays(name).why());
    else
      remodeller->ask({participant, wanted.body, name, wanted.percent});
  }
  std::vector<AccuracyAnswer> answers = remodeller->take_answers();
  if (!answers.empty()) tell_prices();
  std::move(answers.begin(), answers.end(), std::back_inserter(unheard_));
  std::erase_if(unheard_, [&](const AccuracyAnswer& answer) {
    if (!session_.roster().members().contains(answer.wish.asker)) return false;
    say_(answer.words);
    session_.tell(answer.wish.asker, answer.words);
    return true;
  });
}

void ServerLoop::tell_prices() {
  if (options_.remodeller == nullptr) return;
  const auto prices = options_.remodeller->prices();
  for (BodyId body = 0; body < simulation_.body_count(); ++body)
    if (const auto known = prices.find(simulation_.name(body)); known != prices.end())
      body_meter_.set_prices(body, known->second);
}

/// Stores the state that this run began with: that of the scene, or of the session that it continues.
void ServerLoop::keep_beginning() {
  std::vector<Moments::Revision> revisions;
  for (BodyId body = 0; body < simulation_.body_count(); ++body)
    if (simulation_.kind(body) == BodyKind::soft) revisions.push_back({body, simulation_.revision(body)});
  session_.moments().keep(simulation_.time().tick, std::move(revisions), simulation_.save());
}

void ServerLoop::keep_moment(const StepReport& report) {
  if (report.topology.empty()) return;
  std::vector<Moments::Revision> revisions;
  for (const TopologyChange& change : report.topology) revisions.push_back({change.body, change.revision});
  session_.moments().keep(report.time.tick, std::move(revisions), simulation_.save());
}

void ServerLoop::tick() {
  const std::int64_t begun = options_.clock();
  bus_.take(received_);
  ConsumedInput input = session_.consume(received_, simulation_.time().tick + 1);
  for (EffortChange& asked : input.input.efforts) asked = dial_.host(asked);
  for (const EffortChange& governed : efforts_) input.input.efforts.push_back(dial_.overload(governed));
  efforts_.clear();
  const StepReport& report = simulation_.step(input.input);
  session_.finish_tick(simulation_.hands(), report);
  session_.see_panels(simulation_.panels());

  std::vector<std::uint8_t> saved = checkpoint_if_due();
  keep_moment(report);
  state_hash_ = simulation_.state_hash();
  std::vector<SessionEvent> events = session_.take_events();
  for (const Broken& b : report.broken)
    events.push_back(
        {SessionEvent::Kind::broke, 0, simulation_.name(b.body), fmt::format("at {:.0f} N", b.force)});
  announce(events);
  events.insert(events.begin(), std::make_move_iterator(heard_.begin()),
                std::make_move_iterator(heard_.end()));
  heard_.clear();
  std::vector<Outgoing> told = words_of_cuts(report);
  journal(std::move(input), std::move(saved), std::move(events));
  record(report, begun);
  govern(report, begun);

  remodel();
  append(told, session_.take_outgoing());
  append(told, parts_.take(simulation_));
  append(told, words_of_bodies(report));
  settle_journal();
  publisher_.say(std::move(told));
  offer_snapshot(felt_.follow(simulation_, feeling_hands(session_)));
}

void ServerLoop::listen() {
  last_end_ns_ = options_.clock();
  bus_.take(received_);
  session_.listen(received_);
  std::vector<SessionEvent> events = session_.take_events();
  announce(events);
  std::move(events.begin(), events.end(), std::back_inserter(heard_));
  remodel();
  std::vector<Outgoing> told = session_.take_outgoing();
  for (const BodyId body : session_.take_keyframe_requests()) topology_.ask_keyframe(body);
  topology_.send_keyframes(simulation_.time(), told);
  const bool news = !told.empty();
  publisher_.say(std::move(told));
  if (news || last_end_ns_ - status_ns_ >= status_period_ns) offer_snapshot();
}

void ServerLoop::offer_snapshot(std::vector<FeltPlanes> felt) {
  auto snapshot = take_snapshot(simulation_, session_, topology_, last_snapshot_.get());
  snapshot->felt = std::move(felt);
  if (last_end_ns_ - status_ns_ >= status_period_ns) {
    snapshot->status = status();
    status_ns_ = last_end_ns_;
  }
  publisher_.offer(snapshot);
  last_snapshot_ = std::move(snapshot);
}

/// Makes a checkpoint at the regular ticks. With a journal, also makes one when the ticks since the last one
/// would take long to run again.
std::vector<std::uint8_t> ServerLoop::checkpoint_if_due() {
  const bool regular = simulation_.time().tick % checkpoint_ticks == 0;
  const bool long_ago = journal_ != nullptr && since_checkpoint_ns_ > longest_replay_ns;
  if (!regular && !long_ago) return {};
  since_checkpoint_ns_ = 0;
  return checkpoint();
}

/// Returns a checkpoint, or nothing if its own bytes can't be restored. Then the session continues from its
/// present state, and the journal from its last checkpoint.
std::vector<std::uint8_t> ServerLoop::checkpoint() {
  try {
    return options_.checkpoint ? options_.checkpoint() : simulation_.checkpoint();
  } catch (const InputError& error) {
    if (std::has_single_bit(++figures_.refused_checkpoints))  // at powers of two: must not flood the console
      say_(
          fmt::format("internal error: the checkpoint of tick {} cannot be restored and is skipped ({} so "
                      "far); the session continues: {}. Please report this.",
                      simulation_.time().tick, figures_.refused_checkpoints, error.what()));
    return {};
  }
}

void ServerLoop::journal(ConsumedInput input, std::vector<std::uint8_t> checkpoint,
                         std::vector<SessionEvent> events) {
  if (journal_ == nullptr) return;
  journal_->append({simulation_.time().tick, std::move(input), state_hash_, !checkpoint.empty(),
                    std::move(events), topology_.take_records()},
                   std::move(checkpoint));
}

/// Waits for the journal: a tick is in the file before users see it, unless the disk is too slow for that.
void ServerLoop::settle_journal() {
  if (journal_ == nullptr || !journal_trouble_.empty()) return;
  journal_late_ = !journal_->settle();
  if (const auto late = journal_lateness_.look(journal_late_, 1e-9 * static_cast<double>(last_end_ns_)))
    say_(*late ? fmt::format("{}; the session continues", journal_is_late) : "the journal has caught up");
  journal_trouble_ = journal_->trouble();
  if (!journal_trouble_.empty()) say_(journal_trouble_ + "; the session continues without a journal");
}

void ServerLoop::record(const StepReport& report, std::int64_t begun_ns) {
  last_end_ns_ = options_.clock();
  last_tick_ = simulation_.time().tick;
  if (!start_) start_ = {last_tick_, last_end_ns_};
  const Roster& roster = session_.roster();
  if (!roster.members().empty() && !first_arrival_) first_arrival_ = {last_tick_, last_end_ns_};
  figures_.participants = std::max(figures_.participants, roster.participants());
  figures_.observers = std::max(figures_.observers, roster.observers());
  ++figures_.ticks;
  bool tissue_awake = false;
  for (BodyId b = 0; b < simulation_.body_count(); ++b) {
    if (simulation_.kind(b) != BodyKind::soft || simulation_.asleep(b)) continue;
    tissue_awake = true;
    double& most = figures_.max_displacement_mm[simulation_.name(b)];
    most = std::max(most, 1e3 * simulation_.max_displacement(b));
  }
  meter_.add(report, tissue_awake, begun_ns, last_end_ns_);
  since_checkpoint_ns_ += last_end_ns_ - begun_ns;
}

/// Makes the duration of this tick an input of the next.
void ServerLoop::govern(const StepReport& report, std::int64_t begun_ns) {
  efforts_.clear();
  if (governor_.steps_down().empty()) return;
  std::map<BodyId, double> work;
  for (const auto& [body, steps] : governor_.steps_down()) {
    const std::string& name = simulation_.name(body);
    for (const BodyReport& row : report.bodies)
      if (row.body == name)
        work[body] += static_cast<double>(1 + row.solver_iterations) *
                      static_cast<double>(simulation_.soft(body).elements());
  }
  const double seconds = 1e-9 * static_cast<double>(last_end_ns_ - begun_ns);
  const auto change = governor_.tick(seconds, work);
  if (!change) return;
  efforts_.push_back(*change);
  const std::string& name = simulation_.name(change->body);
  if (change->steps_down == 0)
    say_(fmt::format("{} is solved at its configured effort again: the server has spare capacity", name));
  else
    say_(fmt::format("{}: solver effort is reduced by {} of {} steps: the server {}", name,
                     change->steps_down, max_steps_down,
                     change->steps_down > simulation_.soft_state(change->body).steps_down
                         ? "is overloaded"
                         : "has spare capacity again"));
}

/// Returns the bodies that are solved less exactly, for the status.
std::string ServerLoop::stepped_down() const {
  std::string out;
  for (const auto& [body, steps] : governor_.steps_down())
    if (steps > 0)
      out += fmt::format("{}{}: effort reduced by {} because of overload", out.empty() ? "" : ", ",
                         simulation_.name(body), steps);
  return out;
}

std::vector<Outgoing> ServerLoop::words_of_bodies(const StepReport& report) {
  body_meter_.add(simulation_, report);
  std::vector<Outgoing> out;
  for (const BodyStatus& status : body_meter_.take(simulation_)) out.push_back({status});
  return out;
}

/// Returns the messages about cuts. They are sent before the tick's own answers and state: clients need a
/// shape before its positions.
std::vector<Outgoing> ServerLoop::words_of_cuts(const StepReport& report) {
  for (auto piece = static_cast<BodyId>(session_.bodies()); piece < simulation_.body_count(); ++piece) {
    session_.add_body(simulation_.name(piece), simulation_.soft(piece).desc().part);
    body_meter_.add_body(simulation_, piece);
  }
  std::vector<Outgoing> out;
  topology_.follow(SimulatedShapes(simulation_), report.topology, report.time, session_.roster(), out);
  for (const BodyId body : session_.take_keyframe_requests()) topology_.ask_keyframe(body);
  topology_.send_keyframes(simulation_.time(), out);
  return out;
}

void ServerLoop::announce(const std::vector<SessionEvent>& events) {
  using Kind = SessionEvent::Kind;
  const double now = 1e-9 * static_cast<double>(last_end_ns_);
  for (const SessionEvent& e : events) {
    const bool may_flood = e.kind == Kind::hand_timeout || e.kind == Kind::hand_stalled ||
                           e.kind == Kind::let_go || e.kind == Kind::refused;
    const std::string line = line_of(e);
    if (const auto printed = may_flood ? repeated_.admit(line, now) : line) say_(*printed);
  }
}

void ServerLoop::run(const std::atomic<bool>& stop, double seconds,
                     const std::function<void(const std::string&)>& each_second) {
  const auto pace = [&] {
    const double now = session_.pacing().pace();
    if (now != 1) own_pace_ns_ = last_end_ns_ + second_ns;
    return now;
  };
  figures_.slips = take({.tick_rate = simulation_.scene().tick_rate,
                         .seconds = seconds,
                         .turn = [&] { turn(); },
                         .pace = pace,
                         .each_second = [&] { each_second(console_line()); }},
                        stop);
}

void ServerLoop::finish() {
  if (journal_ == nullptr || simulation_.time().tick % checkpoint_ticks == 0) return;
  // The run ends with one more step, at whose end the state is saved.
  simulation_.step({});
  std::vector<std::uint8_t> saved = checkpoint();
  state_hash_ = simulation_.state_hash();
  journal({}, std::move(saved), session_.take_events());
}

double ServerLoop::real_time_factor(const std::optional<Count>& since) const {
  if (!since || last_end_ns_ <= since->ns) return 0;
  return static_cast<double>(last_tick_ - since->tick) / simulation_.scene().tick_rate /
         (1e-9 * static_cast<double>(last_end_ns_ - since->ns));
}

RunFigures ServerLoop::figures() const {
  RunFigures out = figures_;
  out.late_ticks = meter_.late();
  out.real_time_factor = real_time_factor(start_);
  out.real_time_factor_with_participants = real_time_factor(first_arrival_);
  out.invalid_dropped = bus_.counters().dropped_total + session_.dropped_total();
  out.hand_timeouts = session_.hand_timeouts();
  out.commands = session_.commands();
  out.state_hash = state_hash_;
  return out;
}

ServerStatus ServerLoop::status() const {
  ServerStatus out = status_of(meter_, session_, bus_);
  out.time = simulation_.time();
  out.state_hash = state_hash_;
  out.error = body_meter_.worst_error();
  const auto add = [&](const std::string& text) {
    if (!text.empty()) out.degraded += (out.degraded.empty() ? "" : "; ") + text;
  };
  const bool own_pace = last_end_ns_ >= own_pace_ns_;  // else the host has set a slow pace
  if (own_pace && out.real_time_factor > 0 && out.real_time_factor < 0.98)
    add(fmt::format("simulated time slowed to {:.2f} of real time", out.real_time_factor));
  add(stepped_down());
  add(meter_.last_second().degraded);
  if (journal_late_) add(journal_is_late);
  add(journal_trouble_);
  if (out.degraded.size() > max_text_length) out.degraded.resize(max_text_length);
  return out;
}

std::string ServerLoop::console_line() const {
  const ServerStatus s = status();
  std::string line = fmt::format(
      "{:7.1f} s  x{:.2f} real time | step {:.1f} ms p50, {:.1f} p99 | {}, {} | "
      "{} dropped | {} awake, {} asleep",
      static_cast<double>(s.time.tick) / simulation_.scene().tick_rate, s.real_time_factor, s.step_ms_p50,
      s.step_ms_p99, counted(s.participants, "participant"), counted(s.observers, "observer"),
      s.invalid_dropped, s.awake_bodies, s.asleep_bodies);
  for (const auto& [body, told] : body_meter_.newest())
    if (told.error >= 0 && !told.asleep) {
      line += fmt::format(" | {}: {}, residual {:.0e}", simulation_.name(body),
                          is_known_error(told.error) ? fmt::format("about {} off", percent_text(told.error))
                                                     : "error not known",
                          told.residual);
      if (told.press_error >= 0)
        line += is_known_error(told.press_error)
                    ? fmt::format(", pressed: force within {}", percent_text(told.press_error))
                    : ", pressed: error not known";
    }
  if (!s.degraded.empty()) line += " | degraded: " + s.degraded;
  return line;
}

}  // namespace prosector
