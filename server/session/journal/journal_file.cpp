#include "server/session/journal/journal_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "common/assert.h"
#include "common/server_run.h"
#include "server/session/journal/input_bytes.h"

namespace prosector {
namespace {

constexpr std::uint64_t page_bytes = 4096;
constexpr std::size_t part_bytes = std::size_t{256} * 1024;
constexpr int kept_between = 3;  // newest checkpoints that are kept in addition to the regular ones

constexpr const char* schema = R"(
  CREATE TABLE meta(key TEXT PRIMARY KEY, value BLOB) WITHOUT ROWID;
  CREATE TABLE tick(tick INTEGER PRIMARY KEY, state_hash INTEGER NOT NULL, input BLOB,
    rebuilt INTEGER NOT NULL, seal INTEGER NOT NULL);
  CREATE TABLE reign(reign INTEGER PRIMARY KEY);
  CREATE TABLE checkpoint(tick INTEGER PRIMARY KEY, parts INTEGER NOT NULL, seal INTEGER NOT NULL);
  CREATE TABLE checkpoint_part(tick INTEGER, part INTEGER, bytes BLOB NOT NULL, UNIQUE(tick, part));
  CREATE TABLE topology(tick INTEGER, body INTEGER, revision INTEGER, cause INTEGER, author INTEGER,
    piece_of INTEGER, content_hash INTEGER, surface_hash INTEGER, chain_hash INTEGER);
  CREATE TABLE event(tick INTEGER, what TEXT, participant INTEGER, name TEXT, detail TEXT);
  CREATE INDEX topology_by_tick ON topology(tick);
  CREATE INDEX event_by_tick ON event(tick);
)";

/// Runs `work` in a transaction. Commits it, or rolls it back if `work` throws.
template <class Work>
void in_one_go(SqliteDatabase& database, Work&& work) {
  database.execute("BEGIN");
  try {
    work();
    database.execute("COMMIT");
  } catch (const SqliteError&) {
    try {
      database.execute("ROLLBACK");
    } catch (const SqliteError&) {
      // After some errors, such as a full disk, SQLite has already rolled back.
    }
    throw;
  }
}

/// Sets write-ahead logging: others can read the file meanwhile, and a crash leaves it valid. Another
/// connection moves the log into the file (server/session/journal/wal_mover.h), since that waits for the
/// disk.
void configure(SqliteDatabase& database, std::uint64_t limit_bytes) {
  database.execute(
      "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA wal_autocheckpoint=0; "
      "PRAGMA busy_timeout=1000; PRAGMA secure_delete=OFF");
  if (limit_bytes > 0)
    database.execute(
        fmt::format("PRAGMA max_page_count={}", std::max<std::uint64_t>(limit_bytes / page_bytes, 8)));
}

std::string random_identity() {
  std::random_device entropy;
  return fmt::format("{:08x}{:08x}", entropy(), entropy());
}

void put_meta(SqliteDatabase& database, const std::string& key, const std::string& value) {
  SqliteStatement insert(database, "INSERT INTO meta VALUES(?,?)");
  insert.bind(0, key).bind(1, value).step();
}

std::string answer(SqliteDatabase& database, const std::string& question) {
  SqliteStatement query(database, question);
  query.step();
  return query.text(0);
}

}  // namespace

std::unique_ptr<JournalFile> JournalFile::create(const std::filesystem::path& file,
                                                 const JournalHeader& header, std::uint64_t limit_bytes) {
  auto database = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::write);
  database->execute(fmt::format("PRAGMA page_size={}", page_bytes));
  const std::array<std::string, journal_keys.size()> values = {
      fmt::format("prosector journal {}", journal_version),
      std::filesystem::absolute(header.scene_file).string(),
      header.scene_text,
      header.session,
      to_hex(header.content_hash),
      encode(header.choices),
      random_identity(),
      std::to_string(header.begins_at),
      std::string(header.beginning.begin(), header.beginning.end())};
  configure(*database, limit_bytes);
  in_one_go(*database, [&] {
    database->execute(schema);
    std::vector<std::pair<std::string, std::string>> description;
    for (std::size_t i = 0; i < journal_keys.size(); ++i) {
      put_meta(*database, journal_keys[i], values[i]);
      description.emplace_back(journal_keys[i], values[i]);
    }
    put_meta(*database, "seal", to_hex(seal_of(description)));
  });
  return std::unique_ptr<JournalFile>(new JournalFile(std::move(database)));
}

std::unique_ptr<JournalFile> JournalFile::reopen(const std::filesystem::path& file,
                                                 std::uint64_t limit_bytes) {
  auto database = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::write);
  configure(*database, limit_bytes);
  // Removes the parts of a checkpoint that a crash interrupted.
  database->execute("DELETE FROM checkpoint_part WHERE tick NOT IN (SELECT tick FROM checkpoint)");
  return std::unique_ptr<JournalFile>(new JournalFile(std::move(database)));
}

JournalFile::JournalFile(std::unique_ptr<SqliteDatabase> database) : database_(std::move(database)) {
  seal_ = std::stoull(answer(*database_, "SELECT value FROM meta WHERE key='seal'"), nullptr, 16);
  begin_reign();
  // The file is a valid journal from now on, even if its log is lost.
  database_->execute("PRAGMA wal_checkpoint(TRUNCATE)");
}

void JournalFile::begin_reign() {
  const std::string last = answer(*database_, "SELECT COALESCE(MAX(reign),0) FROM reign");
  reign_ = static_cast<std::uint32_t>(std::min<std::uint64_t>(std::stoull(last) + 1, last_reign));
  SqliteStatement(*database_, "INSERT OR REPLACE INTO reign VALUES(?)").bind(0, std::uint64_t{reign_}).step();
}

JournalFile::~JournalFile() {
  try {
    database_->execute("PRAGMA journal_mode=DELETE");
  } catch (const SqliteError&) {
    // A reader has the file open, or the disk is full. The log stays, and both together are complete.
  }
}

void JournalFile::write(const std::deque<JournalTick>& batch) {
  in_one_go(*database_, [&] {
    for (const JournalTick& tick : batch) insert(tick);
  });
}

void JournalFile::insert(const JournalTick& t) {
  const std::vector<std::uint8_t> input = encode_input(t.input);
  SqliteStatement insert_tick(*database_, "INSERT INTO tick VALUES(?,?,?,?,?)");
  insert_tick.bind(0, t.tick).bind(1, t.state_hash).bind(2, input);
  insert_tick.bind(3, std::uint64_t{t.rebuilt}).bind(4, seal_of(seal_, t, input)).step();
  for (const SessionEvent& e : t.events) {
    SqliteStatement insert_event(*database_, "INSERT INTO event VALUES(?,?,?,?,?)");
    insert_event.bind(0, t.tick).bind(1, event_name(e.kind)).bind(2, e.participant);
    insert_event.bind(3, e.name).bind(4, e.detail).step();
  }
  for (const TopologyRevision& r : t.topology) {
    SqliteStatement insert_topology(*database_, "INSERT INTO topology VALUES(?,?,?,?,?,?,?,?,?)");
    insert_topology.bind(0, t.tick).bind(1, std::uint64_t{r.body}).bind(2, std::uint64_t{r.revision});
    insert_topology.bind(3, static_cast<std::uint64_t>(r.cause)).bind(4, r.author);
    insert_topology.bind(5, static_cast<std::uint64_t>(std::int64_t{r.piece_of}));
    insert_topology.bind(6, r.content_hash).bind(7, r.surface_hash).bind(8, r.chain_hash).step();
  }
}

bool JournalFile::write_part(WaitingCheckpoint& c) {
  PROSECTOR_ASSERT(!c.state.empty() && c.parts * part_bytes < c.state.size() + part_bytes);
  const std::size_t parts = (c.state.size() + part_bytes - 1) / part_bytes;
  if (c.parts < parts) {
    const std::size_t begin = c.parts * part_bytes, size = std::min(part_bytes, c.state.size() - begin);
    SqliteStatement insert(*database_, "INSERT OR REPLACE INTO checkpoint_part VALUES(?,?,?)");
    insert.bind(0, c.tick).bind(1, std::uint64_t{c.parts}).bind(2, std::span(c.state).subspan(begin, size));
    insert.step();
    ++c.parts;
    return false;
  }
  in_one_go(*database_, [&] {
    SqliteStatement insert(*database_, "INSERT OR REPLACE INTO checkpoint VALUES(?,?,?)");
    insert.bind(0, c.tick).bind(1, std::uint64_t{parts});
    insert.bind(2, seal_of_checkpoint(seal_, c.tick, c.state)).step();
  });
  forget_old_checkpoints();
  return true;
}

/// Deletes checkpoints between the regular ones, except for the newest: only these shorten a resume.
void JournalFile::forget_old_checkpoints() {
  in_one_go(*database_, [&] {
    database_->execute(
        fmt::format("DELETE FROM checkpoint WHERE tick % {} <> 0 AND tick NOT IN "
                    "(SELECT tick FROM checkpoint ORDER BY tick DESC LIMIT {})",
                    checkpoint_ticks, kept_between));
    database_->execute(
        "DELETE FROM checkpoint_part WHERE tick < (SELECT MAX(tick) FROM checkpoint) AND "
        "tick NOT IN (SELECT tick FROM checkpoint)");
  });
}

}  // namespace prosector
