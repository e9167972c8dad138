// Every command by every role, while time runs and stands still, in live sessions and recordings: which are
// allowed, and why the others are refused.

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>

#include "server/session/people/session.h"

namespace prosector {
namespace {

// Answers, as the table states them.
const std::map<char, std::string> reasons = {{'+', ""},
                                             {'O', "observers cannot change"},
                                             {'T', "time is stopped"},
                                             {'H', "only the host"},
                                             {'R', "this is a recording"},
                                             {'L', "this session is live"}};

/// The answers to a command of an observer, a dissector and the host.
struct Row {
  CommandBody body;
  const char* running;
  const char* stopped;
  const char* recording;  // whether its time stands still or not
};

std::array<Row, command_kinds> table() {
  const auto changes = [](const CommandBody& body) { return Row{body, "O++", "OTT", "RRR"}; };
  return {{
      {Join{}, "+++", "+++", "+++"},
      changes(Grasp{}),
      changes(Release{}),
      changes(ResetBody{2}),
      {Leave{}, "+++", "+++", "+++"},
      {SetRole{3, Role::observer}, "HH+", "HH+", "HH+"},
      changes(Detach{2}),
      changes(Attach{2}),
      changes(Inspect{2}),
      changes(EndInspect{2}),
      changes(OpenPanel{2}),
      changes(ClosePanel{}),
      changes(SetControl{PanelControl::light_shaft, 1}),
      changes(Undo{}),
      {Rewind{2, 7}, "OH+", "OT+", "RRR"},
      {RequestKeyframe{2}, "+++", "+++", "+++"},
      {SetPace{0.5}, "HH+", "HH+", "HH+"},
      {StepTicks{3}, "HH+", "HH+", "HH+"},
      {ResetAll{}, "OH+", "OT+", "RRR"},
      {Seek{5}, "LLL", "LLL", "HH+"},
      {SetEffort{2, 1}, "OH+", "OH+", "RRR"},
      {SetAllEfforts{1}, "OH+", "OH+", "RRR"},
      {SetAccuracy{2, 5}, "OH+", "OH+", "RRR"},
  }};
}

constexpr ParticipantId asker = 2, bystander = 3, other_host = 4;

Received from(ParticipantId who, Message message) {
  Received out;
  out.message = std::move(message);
  out.writer = who;
  return out;
}

/// A session in which each command of the table could be granted: the asker has a hand and a panel, and there
/// is a state to rewind to.
class Asked {
 public:
  Asked(bool recording, bool has_other_host, Role role) : session_(rules(recording)) {
    if (has_other_host) join(other_host, "hana", Role::host);
    join(bystander, "otto", Role::observer);
    join(asker, "ada", role);
    HandInput input;
    input.participant = asker;
    input.sequence = 1;
    input.hands[right_hand].tracked = true;
    tick({from(asker, input)});
    session_.moments().keep(1, {{2, 7}}, {1});
    Panel panel;
    panel.participant = asker;
    panel.open = true;
    panel.body = 2;
    session_.see_panels(std::vector<Panel>{panel});
  }
  Session& session() { return session_; }
  /// Gives a command. Returns its answer.
  CommandResult answer(const CommandBody& body) {
    const std::vector<Received> received = {from(asker, Command{asker, 9, body})};
    if (session_.pacing().is_stopped()) {
      session_.listen(received);
      if (!session_.pacing().is_stopped()) tick({});
    } else {
      tick(received);
    }
    std::optional<CommandResult> out;
    for (const Outgoing& outgoing : session_.output().take_outgoing())
      if (const auto* result = std::get_if<CommandResult>(&outgoing.message);
          result && result->sequence == 9) {
        EXPECT_FALSE(out) << "answered twice";
        out = *result;
      }
    EXPECT_TRUE(out) << "not answered";
    return out.value_or(CommandResult{});
  }

 private:
  static SessionRules rules(bool recording) {
    SessionRules out;
    out.names = {"table", "ball", "liver"};
    out.parts = {false, true, true};
    out.bodies = 3;
    out.rigid_bodies = 2;
    out.recording = recording;
    out.remodels = true;
    return out;
  }
  void join(ParticipantId who, const std::string& name, Role role) {
    Presence presence;
    presence.participant = who;
    presence.name = name;
    presence.role = role;
    tick({from(who, presence), from(who, Command{who, 1, Join{}})});
  }
  /// Runs a tick in which the step grants everything.
  void tick(const std::vector<Received>& received) {
    const ConsumedInput in = session_.consume(received, ++tick_);
    StepReport report;
    report.part_answers.resize(in.input.parts.size());
    report.cut_answers.resize(in.input.cuts.size());
    report.panel_carriers = {HandRef{asker, right_hand}};
    session_.finish_tick({}, report);
  }

  Session session_;
  std::uint64_t tick_ = 0;
};

void expect_answer(char expected, const CommandBody& body, bool recording, bool stopped, Role role) {
  SCOPED_TRACE(testing::Message() << command_names[body.index()] << " by role " << static_cast<int>(role)
                                  << (recording ? ", recording" : ", live") << (stopped ? ", stopped" : ""));
  Asked asked(recording, role != Role::host, role);
  asked.session().set_pace(stopped ? 0 : 1);
  const std::uint64_t dropped = asked.session().output().dropped_total();
  const CommandResult answer = asked.answer(body);
  EXPECT_EQ(answer.accepted, expected == '+') << answer.reason;
  EXPECT_TRUE(answer.reason.starts_with(reasons.at(expected))) << answer.reason;
  const bool counted = expected == 'O' || (expected == 'H' && !std::holds_alternative<Seek>(body));
  EXPECT_EQ(asked.session().output().dropped_total() - dropped, counted ? 1u : 0u);
  const CommandCount& count = asked.session().output().commands()[body.index()];
  EXPECT_EQ(count.refused, answer.accepted ? 0u : 1u);
}

TEST(CommandTable, EveryCommandIsAllowedOrRefusedAsStated) {
  const auto rows = table();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    ASSERT_EQ(row.body.index(), i) << "the rows are in the order of CommandBody";
    for (const Role role : {Role::observer, Role::dissector, Role::host}) {
      const auto column = static_cast<std::size_t>(role);
      expect_answer(row.running[column], row.body, false, false, role);
      expect_answer(row.stopped[column], row.body, false, true, role);
      for (const bool stopped : {false, true})
        expect_answer(row.recording[column], row.body, true, stopped, role);
    }
  }
}

TEST(CommandTable, InARecordingWithoutAHostAnyoneControlsTimeAlone) {
  for (const Row& row : table()) {
    SCOPED_TRACE(command_names[row.body.index()]);
    const bool is_of_time = std::holds_alternative<SetPace>(row.body) ||
                            std::holds_alternative<StepTicks>(row.body) ||
                            std::holds_alternative<Seek>(row.body);
    Asked asked(true, false, Role::dissector);
    const CommandResult answer = asked.answer(row.body);
    EXPECT_EQ(answer.accepted, is_of_time || row.recording[0] == '+') << answer.reason;
  }
}

TEST(CommandTable, TheHostsRewindRunsASingleTickOfStoppedTime) {
  for (const CommandBody& body :
       {CommandBody(Rewind{2, 7}), CommandBody(ResetAll{}), CommandBody(Rewind{9, 7})}) {
    Asked asked(false, false, Role::host);
    asked.session().set_pace(0);
    EXPECT_EQ(asked.answer(body).accepted,
              body.index() != command_number<Rewind>() || std::get<Rewind>(body).body == 2);
    EXPECT_TRUE(asked.session().pacing().is_stopped()) << "the tick is over";
    EXPECT_EQ(asked.session().pacing().pace(), 0);
  }
}

}  // namespace
}  // namespace prosector
