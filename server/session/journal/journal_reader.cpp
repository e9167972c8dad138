#include "server/session/journal/journal_reader.h"

#include <fmt/format.h>

#include "common/error.h"
#include "server/session/journal/input_bytes.h"
#include "server/session/journal/readable_database.h"
#include "server/session/journal/wal_check.h"

namespace prosector {

JournalReader::JournalReader(const std::filesystem::path& file) : file_(file) {
  if (!std::filesystem::is_regular_file(file)) refuse("no such file");
  const bool no_log = log_is_missing(file), damaged_log = log_is_damaged(file.string() + "-wal");
  try {
    database_ = open_to_read(file);
    read_description();
    // A damaged page may hide the last rows, whose absence would not be noticed otherwise.
    SqliteStatement check(*database_, "PRAGMA quick_check('tick')");
    if (!check.step() || check.text(0) != "ok") refuse(fmt::format("is damaged ({})", check.text(0)));
    if (no_log || damaged_log)
      error_ = fmt::format("journal {}: its write-ahead log {} {}: data after tick {} is lost", file.string(),
                           file.filename().string() + "-wal",
                           no_log ? "is not in the same folder as the journal" : "is damaged", last_tick());
  } catch (const SqliteError& e) {
    refuse(fmt::format("is not a journal ({})", e.what()));
  }
}

void JournalReader::read_description() {
  const std::string format = meta("format"), wanted = fmt::format("prosector journal {}", journal_version);
  if (format != wanted) refuse(fmt::format("is a \"{}\", this version reads \"{}\"", format, wanted));
  std::vector<std::pair<std::string, std::string>> description;
  for (const char* key : journal_keys) description.emplace_back(key, meta(key));
  seal_ = seal_of(description);
  if (meta("seal") != to_hex(seal_)) refuse("its description is damaged");
  header_.scene_file = meta("scene_file");
  header_.scene_text = meta("scene_text");
  header_.session = meta("session");
  content_hash_ = meta("content_hash");
  header_.choices = decode_choices(meta("choices"));
  header_.begins_at = std::stoull(meta("begins_at"));
  const std::string beginning = meta("beginning");
  header_.beginning.assign(beginning.begin(), beginning.end());
}

std::uint64_t JournalReader::last_tick() const {
  SqliteStatement query(*database_, "SELECT COALESCE(MAX(tick),0) FROM tick");
  query.step();
  return query.number(0);
}

std::vector<std::uint64_t> JournalReader::checkpoint_ticks() const {
  std::vector<std::uint64_t> out;
  try {
    SqliteStatement query(*database_, "SELECT tick FROM checkpoint ORDER BY tick DESC");
    while (query.step()) out.push_back(query.number(0));
  } catch (const SqliteError&) {
    // Returns the ticks that could be listed.
  }
  return out;
}

std::optional<Checkpoint> JournalReader::checkpoint(std::uint64_t tick) const {
  try {
    SqliteStatement row(*database_, "SELECT parts, seal FROM checkpoint WHERE tick=?");
    if (!row.bind(0, tick).step()) return std::nullopt;
    SqliteStatement parts(*database_, "SELECT bytes FROM checkpoint_part WHERE tick=? ORDER BY part");
    parts.bind(0, tick);
    Checkpoint out{tick, {}};
    std::uint64_t count = 0;
    for (; parts.step(); ++count) {
      const std::vector<std::uint8_t> bytes = parts.bytes(0);
      out.state.insert(out.state.end(), bytes.begin(), bytes.end());
    }
    if (count != row.number(0) || seal_of_checkpoint(seal_, tick, out.state) != row.number(1))
      return std::nullopt;
    return out;
  } catch (const SqliteError&) {
    return std::nullopt;
  }
}

std::uint64_t JournalReader::state_hash(std::uint64_t tick) const {
  return this->tick(tick).state_hash;
}

JournalTick JournalReader::tick(std::uint64_t tick) const {
  std::optional<JournalTick> out;
  for_each_tick(tick - 1, [&](const JournalTick& t) {
    out = t;
    return false;
  });
  if (!out) refuse(fmt::format("tick {} is missing", tick));
  return *out;
}

std::vector<TopologyRevision> JournalReader::topology(std::uint64_t tick) const {
  SqliteStatement query(*database_,
                        "SELECT body, revision, cause, author, piece_of, content_hash, surface_hash, "
                        "chain_hash FROM topology WHERE tick=? ORDER BY rowid");
  query.bind(0, tick);
  std::vector<TopologyRevision> out;
  while (query.step()) {
    TopologyRevision& r = out.emplace_back();
    r.body = static_cast<BodyId>(query.number(0));
    r.revision = static_cast<std::uint32_t>(query.number(1));
    r.cause = static_cast<TopologyCause>(query.number(2));
    r.author = query.number(3);
    r.piece_of = static_cast<std::int32_t>(query.number(4));
    r.content_hash = query.number(5);
    r.surface_hash = query.number(6);
    r.chain_hash = query.number(7);
  }
  return out;
}

std::vector<SessionEvent> JournalReader::events(std::uint64_t tick) const {
  SqliteStatement query(*database_,
                        "SELECT what, participant, name, detail FROM event WHERE tick=? ORDER BY rowid");
  query.bind(0, tick);
  std::vector<SessionEvent> out;
  while (query.step()) {
    const auto kind = event_kind(query.text(0));
    if (!kind) refuse(fmt::format("tick {} is damaged", tick));
    out.push_back({*kind, query.number(1), query.text(2), query.text(3)});
  }
  return out;
}

void JournalReader::for_each_tick(std::uint64_t after,
                                  const std::function<bool(const JournalTick&)>& visit) const {
  std::uint64_t expected = after + 1;
  try {
    SqliteStatement query(
        *database_, "SELECT tick, state_hash, input, rebuilt, seal FROM tick WHERE tick>? ORDER BY tick");
    query.bind(0, after);
    while (query.step()) {
      JournalTick tick;
      tick.tick = query.number(0);
      if (tick.tick != expected) refuse(fmt::format("tick {} is missing", expected));
      tick.state_hash = query.number(1);
      tick.rebuilt = query.number(3) != 0;
      tick.topology = topology(tick.tick);
      tick.events = events(tick.tick);
      const std::vector<std::uint8_t> input = query.bytes(2);
      if (seal_of(seal_, tick, input) != query.number(4)) refuse(fmt::format("tick {} is damaged", expected));
      tick.input = decode_input(input);
      if (!visit(tick)) return;
      ++expected;
    }
  } catch (const SqliteError& e) {
    refuse(fmt::format("is damaged at tick {} ({})", expected, e.what()));
  }
}

void JournalReader::export_to(const std::filesystem::path& file) const {
  if (std::filesystem::exists(file))
    throw InputError(fmt::format("{}: the file already exists; choose another file for the exported journal",
                                 file.string()));
  try {
    SqliteStatement vacuum(*database_, "VACUUM INTO ?");
    vacuum.bind(0, file.string()).step();
  } catch (const SqliteError& e) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    throw InputError(fmt::format("{}: cannot be written ({})", file.string(), e.what()));
  }
}

std::string JournalReader::meta(const std::string& key) const {
  SqliteStatement query(*database_, "SELECT value FROM meta WHERE key=?");
  if (!query.bind(0, key).step()) refuse(fmt::format("has no {}", key));
  return query.text(0);
}

void JournalReader::refuse(const std::string& why) const {
  throw InputError(fmt::format("journal {}: {}", file_.string(), why));
}

}  // namespace prosector
