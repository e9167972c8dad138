#include "common/sealed_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "common/hash.h"

namespace prosector {
namespace {

constexpr std::array<std::uint8_t, 8> magic = {'p', 'r', 'o', 's', 'e', 'a', 'l', '1'};

ContentHash seal_of(const std::string& key, std::span<const std::uint8_t> bytes) {
  const ContentHash of_key = content_hash(std::as_bytes(std::span(key)));
  const ContentHash of_bytes = content_hash(std::as_bytes(bytes));
  std::array<std::uint8_t, 2 * sizeof(ContentHash)> both;
  std::ranges::copy(of_key, both.begin());
  std::ranges::copy(of_bytes, both.begin() + sizeof(ContentHash));
  return content_hash(std::as_bytes(std::span(both)));
}

template <class Bytes>
void put(std::ofstream& out, const Bytes& bytes) {
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

SealedFileResult read_sealed_file(const std::filesystem::path& file, const std::string& key) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) return {};
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(in)), {});
  if (in.bad() || !in.is_open()) return {std::nullopt, "cannot be read"};
  constexpr std::size_t head = magic.size() + sizeof(ContentHash);
  if (bytes.size() < head || !std::equal(magic.begin(), magic.end(), bytes.begin()))
    return {std::nullopt, "has another version, or is damaged"};
  const ContentHash seal = seal_of(key, std::span(bytes).subspan(head));
  if (!std::equal(seal.begin(), seal.end(), bytes.begin() + magic.size()))
    return {std::nullopt, "is damaged"};
  bytes.erase(bytes.begin(), bytes.begin() + head);
  return {std::move(bytes), ""};
}

bool write_sealed_file(const std::filesystem::path& file, const std::string& key,
                       std::span<const std::uint8_t> bytes) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const std::filesystem::path aside = file.string() + fmt::format(".{}.tmp", getpid());
  std::ofstream out(aside, std::ios::binary);
  put(out, magic);
  put(out, seal_of(key, bytes));
  put(out, bytes);
  out.close();
  if (out) std::filesystem::rename(aside, file, error);
  const bool written = out && !error;
  std::error_code ignored;
  if (!written) std::filesystem::remove(aside, ignored);
  return written;
}

}  // namespace prosector
