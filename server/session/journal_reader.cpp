#include "server/session/journal_reader.h"

#include <fmt/format.h>

#include "common/error.h"
#include "server/session/input_bytes.h"

namespace prosector {

JournalReader::JournalReader(const std::filesystem::path& file) : file_(file) {
  if (!std::filesystem::is_regular_file(file)) refuse("no such file");
  try {
    database_ = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::read);
    const std::string format = meta("format"), wanted = fmt::format("prosector journal {}", journal_version);
    if (format != wanted) refuse(fmt::format("is a \"{}\", this version reads \"{}\"", format, wanted));
    header_.scene_file = meta("scene_file");
    header_.scene_text = meta("scene_text");
    header_.session = meta("session");
    content_hash_ = meta("content_hash");
    header_.choices = decode_choices(meta("choices"));
  } catch (const SqliteError& e) {
    refuse(fmt::format("is no journal ({})", e.what()));
  }
}

std::uint64_t JournalReader::last_tick() const {
  SqliteStatement query(*database_, "SELECT COALESCE(MAX(tick),0) FROM tick");
  query.step();
  return query.number(0);
}

std::optional<Checkpoint> JournalReader::last_checkpoint() const {
  SqliteStatement query(*database_, "SELECT tick, state FROM checkpoint ORDER BY tick DESC LIMIT 1");
  if (!query.step()) return std::nullopt;
  return Checkpoint{query.number(0), query.bytes(1)};
}

bool JournalReader::has_checkpoint(std::uint64_t tick) const {
  SqliteStatement query(*database_, "SELECT 1 FROM checkpoint WHERE tick=?");
  return query.bind(0, tick).step();
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

void JournalReader::for_each_tick(std::uint64_t after,
                                  const std::function<bool(const JournalTick&)>& visit) const {
  try {
    SqliteStatement query(*database_, "SELECT tick, state_hash, input FROM tick WHERE tick>? ORDER BY tick");
    query.bind(0, after);
    std::uint64_t expected = after + 1;
    while (query.step()) {
      JournalTick tick;
      tick.tick = query.number(0);
      if (tick.tick != expected++) refuse(fmt::format("tick {} is missing", expected - 1));
      tick.state_hash = query.number(1);
      tick.input = decode_input(query.bytes(2));
      if (!visit(tick)) return;
    }
  } catch (const SqliteError& e) {
    refuse(fmt::format("is damaged ({})", e.what()));
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
