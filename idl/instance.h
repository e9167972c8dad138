#pragma once
// Key fields of each message, which identify its instance within the topic.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>

#include "common/hash.h"
#include "idl/message.h"

namespace prosector {

using InstanceKey = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>;

/// Returns the index of the topic of message type M, which is also M's index in the Message variant.
template <class M, std::size_t i = 0>
constexpr std::size_t topic_of() {
  static_assert(i < std::variant_size_v<Message>, "no message that a Bus carries");
  if constexpr (std::is_same_v<M, std::variant_alternative_t<i, Message>>)
    return i;
  else
    return topic_of<M, i + 1>();
}

/// Functions that identify the DDS instances of one topic by the key fields of its messages.
struct InstanceRules {
  std::size_t message;                  // index of the topic whose messages `key` and `key_only` take
  InstanceKey (*key)(const Message&);   // see instance_key()
  Message (*key_only)(const Message&);  // see key_only()
};

/// Accumulator that packs the key fields of a message, in order, into an InstanceKey of three numbers.
/// Strings are hashed.
class KeyWords {
 public:
  void add(std::uint64_t word) { words_.at(count_++) = word; }
  void add(const std::string& text) { add(std::hash<std::string>()(text)); }
  void add(const ContentHash& hash) {
    for (std::size_t first = 0; first < hash.size(); first += 8) {
      std::uint64_t word = 0;
      for (std::size_t i = 0; i < 8; ++i) word = word << 8 | hash[first + i];
      add(word);
    }
  }
  InstanceKey key() const { return {words_[0], words_[1], words_[2]}; }

 private:
  std::array<std::uint64_t, std::tuple_size_v<InstanceKey>> words_{};
  std::size_t count_ = 0;
};

template <class Member>
struct FieldOf;
template <class M, class Field>
struct FieldOf<Field M::*> {
  static constexpr std::size_t words = std::is_same_v<Field, ContentHash> ? 2 : 1;
};

template <class M, auto... fields>
InstanceKey key_of(const Message& message) {
  static_assert((FieldOf<decltype(fields)>::words + ... + 0) <= std::tuple_size_v<InstanceKey>);
  [[maybe_unused]] const M& m = std::get<M>(message);
  KeyWords words;
  (words.add(m.*fields), ...);
  return words.key();
}

template <class M, auto... fields>
Message only_key_of(const Message& message) {
  [[maybe_unused]] const M& m = std::get<M>(message);
  M key;
  ((key.*fields = m.*fields), ...);
  return key;
}

/// Rules that identify DDS instances for messages of type M: messages with equal `fields` belong to the same
/// instance. Without fields there is only one instance.
template <class M, auto... fields>
inline constexpr InstanceRules keyed{topic_of<M>(), key_of<M, fields...>, only_key_of<M, fields...>};

}  // namespace prosector
