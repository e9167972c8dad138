#include "client/replica/server_choice.h"

#include "common/assert.h"
#include "common/server_run.h"

namespace prosector {
namespace {

constexpr std::size_t max_servers =
    8;  // each uses the memory of a scene, and any process can claim to be a server

bool hosts(const Replica& replica) {
  return replica.session() && !replica.server_gone();
}

}  // namespace

void ServerChoice::apply(const Received& received) {
  if (!admits(received.writer)) return;
  servers_.at(received.writer).apply(received);
  if (std::holds_alternative<SessionInfo>(received.message)) choose();
}

Replica& ServerChoice::replica() {
  const auto it = servers_.find(followed_);
  return it == servers_.end() ? empty_replica_ : it->second;
}

/// Reports whether samples of this process are accepted, and creates its replica. Samples without a known
/// process (0) and of more than 8 servers are rejected.
bool ServerChoice::admits(std::uint64_t writer) {
  if (writer == 0) return false;
  if (servers_.contains(writer)) return true;
  if (servers_.size() >= max_servers)
    std::erase_if(servers_, [&](const auto& s) { return s.first != followed_ && !hosts(s.second); });
  if (servers_.size() >= max_servers) return false;
  servers_.emplace(writer, Replica(replica().assets(), language_));
  return true;
}

void ServerChoice::choose() {
  PROSECTOR_ASSERT(servers_.size() <= max_servers && !servers_.contains(0));
  for (const auto& [writer, server] : servers_) {
    if (!hosts(server)) continue;
    const Replica& now = replica();
    if (!hosts(now) || precedes(server.session()->server_run, now.session()->server_run)) followed_ = writer;
  }
  std::erase_if(servers_, [&](const auto& s) { return s.first != followed_ && s.second.server_gone(); });
}

}  // namespace prosector
