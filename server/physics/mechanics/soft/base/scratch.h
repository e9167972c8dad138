#pragma once
// Scratch memory that each step writes before reading.

#include <cstddef>
#include <vector>

namespace prosector::soft {

/// Resizes scratch memory to `count` entries of undefined value. When it must be reallocated, reserves a
/// quarter more, about as much as cuts add before a body is rebuilt (is_worth_following). Without that
/// reserve, reallocation took most of the tick of a first cut.
template <class T>
void fit_scratch(std::vector<T>& values, std::size_t count) {
  if (count > values.capacity()) {
    values = {};
    values.reserve(count + count / 4);
  }
  values.resize(count);
}

}  // namespace prosector::soft
