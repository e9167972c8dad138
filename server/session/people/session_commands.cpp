// Commands of members: their permissions and their execution.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "server/session/people/session.h"

namespace prosector {

class CommandHandler;

/// Senders that may give a command.
enum class CommandSender : std::uint8_t {
  anyone,     // also observers
  dissector,  // dissectors and the host
  host,
  timekeeper  // the host; in a recording without a host, anyone
};

/// Handling of a command while time is stopped.
enum class WhenStopped : std::uint8_t {
  runs,        // it is executed as usual
  refused,     // it is refused
  runs_a_tick  // the host's is executed in a single tick; others are refused
};

/// Object of a command.
enum class CommandTarget : std::uint8_t {
  session,   // members, roles, time, messages: allowed in recordings, too
  scene,     // refused in recordings and from observers
  recording  // refused in live sessions
};

/// Texts for senders that would have to be the host.
struct HostOnly {
  const char* refusal = nullptr;
  const char* counted = nullptr;  // reason under which the command is counted as dropped; null: not counted
};

/// A row of the table of commands.
struct CommandRule {
  std::size_t number;  // of the command
  CommandSender sender;
  WhenStopped stopped;
  CommandTarget target;
  HostOnly host_only;
  void (*obey)(CommandHandler&, const CommandBody&);

  constexpr bool is_reserved() const {
    return sender == CommandSender::host || sender == CommandSender::timekeeper;
  }
};

/// A member's command and the state that it reads and changes.
class MemberCommand {
 public:
  MemberCommand(Session& session, const Command& command, const Participant& member, Seat& seat)
      : session_(session), command_(command), member_(member), seat_(seat) {}

 protected:
  Session& session_;
  const Command& command_;
  const Participant& member_;
  Seat& seat_;

  ParticipantId sender() const { return command_.participant; }
  void answer(const Refusal& refusal) { session_.output_.answer(command_, refusal); }
  void log(SessionEvent::Kind kind, std::string detail);
  Refusal guard(const CommandRule& rule);
  Refusal missing_body(BodyId body) const;
  bool use_hand(std::uint8_t hand);

 private:
  bool acts_as_host(const CommandRule& rule) const;
};

/// Executes a member's command, and answers it now or after the step. One function for each kind.
class CommandHandler : MemberCommand {
 public:
  using MemberCommand::MemberCommand;
  /// Executes the command if its row of the table allows it now.
  void run();

  void obey(const Join&) { answer({}); }  // already in: a repeated join is no error
  void obey(const Grasp& grasp);
  void obey(const Release& release);
  void obey(const ResetBody& reset);
  void obey(const Leave&);
  void obey(const SetRole& wanted);
  void obey(const Detach& detach) { ask_part(PartEvent::Kind::detach, detach.body); }
  void obey(const Attach& attach) { ask_part(PartEvent::Kind::attach, attach.body); }
  void obey(const Inspect& inspect) { ask_part(PartEvent::Kind::inspect, inspect.body, inspect.shape); }
  void obey(const EndInspect& end) { ask_part(PartEvent::Kind::end_inspect, end.body); }
  void obey(const OpenPanel& open) { answer(session_.panels_.take(sender(), open)); }
  void obey(const ClosePanel& close) { answer(session_.panels_.take(sender(), close)); }
  void obey(const SetControl& set) { answer(session_.panels_.take(sender(), set)); }
  void obey(const Undo&) { seat_.cuts.push_back({command_, {CutEvent::Kind::undo, sender()}, ""}); }
  void obey(const Rewind& rewind);
  void obey(const RequestKeyframe& request);
  void obey(const SetPace& pace) { set_time(pace); }
  void obey(const StepTicks& step) { set_time(step); }
  void obey(const ResetAll&);
  void obey(const Seek& seek);
  void obey(const SetEffort& effort);
  void obey(const SetAllEfforts& effort);
  void obey(const SetAccuracy& accuracy);

 private:
  void ask_part(PartEvent::Kind kind, BodyId body, const Affine& shape = {});
  template <class Time>
  void set_time(const Time& command);
  void set_efforts(std::size_t first, std::size_t end, std::uint32_t steps_down, const std::string& what);
};

namespace {

// More commands in a tick than a user can give; any more are dropped.
constexpr std::uint32_t max_commands_per_tick = 16;

constexpr HostOnly roles{"only the host can assign roles",
                         "Command: refused, because only the host can assign roles"};
constexpr HostOnly rewinding{"only the host can rewind",
                             "Command: refused, because only the host can rewind"};
constexpr HostOnly time_control{
    "only the host can stop, slow or step time",
    "Command: time control refused, because the sender is not the host or the requested pace is not allowed"};
constexpr HostOnly seeking{"only the host can move to another position of the recording", nullptr};
constexpr HostOnly efforts{"only the host can change the solver effort",
                           "Command: refused, because only the host can change the solver effort"};
constexpr HostOnly accuracies{"only the host can set the accuracy",
                              "Command: refused, because only the host can set the accuracy"};

template <class Kind>
constexpr CommandRule rule(CommandSender sender, WhenStopped stopped, CommandTarget target,
                           HostOnly host_only = {}) {
  return {command_number<Kind>(),
          sender,
          stopped,
          target,
          host_only,
          [](CommandHandler& handler, const CommandBody& body) { handler.obey(std::get<Kind>(body)); }};
}

using From = CommandSender;
using Stop = WhenStopped;
using On = CommandTarget;

// clang-format off
constexpr std::array<CommandRule, command_kinds> command_rules = {{
  //                    sender            while time is stopped  object          reserved to the host
  rule<Join>           (From::anyone,     Stop::runs,            On::session),
  rule<Grasp>          (From::dissector,  Stop::refused,         On::scene),
  rule<Release>        (From::dissector,  Stop::refused,         On::scene),
  rule<ResetBody>      (From::dissector,  Stop::refused,         On::scene),
  rule<Leave>          (From::anyone,     Stop::runs,            On::session),
  rule<SetRole>        (From::host,       Stop::runs,            On::session,    roles),
  rule<Detach>         (From::dissector,  Stop::refused,         On::scene),
  rule<Attach>         (From::dissector,  Stop::refused,         On::scene),
  rule<Inspect>        (From::dissector,  Stop::refused,         On::scene),
  rule<EndInspect>     (From::dissector,  Stop::refused,         On::scene),
  rule<OpenPanel>      (From::dissector,  Stop::refused,         On::scene),
  rule<ClosePanel>     (From::dissector,  Stop::refused,         On::scene),
  rule<SetControl>     (From::dissector,  Stop::refused,         On::scene),
  rule<Undo>           (From::dissector,  Stop::refused,         On::scene),
  rule<Rewind>         (From::host,       Stop::runs_a_tick,     On::scene,      rewinding),
  rule<RequestKeyframe>(From::anyone,     Stop::runs,            On::session),
  rule<SetPace>        (From::timekeeper, Stop::runs,            On::session,    time_control),
  rule<StepTicks>      (From::timekeeper, Stop::runs,            On::session,    time_control),
  rule<ResetAll>       (From::host,       Stop::runs_a_tick,     On::scene,      rewinding),
  rule<Seek>           (From::timekeeper, Stop::runs,            On::recording,  seeking),
  rule<SetEffort>      (From::host,       Stop::runs,            On::scene,      efforts),
  rule<SetAllEfforts>  (From::host,       Stop::runs,            On::scene,      efforts),
  rule<SetAccuracy>    (From::host,       Stop::runs,            On::scene,      accuracies),
}};
// clang-format on

/// Returns whether a condition holds for each row of the table.
template <class Condition>
constexpr bool all_rules(Condition condition) {
  for (std::size_t i = 0; i < command_kinds; ++i)
    if (!condition(i, command_rules[i])) return false;
  return true;
}
static_assert(all_rules([](std::size_t i, const CommandRule& r) {
                return r.number == i && r.obey != nullptr;
              }),
              "the table of commands must have one row for each kind, in the order of CommandBody, each with "
              "a handler");
static_assert(all_rules([](std::size_t, const CommandRule& r) {
                return r.is_reserved() == (r.host_only.refusal != nullptr);
              }),
              "each command that is reserved to the host, and no other, must have a refusal text in the "
              "table of commands");
static_assert(all_rules([](std::size_t, const CommandRule& r) {
                return r.target != On::scene || r.sender != From::anyone;
              }),
              "the table of commands must not allow observers to send a command that changes the scene");

Refusal effort_refusal(std::uint32_t steps_down) {
  if (steps_down <= max_steps_down) return {};
  return fmt::format(
      "effort: a reduction by {} steps was requested; allowed: 0 (as configured) to {} (coarsest)",
      steps_down, max_steps_down);
}

}  // namespace

void Session::take(const Command& command, std::uint64_t writer) {
  const Participant* member = roster_.find(command.participant);
  if (member == nullptr) return take_of_visitor(command, writer);
  if (member->writer != writer) return output_.drop("Command: another process's participant");
  Seat& seat = seats_[command.participant];
  if (++seat.commands > max_commands_per_tick)
    return output_.drop("Command: discarded, because its participant sent too many commands in one tick");
  CommandHandler(*this, command, *member, seat).run();
}

void CommandHandler::run() {
  const CommandRule& rule = command_rules[command_.body.index()];
  if (const Refusal refusal = guard(rule)) return answer(refusal);
  if (rule.stopped == Stop::runs_a_tick) session_.pacing_.run_one_tick();
  rule.obey(*this, command_.body);
}

void MemberCommand::log(SessionEvent::Kind kind, std::string detail) {
  session_.output_.log_if_room({kind, sender(), member_.presence.name, std::move(detail)});
}

/// Returns why the command may not be given now. The first guard that refuses it states the reason:
/// 1. recordings: nothing in them changes, and only they have times to seek;
/// 2. observers change nothing;
/// 3. stopped time;
/// 4. what is reserved to the host.
Refusal MemberCommand::guard(const CommandRule& rule) {
  const bool recording = session_.rules_.recording;
  if (recording && rule.target == On::scene) return "this is a recording: it cannot be changed";
  if (!recording && rule.target == On::recording)
    return "this session is live: seeking is possible only in the playback of a recording";
  if (rule.target == On::scene && member_.role == Role::observer) {
    session_.output_.drop("Command: from an observer");
    return "observers cannot change anything: join as a dissector";
  }
  const bool runs_a_tick = rule.stopped == Stop::runs_a_tick && acts_as_host(rule);
  if (session_.pacing_.is_stopped() && rule.stopped != Stop::runs && !runs_a_tick)
    return "time is stopped by the host: wait until the host lets it run";
  if (!rule.is_reserved() || acts_as_host(rule)) return {};
  if (rule.host_only.counted != nullptr) session_.output_.drop(rule.host_only.counted);
  return rule.host_only.refusal;
}

bool MemberCommand::acts_as_host(const CommandRule& rule) const {
  const bool has_host = std::ranges::any_of(session_.roster_.members(),
                                            [](const auto& m) { return m.second.role == Role::host; });
  const bool anyone = rule.sender == From::timekeeper && session_.rules_.recording && !has_host;
  return member_.role == Role::host || anyone;
}

Refusal MemberCommand::missing_body(BodyId body) const {
  const std::size_t bodies = session_.rules_.bodies;
  return body < bodies ? Refusal()
                       : fmt::format("no body {}: the scene has {} bodies, numbered from 0", body, bodies);
}

/// Forgets the body that the hand lost: a user that opens the hand or grasps something else no longer wants
/// it. Returns whether the hand is in the room.
bool MemberCommand::use_hand(std::uint8_t hand) {
  session_.hands_.forget_hold({sender(), hand});
  return seat_.hands[hand].present;
}

void CommandHandler::obey(const Grasp& grasp) {
  if (grasp.hand > right_hand) return answer(fmt::format("no hand {}", grasp.hand));
  if (!use_hand(grasp.hand)) return answer("the hand cannot grasp, because it is not tracked");
  const auto kind = grasp.body ? HandEvent::Kind::grasp_body : HandEvent::Kind::grasp;
  seat_.asked.push_back({kind, sender(), grasp.hand, grasp.body.value_or(0)});
  seat_.grasps.push_back({command_, grasp.hand});
}

void CommandHandler::obey(const Release& release) {
  if (release.hand > right_hand) return answer(fmt::format("no hand {}", release.hand));
  if (use_hand(release.hand))  // else it holds nothing to release
    seat_.asked.push_back({HandEvent::Kind::release, sender(), release.hand, BodyId{0}});
  answer({});
}

void CommandHandler::obey(const ResetBody& reset) {
  if (const Refusal refusal = missing_body(reset.body)) return answer(refusal);
  seat_.asked.push_back({HandEvent::Kind::reset_body, sender(), reset.hand, reset.body});
  answer({});
}

void CommandHandler::obey(const Leave&) {
  answer({});
  session_.leave(sender(), SessionEvent::Kind::left);
}

/// Assigns a role. A host that assigns the host's role gives up its own.
void CommandHandler::obey(const SetRole& wanted) {
  const Participant* subject = session_.roster_.find(wanted.subject);
  if (subject == nullptr)
    return answer("the role cannot be assigned: no participant with that id is in the session");
  if (wanted.subject == sender() && wanted.role != Role::host)
    return answer(
        "you are the host and cannot give up this role: make another participant the host, then you become a "
        "dissector");
  const Refusal refusal = session_.roster_.role_refusal(*subject, wanted.role);
  answer(refusal);
  if (refusal || subject->role == wanted.role) return;
  if (wanted.role == Role::host)
    session_.give(sender(), session_.rules_.recording ? Role::observer : Role::dissector);
  session_.give(wanted.subject, wanted.role);
}

void CommandHandler::ask_part(PartEvent::Kind kind, BodyId body, const Affine& shape) {
  if (const Refusal refusal = missing_body(body)) return answer(refusal);
  seat_.parts.push_back({command_, {kind, sender(), body, shape}});
}

void CommandHandler::obey(const Rewind& rewind) {
  const auto& [body, revision] = rewind;
  if (const Refusal refusal = missing_body(body)) return answer(refusal);
  const Moments::State state = session_.moments_.find(body, revision);
  if (!state)
    return answer(
        fmt::format("the state of revision {} is no longer stored; revisions stored for this body: {}",
                    revision, session_.moments_.kept(body)));
  std::string text = fmt::format("revision {} of body {}", revision, body);
  CutEvent event{CutEvent::Kind::rewind, sender(), body, revision, state};
  seat_.cuts.push_back({command_, std::move(event), std::move(text)});
}

void CommandHandler::obey(const ResetAll&) {
  const Moments::State state = session_.moments_.first();
  if (!state) return answer("the session cannot be reset: its initial state is no longer stored");
  seat_.cuts.push_back({command_, {CutEvent::Kind::rewind, sender(), BodyId{0}, 0, state}, "its beginning"});
}

void CommandHandler::obey(const RequestKeyframe& request) {
  session_.requests_.send_keyframe(request.body);
  answer({});
}

/// Executes the control of time, which affects everyone.
template <class Time>
void CommandHandler::set_time(const Time& command) {
  Pacing& pacing = session_.pacing_;
  const double before = pacing.pace();
  const Refusal refusal = pacing.obey(command);
  answer(refusal);
  if (refusal) return session_.output_.drop(time_control.counted);
  if (pacing.pace() == before) return;
  log(SessionEvent::Kind::pace, pacing.pace() == 0
                                    ? "stopped time"
                                    : fmt::format("lets time run at {:g} times real time", pacing.pace()));
}

void CommandHandler::obey(const Seek& seek) {
  session_.requests_.seek(seek.tick);
  answer({});
}

void CommandHandler::obey(const SetEffort& effort) {
  const auto& [body, steps_down] = effort;
  if (const Refusal refusal = effort_refusal(steps_down)) return answer(refusal);
  if (const Refusal refusal = missing_body(body)) return answer(refusal);
  if (body < session_.rules_.rigid_bodies)
    return answer("that body is rigid: solver effort applies only to soft bodies");
  set_efforts(body, body + std::size_t{1}, steps_down, fmt::format("body {}", body));
}

void CommandHandler::obey(const SetAllEfforts& effort) {
  if (const Refusal refusal = effort_refusal(effort.steps_down)) return answer(refusal);
  set_efforts(session_.rules_.rigid_bodies, session_.rules_.bodies, effort.steps_down, "everything");
}

/// Sets how exactly the soft bodies from `first` to before `end` are solved, from the next tick on.
void CommandHandler::set_efforts(std::size_t first, std::size_t end, std::uint32_t steps_down,
                                 const std::string& what) {
  const int steps = static_cast<int>(steps_down);
  for (std::size_t body = first; body < end; ++body)
    session_.requests_.change_effort({static_cast<BodyId>(body), steps});
  answer({});
  log(SessionEvent::Kind::effort,
      fmt::format("has {} solved {}", what,
                  steps == 0 ? "as described" : fmt::format("{} steps less exactly", steps)));
}

/// Queues a request for a body's accuracy.
void CommandHandler::obey(const SetAccuracy& accuracy) {
  const auto& [body, percent] = accuracy;
  if (!session_.rules_.remodels)
    return answer("this server cannot remodel bodies while it runs: set accuracy in the scene file");
  if (const Refusal refusal = missing_body(body)) return answer(refusal);
  if (body < session_.rules_.rigid_bodies)
    return answer("that body is rigid: accuracy applies only to soft bodies");
  if (percent != 0 && !(percent >= min_accuracy && percent <= max_accuracy))
    return answer(fmt::format(
        "accuracy: {:g} % was requested; allowed: {:g} to {:g} %, or 0 to list the available accuracies",
        percent, min_accuracy, max_accuracy));
  session_.requests_.change_accuracy({sender(), accuracy});
  answer({});
  if (percent == 0) return;
  log(SessionEvent::Kind::accuracy, fmt::format("wants body {} within {:g} %", body, percent));
}

}  // namespace prosector
