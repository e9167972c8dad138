// Messages in the picture: how long they stay, and what in a session becomes one.

#include <gtest/gtest.h>

#include <chrono>

#include "client/app/session/session_events.h"
#include "client/view/loading_screen.h"
#include "client/view/message_lines.h"
#include "common/surface_patch.h"

namespace prosector {
namespace {

using Lines = std::vector<std::string>;

TEST(MessageLines, StayForAsLongAsReadingTakesAndNoLonger) {
  for (const std::string& text : {std::string("Ada left"), std::string(100, 'x'), std::string(500, 'x')}) {
    MessageLines messages;
    messages.say(text, 10);
    const double time = MessageLines::reading_time(text);
    EXPECT_EQ(messages.shown(10 + time - 0.01), Lines{text});
    EXPECT_EQ(messages.shown(10 + time), Lines{});
    EXPECT_GE(time, 4);
    EXPECT_LE(time, 12);
  }
}

TEST(MessageLines, AreTwoAtATimeAndTheOthersWaitTheirTurn) {
  MessageLines messages;
  for (const char* text : {"a", "b", "c"}) messages.say(text, 0);
  EXPECT_EQ(messages.shown(0), (Lines{"a", "b"}));
  EXPECT_EQ(messages.shown(1.4), (Lines{"a", "b"}));
  EXPECT_EQ(messages.shown(1.5), (Lines{"b", "c"})) << "what was seen gives way";
  EXPECT_EQ(messages.shown(4.5), Lines{"c"});
  EXPECT_EQ(messages.shown(9), Lines{});
}

TEST(MessageLines, CountWhatIsSaidAgainInsteadOfRepeatingIt) {
  MessageLines messages;
  for (int k = 0; k < 50; ++k) messages.say("no", 0.1 * k);
  EXPECT_EQ(messages.shown(5), Lines{"no (50 times)"});
  EXPECT_EQ(messages.shown(4.9 + 4), Lines{});
}

TEST(MessageLines, SayHowManyAFloodLeftOut) {
  MessageLines messages;
  for (int k = 0; k < 100; ++k) messages.say("message " + std::to_string(k), 0);
  EXPECT_EQ(messages.shown(0), (Lines{"message 0", "message 1"}));
  const Lines later = messages.shown(5.5);
  ASSERT_EQ(later.size(), 2u);
  EXPECT_EQ(later[0], "message 92 (and 90 earlier)");
  for (int round = 0; round < 4; ++round) messages.shown(10 + 5 * round);
  EXPECT_EQ(messages.shown(40), Lines{});
}

// Nobody who holds something reads that out of a flood.
TEST(MessageLines, KeepALineForWhatTheUserDid) {
  MessageLines messages;
  for (int k = 0; k < 60; ++k)
    messages.say(k % 2 == 0 ? "the simulation has recovered" : "the disk is slow", 0.1 * k);
  messages.say("you hold the liver", 6, MessageKind::own);
  for (int k = 60; k < 90; ++k) {
    messages.say("message " + std::to_string(k), 0.1 * k);
    const Lines lines = messages.shown(0.1 * k);
    ASSERT_EQ(lines.size(), MessageLines::lines);
    EXPECT_EQ(lines.back(), "you hold the liver") << k;
  }
  EXPECT_EQ(messages.shown(10).size(), 2U) << "news have both lines again";
  EXPECT_NE(messages.shown(10).back(), "you hold the liver");
}

TEST(MessageLines, LetNewsWaitThatAnOwnMessageDisplacesTooSoon) {
  MessageLines messages;
  messages.say("Ada left", 0);
  messages.say("Grace left", 0.5);
  messages.say("you hold the liver", 1, MessageKind::own);
  EXPECT_EQ(messages.shown(1), (Lines{"Grace left", "you hold the liver"}));
  EXPECT_EQ(messages.shown(2), (Lines{"Ada left", "you hold the liver"})) << "seen for 1 s only";
}

TEST(LoadingPicture, IsFullAsFarAsThingsAreHere) {
  for (const double progress : {-1.0, 0.0, 0.25, 1.0, 7.0}) {
    const DrawList list = loading_picture("abdomen", "waiting", progress, 800, 600, 2);
    ASSERT_EQ(list.lines.size(), 2u);
    const double whole = list.lines[0].b.x() - list.lines[0].a.x();
    const double full = list.lines[1].b.x() - list.lines[1].a.x();
    EXPECT_NEAR(full / whole, std::clamp(progress, 0.0, 1.0), 1e-12);
    EXPECT_EQ(list.texts.at(0).text, "abdomen");
    EXPECT_EQ(list.texts.at(1).text, "waiting");
  }
}

// ---- What happened

/// A session of two bodies of which a client is told.
class Told : public testing::Test {
 protected:
  explicit Told(Catalogue language = {}) : words(std::move(language)) {}

  static constexpr ParticipantId self = 7, ada = 9;
  Replica replica;
  Catalogue words;
  SessionEvents session_events{self, words};
  SceneInfo scene;
  TriangleMesh surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  SparseMap map{{{{0, 1, 2, 3}, {1, 0, 0, 0}}, {{0, 1, 2, 3}, {0, 1, 0, 0}}, {{0, 1, 2, 3}, {0, 0, 1, 0}}}};
  std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Asset mesh = encode(surface), streamed = encode(StreamedSurface{points, map});

  void SetUp() override {
    say(SessionInfo{});
    add_body("liver");
    for (const Asset* asset : {&mesh, &streamed})
      say(AssetChunk{asset->hash, 0, 1, static_cast<std::uint32_t>(asset->bytes.size()), asset->bytes});
    join(self, "Me", Role::host);
    say(revision(0, 0, TopologyCause::compiled, 0));
  }
  void say(Message message) { replica.apply({.message = std::move(message)}); }
  void join(ParticipantId who, const std::string& name, Role role) {
    RosterEntry entry;
    entry.participant = who;
    entry.name = name;
    entry.role = role;
    say(entry);
  }
  void add_body(const std::string& name) {
    SceneBody body;
    body.name = name;
    body.kind = BodyKind::soft;
    body.mesh = mesh.hash;
    body.map = streamed.hash;
    body.points = 4;
    body.chunk_points = 4;
    scene.bodies.push_back(body);
    say(scene);
  }
  /// Makes a keyframe, which is shown without those before it.
  TopologyRevision revision(BodyId body, std::uint32_t number, TopologyCause cause, ParticipantId author,
                            std::int32_t piece_of = -1) const {
    TopologyRevision out;
    out.body = body;
    out.revision = number;
    out.cause = cause;
    out.author = author;
    out.piece_of = piece_of;
    out.mesh = mesh.hash;
    out.map = streamed.hash;
    out.surface_hash = hash(rounded(surface, {points, map}));
    out.chain_hash = chain_hash_of(out);
    return out;
  }
  /// Makes the liver's surface a strip with a cut along z = 0 that long, 20 mm deep.
  void lay_open(double length) {
    surface.positions = {{0, 0, 0}, {length, 0, 0}, {0, -0.02, 0}, {length, -0.02, 0},
                         {0, 0, 0}, {length, 0, 0}, {0, -0.02, 0}, {length, -0.02, 0},
                         {0, 0, 1}, {1, 0, 1},      {0, 0, -1},    {1, 0, -1}};
    surface.triangles = {{0, 8, 9}, {0, 9, 1}, {4, 5, 11}, {4, 11, 10},
                         {0, 1, 3}, {0, 3, 2}, {4, 6, 7},  {4, 7, 5}};
    surface.inner = {0, 0, 0, 0, 1, 1, 1, 1};
    map.rows.clear();
    points.resize(4);
    for (const Vec3& x : surface.positions) {
      map.rows.push_back({{static_cast<std::uint32_t>(points.size())}, {1}});
      points.push_back(x);
    }
    mesh = encode(surface);
    streamed = encode(StreamedSurface{points, map});
    for (const Asset* asset : {&mesh, &streamed})
      say(AssetChunk{asset->hash, 0, 1, static_cast<std::uint32_t>(asset->bytes.size()), asset->bytes});
  }
  Lines news(double now) {
    Lines out;
    for (const SessionMessage& happening : session_events.look(replica, now)) {
      out.push_back(happening.text);
      EXPECT_EQ(happening.kind == MessageKind::own,
                happening.text.starts_with("you ") || happening.text.starts_with("cut: "))
          << happening.text;
    }
    return out;
  }
};

TEST_F(Told, WhatWasThereAtTheFirstLookIsNoNews) {
  join(ada, "Ada", Role::dissector);
  ASSERT_NE(replica.bodies().topology(0), nullptr) << replica.missing();
  EXPECT_EQ(news(0), Lines{});
  EXPECT_EQ(news(1), Lines{});
}

TEST_F(Told, AStrokeIsToldWithItsLengthAndDepthWhenItHasEnded) {
  join(ada, "Ada", Role::dissector);
  news(0);
  lay_open(0.06);
  say(revision(0, 1, TopologyCause::cut, self));
  EXPECT_EQ(news(1), Lines{"you cut the liver"});
  lay_open(0.1);
  say(revision(0, 2, TopologyCause::cut, self));
  EXPECT_EQ(news(1.9), Lines{});
  EXPECT_EQ(news(2.8), Lines{}) << "it may go on";
  EXPECT_EQ(news(3), Lines{"cut: 100 mm long, 20 mm deep, in the liver"});
  lay_open(0.13);
  say(revision(0, 3, TopologyCause::cut, ada));
  EXPECT_EQ(news(4), Lines{"Ada cut the liver"});
  EXPECT_EQ(news(5.1), Lines{"Ada's cut: 30 mm long, in the liver"}) << "what was there isn't hers";
}

TEST_F(Told, WhoComesChangesRolesAndGoesIsTold) {
  news(0);
  join(ada, "Ada", Role::dissector);
  EXPECT_EQ(news(1), Lines{"Ada joined as a dissector"});
  join(ada, "Ada", Role::observer);
  EXPECT_EQ(news(2), Lines{"Ada is now an observer"});
  RosterEntry gone;
  gone.participant = ada;
  replica.apply({.message = gone, .liveness = Liveness::gone});
  EXPECT_EQ(news(3), Lines{"Ada left"});
}

TEST_F(Told, AStrokeIsToldOnceAndWhatIsTakenBackOnceMore) {
  join(ada, "Ada", Role::dissector);
  news(0);
  for (std::uint32_t k = 1; k <= 60; ++k) {
    say(revision(0, k, TopologyCause::cut, ada));
    EXPECT_EQ(news(k / 60.0), k == 1 ? Lines{"Ada cut the liver"} : Lines{}) << k;
  }
  say(revision(0, 61, TopologyCause::undo, self));
  EXPECT_EQ(news(1.1), Lines{"you undid a cut of the liver"});
  say(revision(0, 62, TopologyCause::cut, self));
  EXPECT_EQ(news(1.2), Lines{"you cut the liver"});
}

TEST_F(Told, APieceThatComesOffIsTold) {
  news(0);
  add_body("liver 2");
  say(revision(1, 0, TopologyCause::cut, self, 0));
  EXPECT_EQ(news(1), Lines{"a piece was separated from the liver"});
  EXPECT_EQ(news(2), Lines{});
}

TEST_F(Told, WhatTheUserTakesHoldOfIsToldAndWhatOthersTakeIsNot) {
  news(0);
  PartState part;
  part.holders = {{ada, right_hand}};
  say(part);
  EXPECT_EQ(news(1), Lines{});
  part.holders = {{self, right_hand}, {ada, right_hand}};
  say(part);
  EXPECT_EQ(news(2), Lines{"you hold the liver"});
  EXPECT_EQ(news(3), Lines{});
  part.holders.clear();
  say(part);
  EXPECT_EQ(news(4), Lines{});
}

TEST_F(Told, TroubleIsToldOnceHoweverItsFiguresChangeAndSoIsItsEnd) {
  news(0);
  ServerStatus status;
  const auto tell = [&](const std::string& degraded) {
    status.degraded = degraded;
    say(status);
  };
  tell("simulated time slowed to 0.75 of real time; liver reset: unfolded");
  EXPECT_EQ(news(1), (Lines{"simulated time slowed to 0.75 of real time", "liver reset: unfolded"}));
  tell("simulated time slowed to 0.61 of real time");
  EXPECT_EQ(news(2), Lines{});
  tell("liver not converged, kidney not converged, …");
  EXPECT_EQ(news(3), Lines{}) << "is everyday";
  tell("simulated time slowed to 0.97 of real time");
  EXPECT_EQ(news(3.5), Lines{}) << "nobody sees that";
  tell("");
  EXPECT_EQ(news(4), Lines{});
  EXPECT_EQ(news(5.5), Lines{"the simulation has recovered"});
  EXPECT_EQ(news(6), Lines{});
}

TEST_F(Told, TroubleThatComesAndGoesIsToldOnceAMinuteAndItsEndNotAlone) {
  news(0);
  Lines told;
  for (int k = 0; k < 900; ++k) {  // 90 s; 5 s of it, 12 s without
    ServerStatus status;
    if (k % 170 < 50)
      status.degraded = "simulated time slowed to 0.8" + std::to_string(k % 10) + " of real time";
    say(status);
    for (const std::string& line : news(1 + 0.1 * k)) told.push_back(line);
  }
  ASSERT_EQ(told.size(), 4U) << told.back();
  EXPECT_EQ(told[1], "the simulation has recovered");
  EXPECT_TRUE(told[2].starts_with("simulated time slowed"));
  EXPECT_EQ(told[3], "the simulation has recovered");
}

TEST_F(Told, WhatTheHostDoesWithTimeIsTold) {
  news(0);
  const auto at_pace = [&](double pace) {
    RoomState room;
    room.pace = pace;
    say(room);
    return news(1);
  };
  EXPECT_EQ(at_pace(0), Lines{"the host stopped time"});
  EXPECT_EQ(at_pace(0), Lines{});
  EXPECT_EQ(at_pace(0.25), Lines{"slow motion: time runs at 0.25 of real time"});
  EXPECT_EQ(at_pace(1), Lines{"time resumed"});
}

TEST_F(Told, ProgressGrowsToOneAsThingsArrive) {
  Replica fresh;
  std::vector<double> steps = {fresh.progress()};
  const auto take = [&](Message message) {
    fresh.apply({.message = std::move(message)});
    steps.push_back(fresh.progress());
  };
  take(SessionInfo{});
  take(scene);
  for (const Asset* asset : {&mesh, &streamed})
    take(AssetChunk{asset->hash, 0, 1, static_cast<std::uint32_t>(asset->bytes.size()), asset->bytes});
  take(revision(0, 0, TopologyCause::compiled, 0));
  SoftState state;
  state.chunk = 0;
  state.positions = points;
  state.velocities.assign(4, Vec3::Zero());
  take(state);
  EXPECT_TRUE(std::ranges::is_sorted(steps));
  EXPECT_EQ(steps.front(), 0);
  EXPECT_LT(steps[steps.size() - 2], 1);
  EXPECT_EQ(steps.back(), 1) << fresh.missing();
}

class GermanMessages : public Told {
 protected:
  GermanMessages() : Told(catalogue_for("de")) {}
  std::string told(double now) {
    std::string out;
    for (const SessionMessage& happening : session_events.look(replica, now)) out += happening.text + "\n";
    return out;
  }
};

TEST_F(GermanMessages, HappeningsAreGerman) {
  told(0);
  join(ada, "Ada", Role::observer);
  EXPECT_EQ(told(1), "Ada ist dabei als Zuschauer\n");
  join(ada, "Ada", Role::dissector);
  EXPECT_EQ(told(2), "Ada ist jetzt Präparator\n");
  say(revision(0, 1, TopologyCause::cut, ada));
  EXPECT_EQ(told(3), "Ada hat geschnitten: liver\n");
  say(revision(0, 2, TopologyCause::undo, self));
  EXPECT_EQ(told(30), "eigener Schnitt zurückgenommen: liver\n");
}

TEST_F(GermanMessages, SlowedTimeIsGermanAndOtherTroublesAreTheServers) {
  told(0);
  ServerStatus status;
  status.degraded = "simulated time slowed to 0.75 of real time; liver reset: unfolded";
  say(status);
  EXPECT_EQ(told(1), "simulierte Zeit auf 0.75 der Echtzeit verlangsamt\nliver reset: unfolded\n");
}

TEST(MessageLines, CountInTheUsersLanguage) {
  MessageLines messages{catalogue_for("tr")};
  for (int k = 0; k < 3; ++k) messages.say("el: yeniden izleniyor", 0);
  EXPECT_EQ(messages.shown(0), Lines{"el: yeniden izleniyor (3 kez)"});
}

}  // namespace
}  // namespace prosector
