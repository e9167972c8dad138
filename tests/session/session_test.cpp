// Who may join, whose samples count, and when hands come and go: Session by itself, fed by hand.

#include "server/session/people/session.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "tests/session/session_room.h"

namespace prosector {
namespace {

using namespace test;

struct Refused {
  const char* what;
  std::function<void(Room&)> before;
  Presence presence;
  const char* reason;
};

TEST(Session, EveryRefusalSaysWhy) {
  Presence old = presence(9, "old");
  old.version = protocol_version + 1;
  const auto nobody = [](Room&) {};
  const auto full = [](Room& room) {
    for (ParticipantId id = 1; id <= 4; ++id)
      room.join(presence(id, std::string(1, 'p').append(std::to_string(id))), id);
  };
  const auto watched = [](Room& room) {
    for (ParticipantId id = 1; id <= 2; ++id)
      room.join(presence(id, std::string(1, 'o').append(std::to_string(id)), Role::observer), id);
  };
  const std::vector<Refused> table = {
      {"version", nobody, old, "protocol"},
      {"empty name", nobody, presence(9, ""), "name is needed"},
      {"blank name", nobody, presence(9, "  "), "name is needed"},
      {"control character", nobody, presence(9, "a\nb"), "control"},
      {"taken name", [](Room& room) { room.join(presence(1, "ada"), 1); }, presence(9, "ada"), "taken"},
      {"role", nobody, presence(9, "x", static_cast<Role>(7)), "role"},
      {"two hosts", [](Room& room) { room.join(presence(1, "ada", Role::host), 1); },
       presence(9, "x", Role::host), "already has a host"},
      {"full", full, presence(9, "x"), "full"},
      {"observers full", watched, presence(9, "x", Role::observer), "observer"},
  };
  for (const Refused& row : table) {
    SCOPED_TRACE(row.what);
    Room room;
    row.before(room);
    const auto members = room.session.roster().members().size();
    room.join(row.presence, 9);
    for (std::uint64_t i = 0; i < rules().death_timeout; ++i) room.feed({});
    const CommandResult result = room.results.back();
    EXPECT_FALSE(result.accepted);
    EXPECT_NE(result.reason.find(row.reason), std::string::npos) << result.reason;
    EXPECT_EQ(room.session.roster().members().size(), members);
  }
}

TEST(Session, WhoWasKilledAndComesBackAtOnceIsLetInOnceItsDeathIsKnown) {
  for (const Role role : {Role::dissector, Role::host}) {
    Room room;
    room.join(presence(1, "ada", role), 1);
    room.feed({from(9, presence(9, "ada", role)), from(9, command(9, Join{}))});
    for (int i = 0; i < 3; ++i) room.feed({});
    EXPECT_EQ(room.results.size(), 1u) << room.results.back().reason;
    room.feed({from(1, presence(1, "ada", role), Liveness::gone)});
    ASSERT_EQ(room.results.size(), 2u);
    EXPECT_TRUE(room.results.back().accepted) << room.results.back().reason;
    EXPECT_EQ(room.session.roster().members().count(9), 1u);
  }
}

TEST(Session, ANameThatIsTakenIsRefusedHoweverOftenItIsAskedFor) {
  Room room;
  room.join(presence(1, "ada"), 1);
  for (std::uint64_t i = 0; i <= rules().death_timeout; ++i) room.join(presence(9, "ada"), 9);
  ASSERT_EQ(room.results.size(), 2u);
  EXPECT_FALSE(room.results.back().accepted);
  EXPECT_NE(room.results.back().reason.find("taken"), std::string::npos);
}

TEST(Session, PresenceAndJoinComeInEitherOrder) {
  Room room;
  room.feed({from(1, command(1, Join{}))});
  EXPECT_TRUE(room.results.empty());
  room.feed({from(1, presence(1, "ada"))});
  ASSERT_EQ(room.results.size(), 1u);
  EXPECT_TRUE(room.results[0].accepted);
  EXPECT_EQ(room.session.roster().members().size(), 1u);
}

TEST(Session, JoinWithoutPresenceIsRefusedAfterATime) {
  Room room;
  room.feed({from(1, command(1, Join{}))});
  for (int i = 0; i < 12; ++i) room.feed({});
  ASSERT_EQ(room.results.size(), 1u);
  EXPECT_FALSE(room.results[0].accepted);
}

TEST(Session, ColoursDifferAndAreFreedOnLeaving) {
  Room room;
  for (ParticipantId id = 1; id <= 3; ++id)
    room.join(presence(id, std::string(1, 'p').append(std::to_string(id))), id);
  const auto color = [&](ParticipantId id) {
    return Roster::entry(room.session.roster().members().at(id)).color;
  };
  EXPECT_NE(color(1), color(2));
  EXPECT_NE(color(2), color(3));
  const Vec3 second = color(2);
  room.feed({from(2, command(2, Leave{}, 2))});
  ASSERT_EQ(room.gone.size(), 1u);
  room.join(presence(5, "new"), 5);
  EXPECT_EQ(color(5), second);
}

TEST(Session, NewestInputIsConsumedOnceInIdOrder) {
  Room room;
  for (ParticipantId id : {3, 1, 2})
    room.join(presence(id, std::string(1, 'p').append(std::to_string(id))), id);
  const ConsumedInput in = room.feed({from(3, input(3, 1)), from(1, input(1, 4)), from(1, input(1, 6)),
                                      from(1, input(1, 5)), from(2, input(2, 1))});
  ASSERT_EQ(in.input.targets.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(in.input.targets[i].participant, i + 1);
    EXPECT_EQ(in.input.events[i].kind, HandEvent::Kind::appear);
  }
  EXPECT_EQ(in.input.targets[0].target.p.z(), 6);
  EXPECT_EQ(in.keys[0].sequence, 6u);
  EXPECT_TRUE(room.feed({}).input.targets.empty());
}

TEST(Session, PassesOnWhichHandsDrawCutsWhateverElseIsPressed) {
  Room room;
  room.join(presence(1, "ada"), 1);
  std::uint64_t number = 0;
  for (const std::uint32_t buttons : {0u, draws_cut, ~draws_cut, draws_cut | 1u, ~0u}) {
    HandInput sample = input(1, ++number);
    sample.hands[right_hand].buttons = buttons;
    const ConsumedInput in = room.feed({from(1, sample)});
    ASSERT_EQ(in.input.targets.size(), 1u);
    EXPECT_EQ(in.input.targets[0].draws, buttons >= draws_cut) << buttons;
  }
}

TEST(Session, HandVanishesAfterTheTimeoutInTicks) {
  Room room;
  room.join(presence(1, "ada"), 1);
  room.feed({from(1, input(1, 1))});
  std::uint64_t quiet = 0;
  ConsumedInput in;
  do {
    in = room.feed({from(1, input(1, 2 + quiet, false))});  // alive, but the tracker sees no hand
    ++quiet;
  } while (in.input.events.empty() && quiet < 100);
  EXPECT_EQ(quiet, rules().input_timeout + 1);
  EXPECT_EQ(in.input.events[0].kind, HandEvent::Kind::vanish);
  EXPECT_EQ(room.session.hand_timeouts(), 1u);
  in = room.feed({from(1, input(1, 500))});
  ASSERT_EQ(in.input.events.size(), 1u);
  EXPECT_EQ(in.input.events[0].kind, HandEvent::Kind::appear);
}

TEST(Session, LeavingAndLosingFreeEverything) {
  for (const bool lost : {false, true}) {
    Room room;
    room.join(presence(1, "ada"), 1);
    room.feed({from(1, input(1, 1))});
    const Received end = lost ? from(1, presence(1, ""), Liveness::gone) : from(1, command(1, Leave{}, 2));
    const ConsumedInput in = room.feed({end, from(1, input(1, 2))});
    ASSERT_EQ(in.input.events.size(), 1u);
    EXPECT_EQ(in.input.events[0].kind, HandEvent::Kind::vanish);
    EXPECT_TRUE(in.input.targets.empty());
    EXPECT_TRUE(room.session.roster().members().empty());
    EXPECT_EQ(room.gone.size(), 1u);
    EXPECT_EQ(room.session.output().dropped_total(), 0u);  // its last sample was under way: no offence
    EXPECT_TRUE(room.join(presence(2, "ada"), 2).accepted);
  }
}

TEST(Session, SamplesInAnothersNameAreDropped) {
  Room room;
  room.join(presence(1, "ada"), 1);
  const ConsumedInput in = room.feed({from(66, input(1, 9)), from(66, command(1, Leave{}, 7)),
                                      from(66, presence(1, "ada")), from(66, presence(1, ""), Liveness::gone),
                                      from(66, command(1, Join{}, 8)), from(66, input(5, 1))});
  EXPECT_TRUE(in.input.events.empty() && in.input.targets.empty());
  EXPECT_EQ(room.session.roster().members().size(), 1u);
  EXPECT_EQ(room.session.output().dropped_total(), 6u);
  EXPECT_EQ(room.results.size(), 1u);  // nothing is answered to whoever speaks in another's name
}

TEST(Session, WhatNoKnownProcessWroteIsDropped) {
  Room room;
  room.join(presence(1, "ada"), 1);
  const ConsumedInput in =
      room.feed({from(0, presence(1, ""), Liveness::gone), from(0, input(1, 9)), from(0, presence(2, "bob")),
                 from(0, command(2, Join{})), from(0, command(1, Leave{}, 2))});
  EXPECT_TRUE(in.input.events.empty() && in.input.targets.empty());
  EXPECT_EQ(room.session.roster().members().size(), 1u);
  EXPECT_EQ(room.session.output().dropped_total(), 5u);
}

TEST(Session, AVisitorsEndIsBelievedOfTheVisitorOnly) {
  Room room;
  room.feed(
      {from(1, command(1, Join{})), from(66, presence(1, ""), Liveness::gone), from(1, presence(1, "ada"))});
  EXPECT_EQ(room.session.roster().members().size(), 1u);
  EXPECT_EQ(room.session.output().dropped_total(), 1u);
}

TEST(Session, AnObserverChangesNothingAndIsTold) {
  Room room;
  room.join(presence(1, "eve", Role::observer), 1);
  for (const CommandBody& body : {CommandBody(Grasp{}), CommandBody(Release{}), CommandBody(ResetBody{})}) {
    const ConsumedInput in = room.feed({from(1, input(1, 1)), from(1, command(1, body, 2))});
    EXPECT_TRUE(in.input.events.empty() && in.input.targets.empty() && in.keys.empty());
    EXPECT_FALSE(room.results.back().accepted);
    EXPECT_NE(room.results.back().reason.find("observer"), std::string::npos);
  }
  EXPECT_EQ(room.session.output().dropped_total(), 6u);
}

TEST(Session, WhatIsAskedOfPartsIsAnsweredByTheStep) {
  Room room;
  room.join(presence(1, "ada"), 1);
  room.join(presence(2, "eve", Role::observer), 2);
  const Command detach = command(1, Detach{2}, 20), attach = command(1, Attach{2}, 21);
  const Command beyond = command(1, Inspect{3}, 22);
  const Command by_observer = command(2, Detach{}, 23);
  const ConsumedInput in = room.session.consume(
      std::vector<Received>{from(1, detach), from(1, beyond), from(1, attach), from(2, by_observer)},
      ++room.tick);
  ASSERT_EQ(in.input.parts.size(), 2u);
  EXPECT_EQ(in.input.parts[0].kind, PartEvent::Kind::detach);
  EXPECT_EQ(in.input.parts[1].kind, PartEvent::Kind::attach);
  StepReport report;
  report.part_answers = {{}, "too far"};
  room.session.finish_tick({}, report);
  std::map<std::uint64_t, CommandResult> answers;
  for (const Outgoing& o : room.session.output().take_outgoing())
    if (const auto* r = std::get_if<CommandResult>(&o.message)) answers[r->sequence] = *r;
  EXPECT_TRUE(answers.at(20).accepted);
  EXPECT_EQ(answers.at(21).reason, "too far");
  EXPECT_FALSE(answers.at(22).accepted);
  EXPECT_FALSE(answers.at(23).accepted);
}

TEST(Session, DissectorsUndoTheirOwnAndOnlyTheHostRewinds) {
  Room room;
  room.join(presence(1, "ada", Role::host), 1);
  room.join(presence(2, "bo"), 2);
  room.join(presence(3, "eve", Role::observer), 3);
  room.session.moments().keep(5, {{2, 6}, {1, 4}}, {1, 2});
  room.session.moments().keep(8, {{2, 7}}, {3, 4, 5});
  const Command rewind = command(1, Rewind{2, 7}, 20), of_later = command(1, Rewind{2, 9}, 26),
                of_no_body = command(1, Rewind{3, 7}, 21), by_dissector = command(2, Rewind{2, 7}, 22),
                by_observer = command(3, Undo{}, 24);
  const Command undo = command(2, Undo{}, 23);
  const ConsumedInput in = room.session.consume(
      std::vector<Received>{from(2, undo), from(1, rewind), from(1, of_no_body), from(1, of_later),
                            from(2, by_dissector), from(3, by_observer)},
      ++room.tick);
  ASSERT_EQ(in.input.cuts.size(), 2u);  // by participant
  EXPECT_EQ(in.input.cuts[0].kind, CutEvent::Kind::rewind);
  EXPECT_EQ(in.input.cuts[0].body, 2u);
  EXPECT_EQ(in.input.cuts[0].revision, 7u);
  ASSERT_TRUE(in.input.cuts[0].state);
  EXPECT_EQ(*in.input.cuts[0].state, (std::vector<std::uint8_t>{3, 4, 5}));
  EXPECT_EQ(in.input.cuts[1].kind, CutEvent::Kind::undo);
  EXPECT_EQ(in.input.cuts[1].participant, 2u);
  StepReport report;
  report.cut_answers = {{}, "a later cut depends on it"};
  room.session.finish_tick({}, report);
  std::map<std::uint64_t, CommandResult> answers;
  for (const Outgoing& o : room.session.output().take_outgoing())
    if (const auto* r = std::get_if<CommandResult>(&o.message)) answers[r->sequence] = *r;
  EXPECT_TRUE(answers.at(20).accepted);
  EXPECT_NE(answers.at(21).reason.find("no body 3"), std::string::npos);
  EXPECT_EQ(answers.at(22).reason, "only the host can rewind");
  EXPECT_EQ(answers.at(26).reason,
            "the state of revision 9 is no longer stored; revisions stored for this body: 6 to 7");
  EXPECT_EQ(answers.at(23).reason, "a later cut depends on it");
  EXPECT_FALSE(answers.at(24).accepted);

  Command again = undo;
  again.sequence = 25;
  room.feed({from(2, again)});  // a step that has no answer
  EXPECT_FALSE(room.results.back().accepted);
  EXPECT_FALSE(room.results.back().reason.empty());
}

TEST(Session, ObserversTooAskForKeyframes) {
  Room room;
  room.join(presence(3, "eve", Role::observer), 3);
  const Command ask = command(3, RequestKeyframe{1}, 9);
  room.feed({from(3, ask), from(3, ask)});
  EXPECT_TRUE(room.results.back().accepted);
  EXPECT_EQ(room.session.requests().take_keyframes(), (std::set<BodyId>{1}));
  EXPECT_TRUE(room.session.requests().take_keyframes().empty());
}

TEST(Session, PiecesAreBodiesThatCanBeAskedFor) {
  Room room;
  room.join(presence(1, "ada"), 1);
  Command reset = command(1, ResetBody{3}, 5);
  room.feed({from(1, reset)});
  EXPECT_FALSE(room.results.back().accepted);
  room.session.add_body("piece", true);
  reset.sequence = 6;
  room.feed({from(1, reset)});
  EXPECT_TRUE(room.results.back().accepted);
}

TEST(Session, CommandsAreAnsweredAndChecked) {
  Room room;
  room.join(presence(1, "ada"), 1);
  const auto ask = [&](Command c) {
    static std::uint64_t sequence = 10;
    c.sequence = ++sequence;
    const ConsumedInput in = room.feed({from(1, c)});
    EXPECT_EQ(room.results.back().sequence, sequence);
    return in.input.events;
  };
  EXPECT_TRUE(ask(command(1, Grasp{})).empty());  // no hand yet
  EXPECT_FALSE(room.results.back().accepted);
  EXPECT_TRUE(ask(command(1, Release{})).empty());
  EXPECT_TRUE(room.results.back().accepted) << "no hand holds nothing";
  room.feed({from(1, input(1, 1))});
  EXPECT_EQ(ask(command(1, Grasp{})).size(), 1u);
  EXPECT_EQ(room.results.back().reason, "nothing within reach");  // by what the hand holds after the step
  EXPECT_EQ(ask(command(1, Release{})).size(), 1u);
  EXPECT_TRUE(room.results.back().accepted);
  EXPECT_EQ(ask(command(1, ResetBody{2})).size(), 1u);
  EXPECT_TRUE(ask(command(1, ResetBody{3})).empty());
  EXPECT_NE(room.results.back().reason.find("no body 3"), std::string::npos);
  EXPECT_TRUE(ask(command(1, Grasp{2})).empty());
}

TEST(Session, WhoseHandLosesWhatItHeldIsToldAndWhoLetsGoIsNot) {
  for (const bool asked : {true, false}) {
    Room room;
    room.join(presence(1, "ada"), 1);
    room.feed({from(1, input(1, 1))});
    std::vector<Received> received;
    if (asked) received.push_back(from(1, command(1, Release{}, 2)));
    room.session.consume(received, ++room.tick);
    StepReport report;
    report.let_go.push_back({1, right_hand, 2, "knife was torn away by 80 N"});
    room.session.finish_tick({}, report);
    room.results.clear();
    room.feed({});
    std::vector<std::string> messages;
    for (const CommandResult& result : room.results)
      if (result.sequence == 0) messages.push_back(result.reason);
    EXPECT_EQ(messages.size(), asked ? 0U : 1U);
    for (const std::string& words : messages)
      EXPECT_EQ(words, "your hand released it: knife was torn away by 80 N");
  }
}

TEST(Session, AFloodOfStrangersIsCountedAndBounded) {
  Room room;
  std::vector<Received> flood;
  for (ParticipantId id = 1; id <= 5000; ++id) flood.push_back(from(id, command(id, Join{})));
  for (int i = 0; i < 5000; ++i) flood.push_back(from(1, command(2, ResetBody{})));
  room.feed(flood);
  EXPECT_GT(room.session.output().dropped_total(), 8000u);
  for (std::uint64_t i = 0; i < 20 * rules().presence_timeout; ++i) room.feed({});
  EXPECT_TRUE(room.join(presence(9999, "late but welcome"), 9999).accepted);
}

}  // namespace
}  // namespace prosector
