#include "client/text/typesetter.h"

#include <algorithm>

#include "client/text/block_layout.h"
#include "client/text/utf8.h"

namespace prosector {
namespace {

constexpr double shrinking = 0.95;  // ratio of successive sizes that are tried

std::string key_of(std::string_view text, const TextFrame& frame) {
  const double numbers[] = {frame.size, frame.least_size, frame.width, frame.height,
                            frame.centred ? 1.0 : 0.0};
  std::string key(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  return key.append(text);
}

}  // namespace

SetText Typesetter::set(std::string_view text, const TextFrame& frame) {
  std::string key = key_of(text, frame);
  if (const auto known = remembered_.find(key); known != remembered_.end()) return known->second;
  if (remembered_.size() >= most_remembered) remembered_.clear();
  return remembered_.emplace(std::move(key), fit(text, frame)).first->second;
}

SetText Typesetter::fit(std::string_view text, const TextFrame& frame) {
  const std::u32string characters = characters_of(text);
  for (double size = frame.size;; size = std::max(shrinking * size, frame.least_size)) {
    auto block = std::make_shared<const TextBlock>(
        lay_out(fonts_, characters, {frame.width / size, frame.height / size, frame.centred}));
    if (!block->cut || frame.least_size <= 0 || size <= frame.least_size) return {std::move(block), size};
  }
}

}  // namespace prosector
