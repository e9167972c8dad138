#pragma once
// Tables of rows of different lengths, concatenated: row i is values[begin[i]] up to values[begin[i + 1]].

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector::soft {

/// Replacement rows for a table of rows of different lengths: the values of all rows, concatenated, and the
/// number of values in each row.
template <class T>
struct FreshRows {
  std::vector<T> values;
  std::vector<std::size_t> counts;
};

/// Updates a table of rows of different lengths after an edit. `kept`: the rows that remain, with their new
/// indices. `rows`: ascending indices, after the edit, of the rows that become `fresh`, which are new or
/// changed. In the other rows, each value v is replaced by renumbered(v). Row i of the table is
/// values[begin[i]] up to values[begin[i + 1]].
template <class T, class Renumbered>
void replace_rows(const Kept& kept, std::span<const std::uint32_t> rows, const FreshRows<T>& fresh,
                  const Renumbered& renumbered, std::vector<std::size_t>& begin, std::vector<T>& values) {
  std::vector<std::size_t> begin_now;
  begin_now.reserve(kept.now + 1);
  std::vector<T> out;
  out.reserve(values.size() + fresh.values.size());
  std::size_t next = 0, from = 0;  // in the fresh rows
  const auto put_fresh = [&] {
    begin_now.push_back(out.size());
    const auto first = fresh.values.begin() + static_cast<std::ptrdiff_t>(from);
    from += fresh.counts[next++];
    out.insert(out.end(), first, fresh.values.begin() + static_cast<std::ptrdiff_t>(from));
  };
  const auto put_kept = [&](std::size_t row, std::size_t last) {
    const std::size_t first = begin[row], end = begin[last], at = out.size();
    for (; row < last; ++row) begin_now.push_back(begin[row] - first + at);
    out.insert(out.end(), values.begin() + static_cast<std::ptrdiff_t>(first),
               values.begin() + static_cast<std::ptrdiff_t>(end));
    std::transform(out.begin() + static_cast<std::ptrdiff_t>(at), out.end(),
                   out.begin() + static_cast<std::ptrdiff_t>(at), renumbered);
  };
  for (const Kept::Run& run : kept.runs) {
    const std::uint32_t end = run.to + run.count;
    for (std::uint32_t row = run.to; row < end;) {
      while (next < rows.size() && rows[next] < row) put_fresh();
      if (next < rows.size() && rows[next] == row) {
        put_fresh();
        ++row;
        continue;
      }
      const std::uint32_t last = next < rows.size() ? std::min(rows[next], end) : end;
      put_kept(run.from + (row - run.to), run.from + (last - run.to));
      row = last;
    }
  }
  while (next < rows.size()) put_fresh();
  begin_now.push_back(out.size());
  begin = std::move(begin_now);
  values = std::move(out);
}

}  // namespace prosector::soft
