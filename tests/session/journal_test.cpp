// What a journal keeps repeats the run bit for bit; what breaks the journal does not break the session.

#include "server/session/journal/journal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <thread>

#include "common/error.h"
#include "server/session/journal/input_bytes.h"
#include "server/session/journal/replay.h"
#include "tests/session/recorded.h"

namespace prosector {
namespace {

using test::Guest;
using test::header_of;
using test::Hosted;
using test::record;
using test::TemporaryFile;

ConsumedInput random_input(std::mt19937_64& random) {
  ConsumedInput out;
  std::normal_distribution<double> x;
  for (std::uint64_t i = 0; i < random() % 4; ++i) out.keys.push_back({random(), random()});
  for (std::uint64_t i = 0; i < random() % 3; ++i)
    out.input.efforts.push_back({static_cast<BodyId>(random() % 100), static_cast<int>(random() % 4)});
  for (std::uint64_t i = 0; i < random() % 4; ++i)
    out.input.events.push_back({static_cast<HandEvent::Kind>(random() % 5), random(), random() % 2,
                                static_cast<BodyId>(random() % 100)});
  for (std::uint64_t i = 0; i < random() % 3; ++i) {
    PartEvent e{static_cast<PartEvent::Kind>(random() % 9),
                random(),
                static_cast<BodyId>(random() % 100),
                {},
                x(random)};
    for (int k = 0; k < 9; ++k) e.shape.A(k / 3, k % 3) = x(random);
    e.shape.p = {x(random), x(random), x(random)};
    out.input.parts.push_back(e);
  }
  for (std::uint64_t i = 0; i < random() % 4; ++i) {
    HandTarget t;
    t.participant = random();
    t.hand = random() % 2;
    t.target = {Vec3(x(random), x(random), x(random)), Quat::UnitRandom()};
    for (double& f : t.flexion) f = x(random);
    t.draws = random() % 2 == 0;
    out.input.targets.push_back(t);
  }
  for (std::uint64_t i = 0; i < random() % 3; ++i)
    out.input.cuts.push_back({static_cast<CutEvent::Kind>(random() % 2), random(),
                              static_cast<BodyId>(random() % 100),
                              static_cast<std::uint32_t>(random() % 1000)});
  return out;
}

TEST(InputBytes, RoundTripBitForBit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const auto bytes = encode_input(random_input(random));
    EXPECT_EQ(encode_input(decode_input(bytes)), bytes);
  }
}

TEST(InputBytes, MutatedBytesAreRefusedOrAreAnInput) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    auto bytes = encode_input(random_input(random));
    if (bytes.empty()) continue;
    if (random() % 2 == 0) bytes.resize(random() % bytes.size());
    for (std::uint64_t k = 0; k < random() % 4 && !bytes.empty(); ++k)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    try {
      for (const HandTarget& t : decode_input(bytes).input.targets) EXPECT_TRUE(is_finite(t.target));
    } catch (const InputError&) {
    }
  }
}

TEST(Journal, ReplayIsEqualForAnyThreadCount) {
  const TemporaryFile file("replay");
  const std::uint64_t hash = record(file.path, 130, 1);
  const JournalReader journal(file.path);
  EXPECT_EQ(journal.last_tick(), 131u);  // and the one that ends it
  for (int threads : {1, 2}) {
    Simulation simulation(test::hosted_scene(), test::options(threads));
    const ReplayResult result = replay(journal, simulation, {});
    EXPECT_TRUE(result) << *result.first_difference;
    EXPECT_EQ(result.ticks, 131u);
    EXPECT_EQ(result.last_hash, hash);
  }
}

TEST(Journal, ReplayNamesTheFirstDifference) {
  const TemporaryFile original("original"), file("tampered");
  record(original.path, 30);
  {
    const auto journal =
        Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
    JournalReader(original.path).for_each_tick(0, [&](JournalTick tick) {
      tick.state_hash += tick.tick == 17;
      journal->append(std::move(tick));
      return true;
    });
  }
  Simulation simulation(test::hosted_scene(), test::options());
  const ReplayResult result = replay(JournalReader(file.path), simulation, {});
  EXPECT_FALSE(result);
  EXPECT_EQ(result.first_difference, 17u);
}

TEST(Journal, ReplayNamesTheFirstValueThatDiffers) {
  const TemporaryFile original("original"), file("moved");
  record(original.path, 30);
  Simulation moved(test::hosted_scene(), test::options());
  {
    const auto journal = Journal::create(file.path, header_of(moved), {});
    JournalReader(original.path).for_each_tick(0, [&](JournalTick tick) {
      TickInput input = tick.input.input;
      if (tick.tick == 12) input.targets.clear();
      moved.step(input);
      tick.state_hash = moved.state_hash();
      const bool last = tick.tick == 20;
      journal->append(std::move(tick), last ? moved.save() : std::vector<std::uint8_t>());
      return !last;
    });
  }
  Simulation simulation(test::hosted_scene(), test::options());
  const ReplayResult result = replay(JournalReader(file.path), simulation, {});
  EXPECT_EQ(result.first_difference, 12u);
  ASSERT_TRUE(result.differing_value);
  EXPECT_EQ(result.differing_value->tick, 20u);
  EXPECT_NE(result.differing_value->name.find("hand 0"), std::string::npos) << result.differing_value->name;
}

TEST(Journal, ReplayNamesARevisionThatWasNotMadeAgain) {
  const TemporaryFile file("revision");
  {
    record(file.path, 20);
    const auto journal = Journal::append_to(file.path, JournalLimits{});
    JournalTick tick;
    tick.tick = 22;
    TopologyRevision cut;
    cut.body = Hosted::liver;
    cut.revision = 1;
    cut.cause = TopologyCause::undo;
    cut.author = 0xfedcba9876543210;
    cut.content_hash = 12;
    cut.surface_hash = 13;
    cut.chain_hash = 14;
    tick.topology = {cut};
    journal->append(tick);
  }
  const JournalReader journal(file.path);
  std::vector<TopologyRevision> read;
  journal.for_each_tick(20, [&](const JournalTick& tick) {
    EXPECT_EQ(tick.topology.size(), tick.tick == 22 ? 1u : 0u);
    read = tick.topology;
    return true;
  });
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].body, BodyId{Hosted::liver});
  EXPECT_EQ(read[0].revision, 1u);
  EXPECT_EQ(read[0].cause, TopologyCause::undo);
  EXPECT_EQ(read[0].author, 0xfedcba9876543210);
  EXPECT_EQ(read[0].piece_of, -1);
  EXPECT_EQ(read[0].content_hash, 12u);
  EXPECT_EQ(read[0].surface_hash, 13u);
  EXPECT_EQ(read[0].chain_hash, 14u);
  Simulation simulation(test::hosted_scene(), test::options());
  EXPECT_EQ(replay(journal, simulation, {}).first_difference, 22u);
}

TEST(Journal, AnotherSceneIsRefused) {
  const TemporaryFile file("other");
  record(file.path, 5);
  SceneDesc other = test::hosted_scene();
  other.soft[0].material.youngs_modulus *= 2;
  Simulation simulation(other, test::options());
  EXPECT_THROW(replay(JournalReader(file.path), simulation, {}), InputError);
}

TEST(Journal, ResumeGoesOnAsIfNothingHadHappened) {
  const TemporaryFile file("resume");
  const std::uint64_t hash = record(file.path, 80);
  Simulation simulation(test::hosted_scene(), test::options());
  EXPECT_TRUE(resume(JournalReader(file.path), simulation, {}));
  EXPECT_EQ(simulation.state_hash(), hash);
  EXPECT_EQ(simulation.hands().size(), 1u);  // of a participant who is no longer there
  std::uint64_t end_hash = 0;
  {
    const auto journal = Journal::append_to(file.path, JournalLimits{});
    LocalNetwork network({});
    const auto bus = network.join(Hosted::config(BusEnd::server));
    ServerLoop loop(simulation, *bus, "prosector", journal.get(), [](const std::string&) {});
    for (int i = 0; i < 40; ++i) loop.tick();
    EXPECT_TRUE(simulation.hands().empty());
    loop.finish();
    end_hash = simulation.state_hash();
  }
  Simulation again(test::hosted_scene(), test::options());
  const ReplayResult result = replay(JournalReader(file.path), again, {});
  EXPECT_TRUE(result);
  EXPECT_EQ(result.last_hash, end_hash);
}

TEST(Journal, ASessionThatEndsWhileTimeIsStoppedHasTheEventsOfThatTime) {
  const TemporaryFile file("stopped");
  {
    const auto journal =
        Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
    Hosted hosted({}, journal.get());
    Guest ada = hosted.guest(1, BusEnd::dissector), eve = hosted.guest(2, BusEnd::observer);
    const auto turn = [&](int times) {
      for (int i = 0; i < times; ++i) {
        hosted.loop.turn();
        hosted.loop.publisher().flush();
        hosted.network.advance(std::chrono::microseconds(16667));
        ada.take();
      }
    };
    turn(1);
    ada.greet("ada", Role::host);
    turn(3);
    ada.command(SetPace{0});
    turn(5);
    eve.greet("eve", Role::observer);
    turn(5);
    ASSERT_TRUE(ada.replica.roster().contains(2));
    hosted.loop.finish();
  }
  const JournalReader journal(file.path);
  const std::vector<SessionEvent> events = journal.tick(journal.last_tick()).events;
  EXPECT_TRUE(std::ranges::any_of(events, [](const SessionEvent& event) { return event.name == "eve"; }));
}

TEST(Journal, AFullDiskStopsTheJournalNotTheSession) {
  const TemporaryFile file("full");
  JournalLimits limits;
  limits.file_bytes = 120 * 1024;
  const auto journal =
      Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), limits);
  Hosted hosted({}, journal.get());
  Guest ada = hosted.guest(1, BusEnd::dissector);
  ada.greet("ada", Role::dissector);
  std::uint64_t t = 0;
  while (journal->error().empty() && t < 20000) {
    ada.bus->publish(ada.hand_at({0.5, 0.5, 0.001 * static_cast<double>(t++ % 100)}));
    hosted.tick();
    ada.take();
  }
  EXPECT_NE(journal->error().find("full"), std::string::npos) << journal->error();
  const auto before = hosted.simulation.time().tick;
  for (int i = 0; i < 30; ++i) hosted.tick();
  EXPECT_EQ(hosted.simulation.time().tick, before + 30);
  EXPECT_NE(hosted.loop.status().degraded.find("journal stopped"), std::string::npos);
  EXPECT_TRUE(std::any_of(hosted.log.begin(), hosted.log.end(), [](const std::string& line) {
    return line.find("journal stopped") != std::string::npos;
  }));
  // What was written is sound.
  Simulation simulation(test::hosted_scene(), test::options());
  EXPECT_TRUE(replay(JournalReader(file.path), simulation, {}));
}

TEST(Journal, FilesThatAreNoJournalAreRefused) {
  const TemporaryFile file("garbage");
  EXPECT_THROW(JournalReader{file.path}, InputError);
  std::ofstream(file.path)
      << "not a journal at all, but long enough to look like some file that somebody named";
  EXPECT_THROW(JournalReader{file.path}, InputError);
  EXPECT_THROW(Journal::create(file.path, {}, {}), InputError);    // never overwrites
  EXPECT_THROW(Journal::create("/dev/full", {}, {}), InputError);  // nor a device
  EXPECT_THROW(Journal::create("/nowhere/at/all.db", {}, {}), InputError);
  std::filesystem::remove(file.path);
  SqliteDatabase(file.path, SqliteDatabase::Mode::write).execute("CREATE TABLE meta(key TEXT, value BLOB)");
  EXPECT_THROW(JournalReader{file.path}, InputError);
}

}  // namespace
}  // namespace prosector
