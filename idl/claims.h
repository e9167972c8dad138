#pragma once
// Which process said which instance of the topics whose end matters, so that only it can end them.
//
// DDS lets any writer end any instance, and an instance that a stranger has ended is silent when its real
// writer leaves. Ends are therefore believed of the process that said the instance, and when that process
// leaves, all it said ends.

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "idl/topics.h"

namespace prosector {

class Claims {
 public:
  /// Notes that a process (Received::writer) said this instance; returns false when it holds absurdly many
  /// already.
  bool said(std::uint64_t writer, const Message& message);
  /// Notes that it ended the instance; returns false when it had not said it, or has ended it before.
  bool ended(std::uint64_t writer, const Message& message);

  /// Returns the processes that said something of `topic` and aren't among those present.
  std::vector<std::uint64_t> absent(std::size_t topic, std::span<const std::uint64_t> present) const;
  /// Ends everything of `topic` that `writer` said; appends the instances, key fields only.
  void end_all(std::size_t topic, std::uint64_t writer, std::vector<Message>& out);

 private:
  std::map<std::pair<std::size_t, std::uint64_t>, std::map<InstanceKey, Message>> said_;  // by topic, writer
};

}  // namespace prosector
