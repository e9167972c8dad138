// What a journal says is proven before it is used, wherever it lies and whatever happened to it.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "common/error.h"
#include "server/session/journal/replay.h"
#include "tests/random.h"
#include "tests/session/recorded.h"

namespace prosector {
namespace {

using test::Guest;
using test::header_of;
using test::Hosted;
using test::TemporaryFile;

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A run whose ticks seem to take 0.15 s each, so that it keeps a checkpoint every seven.
std::uint64_t record_slow(const std::filesystem::path& file, int ticks) {
  Simulation simulation(test::hosted_scene(), test::options());
  const auto journal = Journal::create(file, header_of(simulation), {});
  LocalNetwork network({});
  const auto bus = network.join(Hosted::config(BusEnd::server));
  Guest ada;
  ada.bus = network.join(Hosted::config(BusEnd::dissector));
  ada.id = 1;
  ada.greet("ada", Role::dissector);
  std::int64_t now = 0;
  LoopOptions options;
  options.clock = [&] { return now += 150'000'000; };
  ServerLoop loop(
      simulation, *bus, "prosector", journal.get(), [](const std::string&) {}, options);
  for (int t = 0; t < ticks; ++t) {
    ada.bus->publish(ada.hand_at(test::press(static_cast<std::uint64_t>(t))));
    loop.tick();
  }
  return simulation.state_hash();
}

struct Resumed {
  std::optional<std::uint64_t> hash;  // none: refused
  std::vector<std::string> said;
};

Resumed resumed(const std::filesystem::path& file) {
  Resumed out;
  Simulation simulation(test::hosted_scene(), test::options());
  try {
    const auto say = [&](const std::string& line) { out.said.push_back(line); };
    if (resume(JournalReader(file), simulation, say)) out.hash = simulation.state_hash();
  } catch (const InputError& e) {
    out.said.emplace_back(e.what());
  }
  return out;
}

bool says(const Resumed& resumed, const std::string& what) {
  return std::ranges::any_of(resumed.said,
                             [&](const std::string& line) { return line.find(what) != line.npos; });
}

TEST(JournalDamage, CheckpointsComeOftenEnoughToResumeInASecond) {
  const TemporaryFile file("often");
  record_slow(file.path, 60);
  const std::vector<std::uint64_t> ticks = JournalReader(file.path).checkpoint_ticks();
  ASSERT_FALSE(ticks.empty());
  EXPECT_GE(ticks.front(), 53u);
  EXPECT_LE(ticks.size(), 3u);  // older ones make room
  Simulation simulation(test::hosted_scene(), test::options());
  EXPECT_TRUE(replay(JournalReader(file.path), simulation, {}));
}

TEST(JournalDamage, AFlippedBitOfACheckpointGoesBackToTheOneBefore) {
  const TemporaryFile file("checkpoint");
  const std::uint64_t hash = record_slow(file.path, 40);
  const std::string newest = std::to_string(JournalReader(file.path).checkpoint_ticks().front());
  std::mt19937_64 random(5);
  for (int i = 0; i < 12; ++i) {
    SqliteDatabase database(file.path, SqliteDatabase::Mode::write);
    SqliteStatement query(database, "SELECT bytes FROM checkpoint_part WHERE part=0 AND tick=" + newest);
    ASSERT_TRUE(query.step());
    const std::vector<std::uint8_t> whole = query.bytes(0);
    EXPECT_FALSE(query.step());
    const auto put = [&](const std::vector<std::uint8_t>& bytes) {
      SqliteStatement update(database, "UPDATE checkpoint_part SET bytes=? WHERE part=0 AND tick=" + newest);
      update.bind(0, bytes).step();
    };
    std::vector<std::uint8_t> flipped = whole;
    const std::size_t at = random() % flipped.size();
    flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ (1 << random() % 8));
    put(flipped);
    const Resumed result = resumed(file.path);
    EXPECT_EQ(result.hash, hash) << "byte " << at;
    EXPECT_TRUE(says(result, "the checkpoint of tick " + newest + " is damaged")) << "byte " << at;
    put(whole);
  }
  EXPECT_TRUE(resumed(file.path).said.empty());
}

TEST(JournalDamage, WithoutAnyGoodCheckpointTheSessionIsRunFromItsBeginning) {
  const TemporaryFile file("none");
  const std::uint64_t hash = record_slow(file.path, 30);
  SqliteDatabase(file.path, SqliteDatabase::Mode::write).execute("UPDATE checkpoint SET seal = seal + 1");
  EXPECT_EQ(resumed(file.path).hash, hash);
}

TEST(JournalDamage, WhatAJournalSaysOfATickIsRefusedWhereItWasChanged) {
  const char* const changes[] = {
      "UPDATE tick SET state_hash = state_hash + 1 WHERE tick = 17",
      "UPDATE tick SET input = x'00' WHERE tick = 17",
      "UPDATE tick SET rebuilt = 1 - rebuilt WHERE tick = 17",
      "INSERT INTO event VALUES(17, 'left', 1, 'ada', '')",
      "INSERT INTO topology VALUES(17, 2, 1, 0, 0, -1, 0, 0, 0)",
      "UPDATE tick SET seal = (SELECT seal FROM tick WHERE tick = 16) WHERE tick = 17"};
  for (const char* change : changes) {
    const TemporaryFile file("tick");
    test::record(file.path, 30);
    SqliteDatabase(file.path, SqliteDatabase::Mode::write).execute(change);
    Simulation simulation(test::hosted_scene(), test::options());
    try {
      replay(JournalReader(file.path), simulation, {});
      ADD_FAILURE() << change;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("tick 17 is damaged"), std::string::npos) << e.what();
    }
  }
  const TemporaryFile file("meta");
  test::record(file.path, 5);
  SqliteDatabase(file.path, SqliteDatabase::Mode::write)
      .execute("UPDATE meta SET value = 'name = \"hosted!\"' WHERE key = 'scene_text'");
  EXPECT_THROW(JournalReader{file.path}, InputError);
}

/// Wherever in the file: refused, or the very same state.
TEST(JournalDamage, NoFlippedBitOfTheFileResumesIntoAnotherState) {
  const TemporaryFile file("flips");
  const std::uint64_t hash = record_slow(file.path, 20);
  const std::string whole = read(file.path);
  std::mt19937_64 random(11);
  int refused = 0;
  for (int i = 0; i < 120; ++i) {
    std::string flipped = whole;
    const std::size_t at = random() % flipped.size();
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << random() % 8));
    std::ofstream(file.path, std::ios::binary) << flipped;
    const Resumed result = resumed(file.path);
    EXPECT_EQ(result.hash.value_or(hash), hash) << "byte " << at;
    EXPECT_TRUE(result.hash || !result.said.empty()) << "byte " << at;
    refused += !result.hash;
  }
  EXPECT_GT(refused, 0);
}

/// Returns the file as broken disks and careless copies leave it: bytes changed, lost, doubled or zeroed,
/// pages exchanged, its end cut off.
std::string mutated(std::string file, std::mt19937_64& random) {
  constexpr std::size_t page = 4096;
  for (std::size_t edits = 1 + random() % 3; edits > 0 && file.size() > 2 * page; --edits) {
    const std::size_t at = random() % (file.size() - page), many = 1 + random() % (2 * page);
    const std::size_t other = random() % (file.size() / page) * page, own = at / page * page;
    switch (random() % 6) {
      case 0:
        for (std::size_t k = at; k < at + page; k += 1 + random() % page)
          file[k] = static_cast<char>(random());
        break;
      case 1:
        file.erase(at, many);
        break;
      case 2:
        file.insert(at, file.substr(random() % file.size(), many));
        break;
      case 3:
        std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(at), page, '\0');
        break;
      case 4:
        for (std::size_t k = 0; k < page; ++k) std::swap(file[own + k], file[other + k]);
        break;
      case 5:
        file.resize(at + page);
        break;
    }
  }
  return file;
}

/// A damaged journal is refused, resumes into the very same state, or says what it lacks.
void try_mutants(unsigned seed, std::size_t count) {
  const TemporaryFile file("mutants");
  const std::uint64_t hash = record_slow(file.path, 20);
  const std::string whole = read(file.path);
  std::mt19937_64 random(seed);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::ofstream(file.path, std::ios::binary) << mutated(whole, random);
    const Resumed result = resumed(file.path);
    EXPECT_TRUE(result.hash == hash || !result.said.empty()) << "mutant " << i << " of seed " << seed;
    refused += !result.hash;
  }
  EXPECT_GT(refused, count / 4);
}

TEST(JournalMutants, OfAFixedSeed) {
  try_mutants(20261128, 40);
}

// The nightly run's: PROSECTOR_MUTANTS of them.
TEST(JournalMutants, OfAnySeed) {
  try_mutants(test_seed(false), number("PROSECTOR_MUTANTS", 2000));
}

/// SQLite takes a log up to its first damaged frame, and says nothing.
TEST(JournalDamage, AFlippedBitOfTheLogIsSaidAndWhatCameBeforeItIsKept) {
  const TemporaryFile file("log"), copy("log-copy");
  const auto journal =
      Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
  Hosted hosted({}, journal.get());
  for (int i = 0; i < 20; ++i) hosted.tick();
  ASSERT_TRUE(journal->settle());
  const std::string log = read(file.path.string() + "-wal");
  std::filesystem::copy_file(file.path, copy.path);
  const auto put = [&](const std::string& bytes) {
    std::filesystem::remove(copy.path.string() + "-shm");
    std::ofstream(copy.path.string() + "-wal", std::ios::binary) << bytes;
  };
  put(log);
  EXPECT_EQ(JournalReader(copy.path).last_tick(), 20u);
  EXPECT_EQ(JournalReader(copy.path).error(), "");
  std::mt19937_64 random(23);
  for (int i = 0; i < 30; ++i) {
    std::string flipped = log;
    const std::size_t at = random() % (flipped.size() - 4096 - 24);  // the last frame's loss costs one tick
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << random() % 8));
    put(flipped);
    const JournalReader reader(copy.path);
    EXPECT_NE(reader.error().find("-wal is damaged"), std::string::npos) << "byte " << at;
    Simulation simulation(test::hosted_scene(), test::options());
    EXPECT_TRUE(replay(reader, simulation, {})) << "byte " << at;
  }
  // Half a tick, as a crash leaves it, is no damage.
  put(log.substr(0, log.size() - 1000));
  EXPECT_EQ(JournalReader(copy.path).error(), "");
}

/// A folder that only root may write, seen by somebody else while it lives (tests run as root or not).
class AnothersFolder {
 public:
  explicit AnothersFolder(const std::filesystem::path& path) : path_(path) {
    std::filesystem::create_directories(path);
  }
  ~AnothersFolder() {
    if (getuid() == 0) {
      EXPECT_EQ(seteuid(0), 0);
    }
    std::filesystem::permissions(path_, std::filesystem::perms::all);
    std::filesystem::remove_all(path_);
  }
  void lock() const {
    using std::filesystem::perms;
    const perms all_read = perms::owner_read | perms::group_read | perms::others_read;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      std::filesystem::permissions(entry.path(), all_read);
    std::filesystem::permissions(path_,
                                 all_read | perms::owner_exec | perms::group_exec | perms::others_exec);
    if (getuid() == 0) {
      ASSERT_EQ(seteuid(65534), 0);
    }
  }

 private:
  std::filesystem::path path_;
};

TEST(JournalPlace, IsReadByOthersAndWhereNothingCanBeWritten) {
  const TemporaryFile file("place");
  const std::filesystem::path folder = file.path.string() + ".folder";
  const AnothersFolder place(folder);
  const auto journal =
      Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
  Hosted hosted({}, journal.get());
  for (int i = 0; i < 20; ++i) hosted.tick();
  // While it is written, and as a crash would leave it.
  std::filesystem::copy_file(file.path, folder / "whole");
  std::filesystem::copy_file(file.path.string() + "-wal", folder / "whole-wal");
  std::filesystem::copy_file(file.path, folder / "without its log");
  place.lock();
  const JournalReader whole(folder / "whole"), alone(folder / "without its log");
  EXPECT_EQ(whole.last_tick(), 20u);
  EXPECT_EQ(whole.error(), "");
  EXPECT_EQ(alone.header().session, "prosector");
  EXPECT_NE(alone.error().find("-wal is not in the same folder"), std::string::npos) << alone.error();
}

TEST(JournalPlace, EndsAsOneFileThatIsReadAnywhere) {
  const TemporaryFile file("end");
  const std::filesystem::path folder = file.path.string() + ".folder";
  const AnothersFolder place(folder);
  test::record(file.path, 20);
  EXPECT_FALSE(std::filesystem::exists(file.path.string() + "-wal"));
  std::filesystem::copy_file(file.path, folder / "whole");
  place.lock();
  EXPECT_EQ(JournalReader(folder / "whole").last_tick(), 21u);
  EXPECT_EQ(JournalReader(folder / "whole").error(), "");
}

TEST(JournalPlace, IsExportedWholeWhileItIsWritten) {
  const TemporaryFile file("live"), exported("exported");
  const auto journal =
      Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
  Hosted hosted({}, journal.get());
  for (int i = 0; i < 20; ++i) hosted.tick();
  JournalReader(file.path).export_to(exported.path);
  EXPECT_FALSE(std::filesystem::exists(exported.path.string() + "-wal"));
  Simulation simulation(test::hosted_scene(), test::options());
  const ReplayResult result = replay(JournalReader(exported.path), simulation, {});
  EXPECT_TRUE(result);
  EXPECT_EQ(result.ticks, 20u);
  EXPECT_EQ(result.last_hash, hosted.simulation.state_hash());
  EXPECT_THROW(JournalReader(file.path).export_to(exported.path), InputError);  // never overwrites
}

TEST(JournalPlace, IsWrittenByOneServerAtATime) {
  const TemporaryFile file("claimed");
  {
    const auto journal =
        Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
    EXPECT_THROW(Journal::append_to(file.path, {}), InputError);
  }
  EXPECT_NE(Journal::append_to(file.path, {}), nullptr);
}

TEST(JournalPace, WhatATickShowedIsInTheFile) {
  const TemporaryFile file("pace");
  const auto journal =
      Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
  Hosted hosted({}, journal.get());
  const JournalReader reader(file.path);
  int in_file_at_once = 0;
  for (std::uint64_t t = 1; t <= 30; ++t) {
    hosted.tick();
    in_file_at_once += reader.last_tick() == t;
    while (!journal->settle()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(reader.last_tick(), t);
  }
  EXPECT_GT(in_file_at_once, 20);  // a busy machine may hold up some
}

TEST(JournalPace, ADiskThatWaitsHoldsUpOneTickAndIsSaid) {
  const TemporaryFile file("waits");
  const auto journal =
      Journal::create(file.path, header_of(Simulation(test::hosted_scene(), test::options())), {});
  Hosted hosted({}, journal.get());
  hosted.tick();
  SqliteDatabase other(file.path, SqliteDatabase::Mode::write);
  other.execute("BEGIN IMMEDIATE");  // nobody else writes until this ends
  const std::int64_t begin = monotonic_ns();
  for (int i = 0; i < 5; ++i) hosted.tick();
  EXPECT_LT(monotonic_ns() - begin, 500'000'000);
  EXPECT_NE(hosted.loop.status().degraded.find("journal writing is behind"), std::string::npos);
  other.execute("COMMIT");
  for (int i = 0; i < 1000 && !journal->settle(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  hosted.tick();
  EXPECT_EQ(hosted.loop.status().degraded.find("journal"), std::string::npos);
  EXPECT_EQ(JournalReader(file.path).last_tick(), 7u);
  EXPECT_TRUE(std::ranges::any_of(hosted.log, [](const std::string& line) {
    return line.find("the journal has caught up") != line.npos;
  }));
}

}  // namespace
}  // namespace prosector
