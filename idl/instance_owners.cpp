#include "idl/instance_owners.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::size_t max_instances_of_a_process = 4096;  // a server's roster is the longest list

}  // namespace

bool InstanceOwners::said(std::uint64_t writer, const Message& message) {
  auto& instances = said_[{message.index(), writer}];
  if (instances.size() >= max_instances_of_a_process && !instances.contains(instance_key(message)))
    return false;
  instances.try_emplace(instance_key(message), key_only(message));
  return true;
}

bool InstanceOwners::ended(std::uint64_t writer, const Message& message) {
  const auto it = said_.find({message.index(), writer});
  if (it == said_.end() || it->second.erase(instance_key(message)) == 0) return false;
  if (it->second.empty()) said_.erase(it);
  return true;
}

std::vector<std::uint64_t> InstanceOwners::absent(std::size_t topic,
                                                  std::span<const std::uint64_t> present) const {
  std::vector<std::uint64_t> out;
  for (auto it = said_.lower_bound({topic, 0}); it != said_.end() && it->first.first == topic; ++it)
    if (std::ranges::find(present, it->first.second) == present.end()) out.push_back(it->first.second);
  return out;
}

void InstanceOwners::end_all(std::size_t topic, std::uint64_t writer, std::vector<Message>& out) {
  const auto it = said_.find({topic, writer});
  if (it == said_.end()) return;
  for (auto& [key, message] : it->second) out.push_back(std::move(message));
  said_.erase(it);
}

}  // namespace prosector
