#pragma once
// Serves one offer on a thread of its own: whoever connects is told, until it hangs up or talks nonsense.

#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "client/offer/offer_protocol.h"
#include "drivers/byte_line.h"
#include "drivers/socket_listener.h"

namespace prosector {

class OfferServer {
 public:
  /// Listens, and begins. Its thread calls `things`, 60 times a second while somebody is there. Throws
  /// InputError where it can't listen.
  OfferServer(const Offer& offer, std::function<std::vector<Offered>()> things);
  ~OfferServer();

  std::uint16_t port() const { return listener_.port(); }
  /// Says, for people, what is offered where.
  std::string words() const;

 private:
  struct Peer {
    std::unique_ptr<ByteLine> line;
    std::unique_ptr<OfferTalk> talk;
    std::int64_t heard_out_ns = 0;  // when it last took all that was said to it
  };

  Offer offer_;
  std::function<std::vector<Offered>()> things_;
  SocketListener listener_;
  std::vector<Peer> peers_;
  std::jthread thread_;

  void run(const std::stop_token& stop);
  void let_in(std::int64_t now_ns);
  bool serve(Peer& peer, const std::vector<Offered>& things, std::int64_t now_ns);
};

}  // namespace prosector
