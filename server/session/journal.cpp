#include "server/session/journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "common/error.h"
#include "server/session/input_bytes.h"

namespace prosector {
namespace {

// How much a crash of the machine may lose; a crash of the server alone loses at most this as well.
constexpr std::chrono::milliseconds batch_time{250};
constexpr std::uint64_t page_bytes = 4096;

constexpr const char* schema = R"(
  CREATE TABLE meta(key TEXT PRIMARY KEY, value BLOB) WITHOUT ROWID;
  CREATE TABLE tick(tick INTEGER PRIMARY KEY, state_hash INTEGER NOT NULL, input BLOB);
  CREATE TABLE checkpoint(tick INTEGER PRIMARY KEY, state BLOB NOT NULL);
  CREATE TABLE topology(tick INTEGER, body INTEGER, revision INTEGER, cause INTEGER, author INTEGER,
    piece_of INTEGER, content_hash INTEGER, surface_hash INTEGER, chain_hash INTEGER);
  CREATE TABLE event(tick INTEGER, what TEXT, participant INTEGER, name TEXT, detail TEXT);
)";

const char* event_name(SessionEvent::Kind kind) {
  switch (kind) {
    case SessionEvent::Kind::joined:
      return "joined";
    case SessionEvent::Kind::refused:
      return "refused";
    case SessionEvent::Kind::left:
      return "left";
    case SessionEvent::Kind::lost:
      return "lost";
    case SessionEvent::Kind::hand_timeout:
      return "hand timeout";
    case SessionEvent::Kind::role:
      return "role";
    case SessionEvent::Kind::let_go:
      return "let go";
    case SessionEvent::Kind::broke:
      return "broke";
    case SessionEvent::Kind::rewound:
      return "rewound";
  }
  return "unknown";
}

/// Write-ahead logging: a reader may look on, and a crash leaves a sound file.
void configure(SqliteDatabase& database, const JournalLimits& limits) {
  database.execute("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA busy_timeout=1000");
  if (limits.file_bytes > 0)
    database.execute(
        fmt::format("PRAGMA max_page_count={}", std::max<std::uint64_t>(limits.file_bytes / page_bytes, 8)));
}

void put_meta(SqliteDatabase& database, const std::string& key, const std::string& value) {
  SqliteStatement insert(database, "INSERT INTO meta VALUES(?,?)");
  insert.bind(0, key).bind(1, value).step();
}

std::uint64_t weight(const JournalTick& tick) {
  std::uint64_t states = 0;
  for (const CutEvent& e : tick.input.input.cuts) states += e.state ? e.state->size() : 0;
  return 128 + states + tick.checkpoint.size() +
         128 * (tick.input.input.events.size() + tick.input.input.targets.size()) + 1024 * tick.events.size();
}

}  // namespace

std::unique_ptr<Journal> Journal::create(const std::filesystem::path& file, const JournalHeader& header,
                                         const JournalLimits& limits) {
  if (std::filesystem::exists(file))
    throw InputError(
        fmt::format("--journal {}: exists already; name another file, or --resume it", file.string()));
  try {
    auto database = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::write);
    database->execute(fmt::format("PRAGMA page_size={}", page_bytes));
    configure(*database, limits);
    database->execute("BEGIN");
    database->execute(schema);
    put_meta(*database, "format", fmt::format("prosector journal {}", journal_version));
    put_meta(*database, "scene_file", std::filesystem::absolute(header.scene_file).string());
    put_meta(*database, "scene_text", header.scene_text);
    put_meta(*database, "session", header.session);
    put_meta(*database, "content_hash", to_hex(header.content_hash));
    put_meta(*database, "choices", encode(header.choices));
    database->execute("COMMIT");
    return std::unique_ptr<Journal>(new Journal(file, std::move(database), limits));
  } catch (const SqliteError& e) {
    throw InputError(fmt::format("--journal {}: {}", file.string(), e.what()));
  }
}

std::unique_ptr<Journal> Journal::append_to(const std::filesystem::path& file, const JournalLimits& limits) {
  try {
    auto database = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::write);
    configure(*database, limits);
    return std::unique_ptr<Journal>(new Journal(file, std::move(database), limits));
  } catch (const SqliteError& e) {
    throw InputError(fmt::format("--resume {}: {}", file.string(), e.what()));
  }
}

Journal::Journal(std::filesystem::path file, std::unique_ptr<SqliteDatabase> database,
                 const JournalLimits& limits)
    : file_(std::move(file)), limits_(limits), database_(std::move(database)), thread_([this] { run(); }) {}

Journal::~Journal() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Journal::append(JournalTick tick) {
  const std::lock_guard lock(mutex_);
  if (!trouble_.empty()) return;
  queued_bytes_ += weight(tick);
  if (queued_bytes_ > limits_.queue_bytes) return fail("the disk is too slow", tick.tick);
  queue_.push_back(std::move(tick));
}

std::string Journal::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void Journal::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait_for(lock, batch_time, [this] { return stop_; });
    const bool last = stop_;
    std::deque<JournalTick> batch;
    batch.swap(queue_);
    queued_bytes_ = 0;
    lock.unlock();
    std::string why;
    try {
      if (!batch.empty()) write(batch);
    } catch (const SqliteError& e) {
      why = e.what();
    }
    lock.lock();
    if (!why.empty()) fail(why, batch.front().tick);
    if (last || !trouble_.empty()) return;
  }
}

/// All of it or nothing: a file ends at a tick whose predecessors are all there.
void Journal::write(const std::deque<JournalTick>& batch) {
  database_->execute("BEGIN");
  try {
    SqliteStatement insert_tick(*database_, "INSERT INTO tick VALUES(?,?,?)");
    SqliteStatement insert_checkpoint(*database_, "INSERT OR REPLACE INTO checkpoint VALUES(?,?)");
    SqliteStatement insert_event(*database_, "INSERT INTO event VALUES(?,?,?,?,?)");
    SqliteStatement insert_topology(*database_, "INSERT INTO topology VALUES(?,?,?,?,?,?,?,?,?)");
    for (const JournalTick& t : batch) {
      insert_tick.bind(0, t.tick).bind(1, t.state_hash);
      insert_tick.bind(2, encode_input(t.input)).step();
      if (!t.checkpoint.empty()) insert_checkpoint.bind(0, t.tick).bind(1, t.checkpoint).step();
      for (const SessionEvent& e : t.events) {
        insert_event.bind(0, t.tick).bind(1, std::string(event_name(e.kind))).bind(2, e.participant);
        insert_event.bind(3, e.name).bind(4, e.detail).step();
      }
      for (const TopologyRevision& r : t.topology) {
        insert_topology.bind(0, t.tick).bind(1, std::uint64_t{r.body}).bind(2, std::uint64_t{r.revision});
        insert_topology.bind(3, static_cast<std::uint64_t>(r.cause)).bind(4, r.author);
        insert_topology.bind(5, static_cast<std::uint64_t>(std::int64_t{r.piece_of}));
        insert_topology.bind(6, r.content_hash).bind(7, r.surface_hash).bind(8, r.chain_hash).step();
      }
    }
    database_->execute("COMMIT");
  } catch (const SqliteError&) {
    try {
      database_->execute("ROLLBACK");
    } catch (const SqliteError&) {
      // SQLite rolls back by itself on some errors, a full disk among them.
    }
    throw;
  }
}

void Journal::fail(const std::string& why, std::uint64_t tick) {
  trouble_ = fmt::format("journal stopped at tick {}: {}", tick, why);
  queue_.clear();
}

}  // namespace prosector
