#pragma once
// Tables of rows of different lengths, end to end: row i is values[begin[i]] up to values[begin[i + 1]].

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace prosector {

/// Rows to take the place of others, end to end.
template <class T>
struct FreshRows {
  std::vector<T> values;
  std::vector<std::size_t> counts;
};

/// `rows`: which are replaced, ascending; those beyond the table's end, without gaps, are appended.
template <class T>
void replace_rows(std::span<const std::uint32_t> rows, const FreshRows<T>& fresh,
                  std::vector<std::size_t>& begin, std::vector<T>& values) {
  const std::vector<std::size_t> begin_before = begin;
  const std::size_t rows_before = begin_before.size() - 1;
  std::vector<T> out;
  out.reserve(values.size() + fresh.values.size());
  std::size_t reached = 0, from = 0;
  const auto copy_up_to = [&](std::size_t row) {
    const std::size_t first = begin_before[reached], at = out.size();
    out.insert(out.end(), values.begin() + static_cast<std::ptrdiff_t>(first),
               values.begin() + static_cast<std::ptrdiff_t>(begin_before[row]));
    for (; reached < row; ++reached) begin[reached] = begin_before[reached] - first + at;
  };
  if (!rows.empty() && rows.back() >= rows_before) begin.resize(rows.back() + 2u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    copy_up_to(std::min<std::size_t>(rows[i], rows_before));
    begin[rows[i]] = out.size();
    const auto first = fresh.values.begin() + static_cast<std::ptrdiff_t>(from);
    out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(fresh.counts[i]));
    from += fresh.counts[i];
    if (rows[i] < rows_before) ++reached;
  }
  copy_up_to(rows_before);
  begin.back() = out.size();
  values = std::move(out);
}

}  // namespace prosector
