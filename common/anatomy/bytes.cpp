#include "common/anatomy/bytes.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

#include "common/error.h"
#include "common/regular_file.h"

namespace prosector {

std::vector<std::uint8_t> read_file(const std::filesystem::path& file, std::size_t max_bytes) {
  const std::string bytes = read_regular_file(file, max_bytes);
  return {bytes.begin(), bytes.end()};
}

bool is_gzip(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
}

std::vector<std::uint8_t> gunzip(std::span<const std::uint8_t> bytes, std::size_t max_bytes,
                                 const std::string& name) {
  if (!is_gzip(bytes))
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), max_bytes))};
  z_stream stream{};
  constexpr int gzip_window = 15 + 16;
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::bad_alloc();
  stream.next_in = const_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::vector<std::uint8_t> out;
  int status = Z_OK;
  while (status == Z_OK && out.size() < max_bytes) {
    // Grows as data arrives, so that a false size in the header causes no large allocation.
    const std::size_t at = out.size(), chunk = std::min(std::max<std::size_t>(1 << 16, at), max_bytes - at);
    const auto step = static_cast<uInt>(std::min<std::size_t>(chunk, 1u << 30));
    out.resize(at + step);
    stream.next_out = out.data() + at;
    stream.avail_out = step;
    status = inflate(&stream, Z_NO_FLUSH);
    out.resize(at + step - stream.avail_out);
    if (status == Z_BUF_ERROR) break;
    if (status == Z_STREAM_END && is_gzip({stream.next_in, stream.avail_in})) status = inflateReset(&stream);
  }
  const bool damaged = status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR;
  const std::string why = damaged && stream.msg != nullptr ? stream.msg : "invalid stream";
  inflateEnd(&stream);
  if (damaged)
    throw InputError(fmt::format("{}: damaged gzip stream after {} bytes ({})", name, out.size(), why));
  return out;
}

}  // namespace prosector
