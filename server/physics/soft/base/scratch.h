#pragma once
// Room for what each step writes before it reads it.

#include <cstddef>
#include <vector>

namespace prosector {

/// Makes room for so many entries, of any value. What has to be moved for them to fit gets room for a quarter
/// more, about what cuts make before a body is made anew (is_worth_following). To move tens of megabytes, and
/// to ask the system for as many pages, took most of the tick of a first cut.
template <class T>
void fit_scratch(std::vector<T>& values, std::size_t count) {
  if (count > values.capacity()) {
    values = {};
    values.reserve(count + count / 4);
  }
  values.resize(count);
}

}  // namespace prosector
