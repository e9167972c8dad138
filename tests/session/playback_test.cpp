// A recorded session that is watched: every state is the recorded one, wherever people go in it, and whoever
// looks on sees it so.

#include "server/session/run/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "common/error.h"
#include "tests/session/dissection.h"
#include "tests/session/recorded.h"
#include "tests/session/temporary_file.h"

namespace prosector {
namespace {

using test::cut_body;
using test::Dissection;
using test::Guest;
using test::Hosted;
using test::tender;
using test::Tissue;

/// A host who cuts a cut_body in two, on file.
class Recorded {
 public:
  Recorded() : file_("playback") {
    const Simulation compiled(tender(Tissue::block), test::options());
    const auto journal = Journal::create(file_.path, test::header_of(compiled), JournalLimits{});
    Dissection room(journal.get(), Tissue::block);
    before_the_cut = room.hosted.simulation.time().tick;
    while (room.at.x() < 0.13) room.run(1, 0.0016);
    after_the_cut = room.hosted.simulation.time().tick;
    room.run(30);
    // What is built anew in the background may come later on a busy machine, and the half with it.
    for (int i = 0; i < 1500 && room.hosted.simulation.body_count() < 3; ++i) room.run(1);
    EXPECT_EQ(room.hosted.simulation.body_count(), 3u) << "nothing came off";
    room.hosted.loop.finish();
  }
  const std::filesystem::path& file() const { return file_.path; }

  std::uint64_t before_the_cut = 0, after_the_cut = 0;  // ticks

 private:
  test::TemporaryFile file_;
};

/// The recording, with those who watch it.
struct Watched {
  explicit Watched(const std::filesystem::path& file)
      : journal(file),
        network(LocalNetworkConfig{}),
        simulation(tender(Tissue::block), test::options()),
        bus(network.join(Hosted::config(BusEnd::server))),
        playback({journal, simulation}, *bus, "prosector",
                 [this](const std::string& line) { log.push_back(line); }),
        eve(guest(7)) {}

  Guest guest(ParticipantId id) {
    Guest out;
    out.bus = network.join(Hosted::config(BusEnd::observer));
    out.id = id;
    return out;
  }
  void turn(int times = 1) {
    for (int i = 0; i < times; ++i) {
      playback.turn();
      playback.publisher().flush();
      network.advance(std::chrono::microseconds(16667));
      eve.take();
    }
  }
  void come() {
    eve.greet("eve", Role::observer);
    turn(2);
  }
  /// Asks, and returns the answer.
  CommandResult ask(Guest& who, const CommandBody& body) {
    who.command(body);
    for (int i = 0; i < 5 && (who.results.empty() || who.results.back().sequence != who.sequence); ++i) {
      turn();
      who.take();
    }
    return who.results.empty() ? CommandResult{} : who.results.back();
  }
  /// Goes to a tick and stands there for long enough that everybody has it.
  void go_to(std::uint64_t wanted) {
    EXPECT_TRUE(ask(eve, SetPace{0}).accepted);
    EXPECT_TRUE(ask(eve, Seek{static_cast<std::uint32_t>(wanted)}).accepted);
    for (int i = 0; i < 1000 && tick() != wanted; ++i) turn();
    EXPECT_EQ(tick(), wanted);
    turn(2);
  }
  std::uint64_t tick() const { return simulation.time().tick; }

  JournalReader journal;
  LocalNetwork network;
  Simulation simulation;
  std::unique_ptr<Bus> bus;
  std::vector<std::string> log;
  Playback playback;
  Guest eve;
};

class PlayedSession : public testing::Test {
 protected:
  static const Recorded& recorded() {
    static const Recorded once;
    return once;
  }
  Watched watched{recorded().file()};
  std::uint64_t last = watched.playback.player().last_tick();

  /// Expects that a tick is as it was recorded, and that `guest` sees it so.
  void expect_as_recorded(std::uint64_t tick, Guest& guest) {
    SCOPED_TRACE(tick);
    EXPECT_EQ(watched.simulation.state_hash(), watched.journal.state_hash(tick));
    EXPECT_FALSE(watched.playback.player().differs());
    ASSERT_TRUE(guest.replica.complete()) << guest.replica.missing();
    for (BodyId body = cut_body; body < watched.simulation.body_count(); ++body)
      EXPECT_LT(test::error(watched.simulation, guest, body), 1e-4) << "body " << body;
    for (BodyId body = static_cast<BodyId>(watched.simulation.body_count());
         body < guest.replica.scene()->bodies.size(); ++body)
      EXPECT_TRUE(std::ranges::all_of(guest.replica.bodies().soft(body)->rest().triangles,
                                      [](const auto& corners) { return corners[0] == corners[1]; }))
          << "body " << body << " is not there yet";
    EXPECT_EQ(guest.replica.refused(), 0u);
  }
};

TEST_F(PlayedSession, BeginsWithWhoComesAndStandsAtItsEnd) {
  watched.turn(5);
  EXPECT_EQ(watched.tick(), 0u) << "nobody is here";
  watched.come();
  ASSERT_TRUE(watched.eve.replica.recording());
  EXPECT_EQ(watched.eve.replica.recording()->last_tick, last);
  EXPECT_EQ(watched.eve.replica.time().pace(), 1);
  watched.turn(static_cast<int>(last) + 10);
  EXPECT_EQ(watched.tick(), last);
  EXPECT_EQ(watched.eve.replica.time().pace(), 0);
  expect_as_recorded(last, watched.eve);
  EXPECT_TRUE(watched.ask(watched.eve, SetPace{1}).accepted);
  watched.turn(3);
  EXPECT_LT(watched.tick(), 10u) << "whoever goes on at the end begins again";
}

TEST_F(PlayedSession, IsAsRecordedWhereverPeopleGo) {
  watched.come();
  for (const std::uint64_t tick :
       {recorded().after_the_cut, recorded().before_the_cut, std::uint64_t{0}, recorded().before_the_cut + 40,
        last, std::uint64_t{1}, recorded().after_the_cut, recorded().after_the_cut - 20}) {
    watched.go_to(tick);
    if (tick > 0) expect_as_recorded(tick, watched.eve);
  }
  Guest late = watched.guest(8);
  late.greet("late", Role::observer);
  for (int i = 0; i < 40; ++i) {
    watched.turn();
    late.take();
  }
  expect_as_recorded(recorded().after_the_cut - 20, late);
}

TEST_F(PlayedSession, GoesOnFromWhereItWasSought) {
  watched.come();
  watched.go_to(recorded().after_the_cut);
  watched.go_to(recorded().before_the_cut);
  EXPECT_TRUE(watched.ask(watched.eve, SetPace{1}).accepted);
  while (watched.tick() < last) watched.turn();
  watched.turn(2);
  expect_as_recorded(last, watched.eve);
}

TEST_F(PlayedSession, ShowsThePeopleWhoWereThere) {
  watched.come();
  watched.go_to(recorded().after_the_cut);
  const auto& roster = watched.eve.replica.roster();
  ASSERT_TRUE(roster.contains(1));
  EXPECT_EQ(roster.at(1).name, "ada");
  EXPECT_EQ(roster.at(1).role, Role::host);
  const auto ada = watched.eve.replica.user(1, static_cast<double>(watched.tick()));
  ASSERT_TRUE(ada);
  EXPECT_TRUE(ada->hands[right_hand].tracked);
  EXPECT_LT((ada->hands[right_hand].pose.p - watched.simulation.hands()[0].pose.p).norm(), 1e-4);
  watched.go_to(0);
  EXPECT_FALSE(watched.eve.replica.roster().contains(1)) << "not here yet";
  EXPECT_TRUE(watched.eve.replica.roster().contains(7));
}

TEST_F(PlayedSession, MarksWhatHappened) {
  watched.come();
  const auto& marks = watched.eve.replica.recording()->marks;
  const auto count = [&](MarkKind kind, const std::string& who) {
    return std::ranges::count_if(marks, [&](const auto& m) { return m.kind == kind && m.who == who; });
  };
  EXPECT_EQ(count(MarkKind::joined, "ada"), 1);
  EXPECT_EQ(count(MarkKind::joined, "eve"), 1) << "she who watched then";
  EXPECT_GE(count(MarkKind::cut, "ada"), 1);
  EXPECT_LE(count(MarkKind::cut, "ada"), 4) << "a stroke is one";
}

TEST_F(PlayedSession, IsWatchedOnlyAndTimeIsTheHostsWhereThereIsOne) {
  watched.come();
  EXPECT_EQ(watched.ask(watched.eve, Undo{}).reason, "this is a recording: it cannot be changed");
  EXPECT_NE(watched.ask(watched.eve, SetPace{2 * max_pace}).reason, "");
  EXPECT_TRUE(watched.ask(watched.eve, SetPace{max_pace}).accepted);
  Guest bo = watched.guest(9), teacher = watched.guest(10);
  bo.greet("bo", Role::dissector);
  watched.turn(3);
  EXPECT_EQ(watched.eve.replica.roster().at(9).role, Role::observer);
  teacher.greet("teacher", Role::host);
  watched.turn(3);
  EXPECT_EQ(watched.ask(watched.eve, Seek{5}).reason,
            "only the host can move to another position of the recording");
  EXPECT_NE(watched.ask(watched.eve, SetPace{0}).reason, "");
  EXPECT_TRUE(watched.ask(teacher, Seek{5}).accepted);
}

TEST_F(PlayedSession, StepsTickByTick) {
  watched.come();
  watched.go_to(10);
  EXPECT_TRUE(watched.ask(watched.eve, StepTicks{3}).accepted);
  watched.turn(6);
  EXPECT_EQ(watched.tick(), 13u);
}

/// Wherever in the file: refused in words, or the very same session.
TEST(DamagedRecording, IsRefusedOrPlaysAsRecorded) {
  const test::TemporaryFile file("played-flips");
  const std::uint64_t hash = test::record(file.path, 12);
  std::ifstream in(file.path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  std::mt19937_64 random(5);
  int refused = 0;
  Simulation simulation(test::hosted_scene(), test::options());
  const std::vector<std::uint8_t> beginning = simulation.save();
  for (int i = 0; i < 60; ++i) {
    std::string flipped = whole;
    const std::size_t at = random() % flipped.size();
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << random() % 8));
    std::ofstream(file.path, std::ios::binary) << flipped;
    simulation.restore(beginning);
    try {
      const JournalReader journal(file.path);
      const RecordingIndex index(journal, {});
      RecordingPlayer player(journal, simulation);
      while (!player.at_end()) player.step();
      EXPECT_TRUE(player.differs() || simulation.state_hash() == hash) << "byte " << at;
    } catch (const InputError& e) {
      EXPECT_STRNE(e.what(), "");
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(DamagedRecording, WithoutATickIsRefused) {
  const test::TemporaryFile file("no-tick");
  {
    (void)Journal::create(file.path, test::header_of(Simulation(test::hosted_scene(), test::options())), {});
  }
  EXPECT_THROW(RecordingIndex(JournalReader(file.path), {}), InputError);
}

}  // namespace
}  // namespace prosector
