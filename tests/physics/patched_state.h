#pragma once
// States that no play leads to: numbers of a checkpoint replaced by others.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "common/math.h"

namespace prosector::test {

/// The checkpoint with `now`, an awake body's positions or velocities, replaced by as many others. They are
/// found by their bytes; a logic_error where they aren't.
inline std::vector<std::uint8_t> with_values(std::vector<std::uint8_t> checkpoint, const VecX& now,
                                             const VecX& others) {
  const auto* begin = reinterpret_cast<const std::uint8_t*>(now.data());
  const auto size = static_cast<std::size_t>(now.size()) * sizeof(double);
  const auto at = std::search(checkpoint.begin(), checkpoint.end(), begin, begin + size);
  if (at == checkpoint.end() || others.size() != now.size())
    throw std::logic_error("with_values: these aren't in the checkpoint");
  std::memcpy(&*at, others.data(), size);
  return checkpoint;
}

}  // namespace prosector::test
