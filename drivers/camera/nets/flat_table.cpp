#include "drivers/camera/nets/flat_table.h"

#include <fmt/format.h>

#include <limits>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t offset_bytes = 4;  // size of an offset, and of a list's length before its elements

}  // namespace

FlatTable FlatTable::root(Bytes file) {
  const FlatTable before(file, 0);
  return {file, before.follow(0)};
}

FlatTable::FlatTable(Bytes file, std::size_t at) : file_(file), at_(at) {
  if (at == 0) return;
  const auto fields = static_cast<std::int64_t>(at) - read<std::int32_t>(at);
  if (fields < 0)
    throw InputError(fmt::format(
        "the file is damaged: the table at byte {} has its fields before the start of the file", at));
  fields_ = static_cast<std::size_t>(fields);
  fields_bytes_ = read<std::uint16_t>(fields_);
  need(fields_, fields_bytes_);
}

void FlatTable::need(std::size_t at, std::size_t bytes) const {
  if (at > file_.size() || bytes > file_.size() - at)
    throw InputError(
        fmt::format("the file is damaged: {} bytes are referenced at byte {}, but the file has only {} bytes",
                    bytes, at, file_.size()));
}

/// Returns the position of a field's value in the file; 0 if the field is absent.
std::size_t FlatTable::place(std::size_t field, std::size_t bytes) const {
  const std::size_t entry = offset_bytes + 2 * field;
  if (entry + 2 > fields_bytes_) return 0;
  const std::size_t in_table = read<std::uint16_t>(fields_ + entry);
  if (in_table == 0) return 0;
  need(at_ + in_table, bytes);
  return at_ + in_table;
}

std::size_t FlatTable::follow(std::size_t at) const {
  const std::size_t to = at + read<std::uint32_t>(at);
  if (to == at)
    throw InputError(fmt::format("the file is damaged: the offset at byte {} refers to itself", at));
  need(to, offset_bytes);
  return to;
}

FlatTable::List FlatTable::list(std::size_t field, std::size_t bytes_each, std::size_t most) const {
  const std::size_t at = place(field, offset_bytes);
  if (at == 0) return {};
  const std::size_t start = follow(at);
  const List out{start + offset_bytes, read<std::uint32_t>(start)};
  if (out.count > most)
    throw InputError(
        fmt::format("the file is damaged: the list at byte {} has {} entries, at most {} are allowed", start,
                    out.count, most));
  need(out.first, out.count * bytes_each);
  return out;
}

std::vector<std::int32_t> FlatTable::integers(std::size_t field, std::size_t most) const {
  const List found = list(field, sizeof(std::int32_t), most);
  std::vector<std::int32_t> out(found.count);
  for (std::size_t k = 0; k < found.count; ++k)
    out[k] = read<std::int32_t>(found.first + k * sizeof(std::int32_t));
  return out;
}

FlatTable::Bytes FlatTable::bytes(std::size_t field) const {
  const List found = list(field, 1, std::numeric_limits<std::uint32_t>::max());
  return file_.subspan(found.first, found.count);
}

std::string FlatTable::text(std::size_t field, std::size_t most) const {
  const List found = list(field, 1, most);
  const Bytes letters = file_.subspan(found.first, found.count);
  return {letters.begin(), letters.end()};
}

std::optional<FlatTable> FlatTable::table(std::size_t field) const {
  const std::size_t at = place(field, offset_bytes);
  if (at == 0) return std::nullopt;
  return FlatTable(file_, follow(at));
}

std::vector<FlatTable> FlatTable::tables(std::size_t field, std::size_t most) const {
  const List found = list(field, offset_bytes, most);
  std::vector<FlatTable> out;
  out.reserve(found.count);
  for (std::size_t k = 0; k < found.count; ++k)
    out.push_back(FlatTable(file_, follow(found.first + k * offset_bytes)));
  return out;
}

}  // namespace prosector
