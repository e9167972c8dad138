#pragma once
// Record of the process that published each instance, so that only that process can end it.
//
// DDS lets any writer dispose any instance. If a foreign process has disposed an instance, DDS no longer
// reports when the real writer leaves. A disposal is therefore accepted only from the process that published
// the instance, and when that process leaves, all its instances end.

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "idl/topics.h"

namespace prosector {

class InstanceOwners {
 public:
  /// Records that the process `writer` (Received::writer) published the message's instance. Returns false if
  /// the process has too many instances.
  bool said(std::uint64_t writer, const Message& message);
  /// Records that the process `writer` ended the message's instance. Returns false if that process had not
  /// published it, or has ended it before.
  bool ended(std::uint64_t writer, const Message& message);

  /// Returns the processes that published instances of `topic` and are not listed in `present`, the processes
  /// that are still connected.
  std::vector<std::uint64_t> absent(std::size_t topic, std::span<const std::uint64_t> present) const;
  /// Removes all instances of `topic` that the process `writer` published, and appends a message with the key
  /// fields of each to `out`.
  void end_all(std::size_t topic, std::uint64_t writer, std::vector<Message>& out);

 private:
  std::map<std::pair<std::size_t, std::uint64_t>, std::map<InstanceKey, Message>> said_;  // by topic, writer
};

}  // namespace prosector
