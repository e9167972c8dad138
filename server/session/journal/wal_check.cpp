#include "server/session/journal/wal_check.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <span>
#include <vector>

namespace prosector {
namespace {

// The layout is SQLite's (https://www.sqlite.org/fileformat2.html, "The Write-Ahead Log").
constexpr std::size_t header_bytes = 32, frame_header_bytes = 24;
constexpr std::uint32_t magic = 0x377f0682;  // last bit set: checksums use big-endian words

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t at, bool big_endian = true) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i) out = out << 8 | bytes[at + (big_endian ? i : 3 - i)];
  return out;
}

struct Checksum {
  bool big_endian = true;
  std::uint32_t a = 0, b = 0;

  void add(std::span<const std::uint8_t> bytes) {
    for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
      a += word(bytes, at, big_endian) + b;
      b += word(bytes, at + 4, big_endian) + a;
    }
  }
  bool is(std::span<const std::uint8_t> bytes, std::size_t at) const {
    return word(bytes, at) == a && word(bytes, at + 4) == b;
  }
};

}  // namespace

bool log_is_damaged(const std::filesystem::path& log) {
  std::ifstream in(log, std::ios::binary);
  const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(in)), {});
  if (bytes.size() <= header_bytes) return false;  // empty
  const std::span<const std::uint8_t> all(bytes), header = all.first(header_bytes);
  Checksum sum{(word(header, 0) & 1) != 0};
  sum.add(header.first(24));
  if ((word(header, 0) | 1) != (magic | 1) || !sum.is(header, 24)) return true;
  const std::size_t frame_bytes = frame_header_bytes + word(header, 8);
  bool proven = true;
  for (std::size_t at = header_bytes; at + frame_bytes <= all.size(); at += frame_bytes) {
    const std::span<const std::uint8_t> frame = all.subspan(at, frame_bytes);
    const bool of_this_log = word(frame, 8) == word(header, 16) &&
                             word(frame, 12) == word(header, 20);  // else it is left from an older log
    sum.add(frame.first(8));
    sum.add(frame.subspan(frame_header_bytes));
    proven = proven && of_this_log && sum.is(frame, 16);
    const bool commits = word(frame, 4) != 0;
    if (!proven && of_this_log && commits) return true;
  }
  return false;
}

bool log_is_missing(const std::filesystem::path& file) {
  constexpr std::size_t read_version = 19;  // offset in the file's header; value 2: with a write-ahead log
  std::array<char, read_version + 1> head{};
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), head.size());
  return in && head[read_version] == 2 && !std::filesystem::exists(file.string() + "-wal");
}

}  // namespace prosector
