#pragma once
// Description of insertions and removals in a list whose other entries keep their order, so that data indexed
// by it can be updated.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/assert.h"

namespace prosector {

struct ListEdit {
  static constexpr std::uint32_t none = ~0U;

  std::vector<std::uint32_t> gone;  // removed entries, by old index; ascending
  std::vector<std::uint32_t> come;  // inserted entries, by new index; ascending
  std::vector<std::uint32_t> now;   // by old index: the new index, or none

  ListEdit() = default;
  /// Describes an edit of a list that had `before` entries: it removes those at `gone_indices` and inserts
  /// new ones. `come_before` has one entry for each inserted entry: the number of old entries that precede
  /// it; ascending.
  ListEdit(std::size_t before, std::vector<std::uint32_t> gone_indices,
           std::span<const std::uint32_t> come_before);

  std::size_t size() const { return now.size() - gone.size() + come.size(); }
  /// Returns whether every old entry of the edited list keeps its index: none was removed, and all insertions
  /// are at the end.
  bool keeps_indices() const { return gone.empty() && (come.empty() || come.front() == now.size()); }
};

inline ListEdit::ListEdit(std::size_t before, std::vector<std::uint32_t> gone_indices,
                          std::span<const std::uint32_t> come_before)
    : gone(std::move(gone_indices)), now(before) {
  PROSECTOR_ASSERT(is_ascending(gone) && (gone.empty() || gone.back() < before));
  PROSECTOR_ASSERT(std::ranges::is_sorted(come_before) &&
                   (come_before.empty() || come_before.back() <= before));
  PROSECTOR_ASSERT(before < none - come_before.size());
  std::uint32_t index = 0;
  auto leaving = gone.begin();
  auto coming = come_before.begin();
  for (std::uint32_t i = 0; i <= before; ++i) {
    for (; coming != come_before.end() && *coming == i; ++coming) come.push_back(index++);
    if (i == before) break;
    const bool leaves = leaving != gone.end() && *leaving == i;
    if (leaves) ++leaving;
    now[i] = leaves ? none : index++;
  }
}

/// Applies the edit to `list`: removes the entries that the edit removes and inserts those of `come`, which
/// are in the order of their new indices.
template <class T>
void apply(const ListEdit& edit, std::span<const T> come, std::vector<T>& list) {
  PROSECTOR_ASSERT(list.size() == edit.now.size() && come.size() == edit.come.size());
  if (edit.keeps_indices()) {
    list.insert(list.end(), come.begin(), come.end());
    return;
  }
  std::vector<T> out;
  out.reserve(edit.size());
  auto from = list.begin();
  std::size_t c = 0;
  const auto take_until = [&](auto end) {  // and what comes among these
    while (from != end || (c < come.size() && edit.come[c] == out.size())) {
      if (c < come.size() && edit.come[c] == out.size()) {
        out.push_back(come[c++]);
        continue;
      }
      const auto room = c < come.size() ? static_cast<std::ptrdiff_t>(edit.come[c] - out.size()) : end - from;
      const auto run_end = from + std::min(room, end - from);
      out.insert(out.end(), from, run_end);
      from = run_end;
    }
  };
  for (const std::uint32_t leaving : edit.gone) {
    take_until(list.begin() + leaving);
    ++from;
  }
  take_until(list.end());
  PROSECTOR_ASSERT(out.size() == edit.size() && c == come.size());
  list = std::move(out);
}

template <class T>
void apply(const ListEdit& edit, const std::vector<T>& come, std::vector<T>& list) {
  apply(edit, std::span<const T>(come), list);
}

}  // namespace prosector
