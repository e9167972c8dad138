// What a hand holds while its client sends nothing, and what becomes of it when the client is back.

#include <gtest/gtest.h>

#include "server/session/journal/journal_reader.h"
#include "server/session/journal/replay.h"
#include "server/session/people/session.h"
#include "tests/session/recorded.h"

namespace prosector {
namespace {

using test::Guest;
using test::Hosted;

constexpr std::uint64_t tracked_for = 5, silent_for = 20, remembered_for = 40;  // ticks
constexpr BodyId scalpel = 1;
constexpr ParticipantId ada = 1;

SessionRules rules() {
  SessionRules out;
  out.input_timeout = tracked_for;
  out.stall_timeout = silent_for;
  out.regrasp_timeout = remembered_for;
  out.names = {"table", "scalpel"};
  out.bodies = 2;
  return out;
}

/// A session with ada in it, whose hand holds the scalpel where a test says so.
class Room {
 public:
  Room() {
    Presence presence;
    presence.participant = ada;
    presence.name = "ada";
    presence.role = Role::dissector;
    presence_ = presence;
    join();
  }
  void join() { feed({presence_, ask(Join{})}); }
  void lose_connection() { feed({presence_}, Liveness::gone); }

  std::vector<HandEvent> feed(const std::vector<Message>& messages, Liveness liveness = Liveness::alive) {
    std::vector<Received> received;
    for (const Message& message : messages) {
      Received& r = received.emplace_back();
      r.message = message;
      r.writer = 7;
      r.liveness = liveness;
    }
    const std::vector<HandEvent> events = session_.consume(received, ++tick_).input.events;
    StepReport report;
    std::vector<HandState> hands = others;
    for (const HandEvent& event : events) {
      if (event.kind == HandEvent::Kind::vanish && holds)
        report.let_go.push_back({ada, right_hand, scalpel, "its hand is gone"});
      if (event.kind == HandEvent::Kind::vanish) holds = false;
      if (event.kind == HandEvent::Kind::regrasp) holds = within_reach;
    }
    if (holds) hands.push_back({ada, right_hand, {}, {}, scalpel, {}});
    session_.finish_tick(hands, report);
    for (const Outgoing& out : session_.output().take_outgoing())
      if (const auto* words = std::get_if<CommandResult>(&out.message); words && words->sequence == 0)
        reasons.push_back(words->reason);
    return events;
  }
  /// Feeds nothing for so many ticks; returns what happened.
  std::vector<HandEvent> be_silent(std::uint64_t ticks) {
    std::vector<HandEvent> out;
    for (std::uint64_t i = 0; i < ticks; ++i)
      for (const HandEvent& event : feed({})) out.push_back(event);
    return out;
  }
  Message hand(bool tracked = true) {
    HandInput out;
    out.participant = ada;
    out.sequence = ++sequence_;
    out.hands[right_hand].tracked = tracked;
    return out;
  }
  static Message ask(const CommandBody& body) { return Command{ada, 1, body}; }
  const Session& session() const { return session_; }

  bool holds = false, within_reach = true;
  std::vector<HandState> others;
  std::vector<std::string> reasons;

 private:
  Session session_{rules()};
  Presence presence_;
  std::uint64_t tick_ = 0, sequence_ = 0;
};

std::vector<HandEvent::Kind> kinds(const std::vector<HandEvent>& events) {
  std::vector<HandEvent::Kind> out;
  for (const HandEvent& event : events) out.push_back(event.kind);
  return out;
}

using Kinds = std::vector<HandEvent::Kind>;
using Kind = HandEvent::Kind;
using Words = std::vector<std::string>;

TEST(Stall, KeepsTheHandAndItsHoldUntilItsLimit) {
  Room room;
  room.feed({room.hand()});
  room.holds = true;
  EXPECT_TRUE(room.be_silent(silent_for).empty()) << "longer than an untracked hand stays";
  EXPECT_TRUE(room.feed({room.hand()}).empty()) << "as if nothing had been";
  EXPECT_TRUE(room.holds);
  EXPECT_TRUE(room.reasons.empty());

  EXPECT_EQ(kinds(room.be_silent(silent_for + 1)), Kinds{Kind::vanish});
  EXPECT_EQ(room.reasons, Words{"your hand released the scalpel: your client sent nothing for too long"});
  EXPECT_EQ(room.session().hand_timeouts(), 1U);
}

TEST(Stall, IsNotAHandThatItsClientNoLongerSees) {
  Room room;
  room.feed({room.hand()});
  room.holds = true;
  for (std::uint64_t i = 0; i < tracked_for; ++i) EXPECT_TRUE(room.feed({room.hand(false)}).empty());
  EXPECT_EQ(kinds(room.feed({room.hand(false)})), Kinds{Kind::vanish});
  EXPECT_EQ(room.reasons, Words{"your hand released the scalpel: your hand was no longer tracked"});
  EXPECT_EQ(kinds(room.feed({room.hand()})), Kinds{Kind::appear}) << "it may be an open one";
}

TEST(Stall, LeavesAHandThatItEndsUntrackedItsTime) {
  Room room;
  room.feed({room.hand()});
  room.be_silent(silent_for - 1);
  for (std::uint64_t i = 0; i < tracked_for; ++i) EXPECT_TRUE(room.feed({room.hand(false)}).empty()) << i;
  EXPECT_EQ(kinds(room.feed({room.hand(false)})), Kinds{Kind::vanish});
}

TEST(Stall, GivesBackWhatNobodyElseTook) {
  Room room;
  room.feed({room.hand()});
  room.holds = true;
  room.be_silent(silent_for + 1);
  room.reasons.clear();
  const std::vector<HandEvent> events = room.feed({room.hand()});
  ASSERT_EQ(kinds(events), (Kinds{Kind::appear, Kind::regrasp}));
  EXPECT_EQ(events[1].body, scalpel);
  EXPECT_TRUE(room.reasons.empty());
  EXPECT_TRUE(room.feed({room.hand()}).empty()) << "once";
}

TEST(Stall, TellsOfWhatCannotBeGivenBack) {
  for (const bool taken : {false, true}) {
    Room room;
    room.feed({room.hand()});
    room.holds = true;
    room.be_silent(silent_for + 1);
    room.reasons.clear();
    room.within_reach = false;
    if (taken) room.others = {{2, left_hand, {}, {}, scalpel, {}}};
    room.be_silent(1);
    room.feed({room.hand()});
    EXPECT_EQ(room.reasons, Words{taken ? "another hand took the scalpel"
                                        : "the scalpel is out of your hand's reach: grasp it again"});
  }
}

TEST(Stall, GivesNothingBackThatTheUserLetGoOrAfterLong) {
  for (const CommandBody& body : {CommandBody(Release{}), CommandBody(Grasp{})}) {
    Room room;
    room.feed({room.hand()});
    room.holds = true;
    room.be_silent(silent_for + 1);
    EXPECT_EQ(kinds(room.feed({Room::ask(body), room.hand()})), Kinds{Kind::appear});
  }
  Room room;
  room.feed({room.hand()});
  room.holds = true;
  room.be_silent(silent_for + remembered_for + 2);
  EXPECT_EQ(kinds(room.feed({room.hand()})), Kinds{Kind::appear});
}

TEST(Stall, OfALeaseThatRanOutGivesBackToWhoJoinsAgain) {
  Room room;
  room.feed({room.hand()});
  room.holds = true;
  room.lose_connection();
  EXPECT_FALSE(room.holds);
  room.join();
  EXPECT_EQ(room.reasons, Words{"your connection was lost, and your hand released the scalpel"});
  EXPECT_EQ(kinds(room.feed({room.hand()})), (Kinds{Kind::appear, Kind::regrasp}));
  EXPECT_TRUE(room.holds);
}

TEST(Stall, KeepsNothingOfWhoLeft) {
  Room room;
  room.feed({room.hand()});
  room.holds = true;
  room.feed({Room::ask(Leave{})});
  room.join();
  EXPECT_EQ(kinds(room.feed({room.hand()})), Kinds{Kind::appear});
}

// A session with a stall within the limit and one beyond it, with an organ in the hand.
TEST(Stall, OfAHostedHandReplaysEqual) {
  const test::TemporaryFile file("stall");
  {
    const auto journal = Journal::create(
        file.path, test::header_of(Simulation(test::hosted_scene(), test::options())), JournalLimits{});
    Hosted hosted({}, journal.get());
    Guest guest = hosted.guest(1, BusEnd::dissector);
    guest.greet("ada", Role::dissector);
    const auto holds = [&] {
      const auto hands = hosted.simulation.hands();
      return hands.size() == 1 && hands[0].holding == Hosted::liver;
    };
    for (std::uint64_t t = 0; t <= 80; ++t) {
      guest.bus->publish(guest.hand_at(test::press(t)));
      if (t == 70) guest.command(Grasp{});
      hosted.tick();
    }
    ASSERT_TRUE(holds());
    for (int i = 0; i < 240; ++i) hosted.tick();  // 4 s
    EXPECT_TRUE(holds());
    for (int i = 0; i < 70; ++i) hosted.tick();
    EXPECT_TRUE(hosted.simulation.hands().empty());
    for (int i = 0; i < 3; ++i) {
      guest.bus->publish(guest.hand_at(test::press(80)));
      hosted.tick();
    }
    EXPECT_TRUE(holds());
    hosted.loop.finish();
  }
  const JournalReader journal(file.path);
  Simulation simulation(test::hosted_scene(), test::options());
  const ReplayResult result = replay(journal, simulation, {});
  EXPECT_TRUE(result) << *result.first_difference;
  EXPECT_EQ(result.ticks, 395U);
}

TEST(SequenceGate, TakesNewerSamplesAndLeavesOvertakenOnes) {
  SequenceGate gate;
  using Verdict = SequenceGate::Verdict;
  EXPECT_EQ(gate.judge(0), Verdict::newer);
  EXPECT_EQ(gate.judge(5), Verdict::newer);
  EXPECT_EQ(gate.judge(5), Verdict::overtaken);
  EXPECT_EQ(gate.judge(4), Verdict::overtaken);
  EXPECT_EQ(gate.judge(6), Verdict::newer);
}

// One damaged datagram has a number far ahead: its stream must not be silent for ever.
TEST(SequenceGate, StartsAnewBehindANumberThatRanAhead) {
  Room room;
  room.feed({room.hand()});
  Message damaged = room.hand();
  std::get<HandInput>(damaged).sequence = ~std::uint64_t{0};
  room.feed({damaged});
  std::uint64_t ignored = 0;
  while (ignored < 1000 && room.session().output().dropped_total() == 0) {
    room.feed({room.hand()});
    ++ignored;
  }
  EXPECT_EQ(ignored, SequenceGate::max_overtaken);
  EXPECT_EQ(room.session().output().dropped().at("HandInput: numbering restarted"), 1U);
  EXPECT_LT(room.session().newest_input(ada)->sequence, 1000U);
}

}  // namespace
}  // namespace prosector
