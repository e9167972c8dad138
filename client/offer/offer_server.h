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
  using Things = std::function<std::vector<Offered>()>;
  using Picture = std::function<std::shared_ptr<const Image>()>;  // the newest; null: there is none

  /// Listens, and begins. Its thread calls both functions, 60 times a second while somebody is there; without
  /// the second one no pictures are offered. Throws InputError where it can't listen.
  OfferServer(const Offer& offer, Things things, Picture picture = {});
  ~OfferServer();

  std::uint16_t port() const { return listener_.port(); }
  /// Says, for people, what is offered where.
  std::string words() const;

 private:
  struct Peer {
    std::unique_ptr<ByteLine> line;
    std::unique_ptr<OfferTalk> talk;
    std::int64_t heard_out_ns = 0;            // when it last took all that was said to it
    std::shared_ptr<const Image> shown = {};  // the last picture that it was shown
    std::int64_t shown_ns = 0;
  };

  Offer offer_;
  Things things_;
  Picture picture_;
  SocketListener listener_;
  std::vector<Peer> peers_;
  std::jthread thread_;

  void run(const std::stop_token& stop);
  void let_in(std::int64_t now_ns);
  bool serve(Peer& peer, const std::vector<Offered>& things, const std::shared_ptr<const Image>& picture,
             std::int64_t now_ns);
};

}  // namespace prosector
