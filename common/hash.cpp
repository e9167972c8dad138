#include "common/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <new>

namespace prosector {

ContentHash content_hash(std::span<const std::byte> bytes) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  ContentHash out;
  std::copy(std::begin(canonical.digest), std::end(canonical.digest), out.begin());
  return out;
}

std::string to_hex(const ContentHash& hash) {
  std::string out;
  for (auto byte : hash) out += fmt::format("{:02x}", byte);
  return out;
}

std::string to_hex(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

StateHasher::StateHasher() : state_(XXH3_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH3_64bits_reset(static_cast<XXH3_state_t*>(state_));
}

StateHasher::~StateHasher() {
  XXH3_freeState(static_cast<XXH3_state_t*>(state_));
}

void StateHasher::add(std::span<const std::byte> bytes) {
  XXH3_64bits_update(static_cast<XXH3_state_t*>(state_), bytes.data(), bytes.size());
}

std::uint64_t StateHasher::digest() const {
  return XXH3_64bits_digest(static_cast<XXH3_state_t*>(state_));
}

}  // namespace prosector
