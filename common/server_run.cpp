#include "common/server_run.h"

#include <algorithm>
#include <random>

namespace prosector {
namespace {

constexpr int random_bits = 17, time_bits = 35;

std::uint64_t reign_of(std::uint64_t run) {
  return run >> (random_bits + time_bits);
}

}  // namespace

std::uint64_t make_server_run(std::uint32_t reign, std::chrono::system_clock::time_point started,
                              std::uint32_t random) {
  const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(started.time_since_epoch());
  const std::uint64_t time = static_cast<std::uint64_t>(since.count() / 100) & ((1ULL << time_bits) - 1);
  const std::uint64_t chance = random & ((1U << random_bits) - 1);
  return (std::uint64_t{std::min(reign, last_reign)} << time_bits | time) << random_bits | chance;
}

std::uint64_t make_server_run(std::uint32_t reign) {
  std::random_device entropy;
  return make_server_run(reign, std::chrono::system_clock::now(), entropy());
}

bool precedes(std::uint64_t a, std::uint64_t b) {
  return reign_of(a) != reign_of(b) ? reign_of(a) > reign_of(b) : a < b;
}

}  // namespace prosector
