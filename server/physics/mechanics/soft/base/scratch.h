#pragma once
// Scratch memory that each step writes before reading.

#include <cstddef>
#include <vector>

namespace prosector {

/// Resizes to `count` entries of undefined value. When memory must be moved, reserves a quarter more, about
/// what cuts add before a body is rebuilt (is_worth_following). Moving tens of megabytes, and requesting as
/// many pages from the system, took most of the tick of a first cut.
template <class T>
void fit_scratch(std::vector<T>& values, std::size_t count) {
  if (count > values.capacity()) {
    values = {};
    values.reserve(count + count / 4);
  }
  values.resize(count);
}

}  // namespace prosector
