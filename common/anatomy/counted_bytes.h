#pragma once
// Vectors and strings of plain values as bytes: how many, then the values as they lie in memory. For files
// and pipes of this machine.

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace prosector {

/// Appends the values to `out`.
template <class Values>
void put(std::vector<std::uint8_t>& out, const Values& values) {
  const std::uint64_t count = values.size();
  const auto* c = reinterpret_cast<const std::uint8_t*>(&count);
  out.insert(out.end(), c, c + sizeof(count));
  const auto* p = reinterpret_cast<const std::uint8_t*>(values.data());
  out.insert(out.end(), p, p + count * sizeof(typename Values::value_type));
}

/// Takes what is next off `in`. False where it isn't whole; then `values` are what they were.
template <class Values>
bool get(std::span<const std::uint8_t>& in, Values& values) {
  using T = typename Values::value_type;
  std::uint64_t count = 0;
  if (in.size() < sizeof(count)) return false;
  std::memcpy(&count, in.data(), sizeof(count));
  in = in.subspan(sizeof(count));
  if (count > in.size() / sizeof(T)) return false;
  values.resize(count);
  // memcpy must not be given the null pointer of an empty vector.
  if (count > 0) std::memcpy(static_cast<void*>(values.data()), in.data(), count * sizeof(T));
  in = in.subspan(count * sizeof(T));
  return true;
}

}  // namespace prosector
