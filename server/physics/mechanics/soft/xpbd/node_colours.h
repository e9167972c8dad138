#pragma once
// Colours of the elements at each node, for greedy colouring.

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace prosector::soft {

/// Set of colours taken at each node, for greedily colouring elements so that elements of one colour share no
/// node. Stores one bit per colour and node.
class NodeColours {
 public:
  explicit NodeColours(std::size_t nodes) : nodes_(nodes), words_(1, std::vector<std::uint64_t>(nodes, 0)) {}

  /// Returns the lowest colour (number from 0) that is not taken at any of these nodes of an element, and
  /// marks it as taken at all of them.
  std::uint32_t take_first_free(std::span<const std::uint32_t> nodes) {
    for (std::size_t w = 0;; ++w) {
      if (w == words_.size()) words_.emplace_back(nodes_, 0);
      std::vector<std::uint64_t>& taken = words_[w];
      std::uint64_t any = 0;
      for (const std::uint32_t node : nodes) any |= taken[node];
      if (~any == 0) continue;
      const int bit = std::countr_one(any);
      for (const std::uint32_t node : nodes) taken[node] |= std::uint64_t{1} << bit;
      return static_cast<std::uint32_t>(64 * w) + static_cast<std::uint32_t>(bit);
    }
  }

 private:
  std::size_t nodes_;
  std::vector<std::vector<std::uint64_t>> words_;  // each word by node
};

}  // namespace prosector::soft
