#pragma once
// Server of one offer, on its own thread. It sends poses to every connected program until that disconnects or
// violates the protocol.

#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "client/offer/offer_protocol.h"
#include "drivers/ports/byte_line.h"
#include "drivers/ports/socket_listener.h"

namespace prosector {

class OfferServer {
 public:
  using Things = std::function<std::vector<Offered>()>;
  using Picture = std::function<std::shared_ptr<const Image>()>;  // newest image; null: none

  /// Starts to listen at the offer's address. While a program is connected, the server's thread calls both
  /// functions 60 times a second: `things` for poses, `picture` for a camera image. Without `picture`, no
  /// images are sent. Throws InputError if it can't listen.
  OfferServer(const Offer& offer, Things things, Picture picture = {});
  ~OfferServer();

  std::uint16_t port() const { return listener_.port(); }
  /// Returns a line for the terminal that states which data are published, by which protocol, and at which
  /// address and port.
  std::string words() const;

 private:
  struct Peer {
    std::unique_ptr<ByteStream> line;
    std::unique_ptr<OfferConnection> talk;
    std::int64_t last_drained_ns = 0;         // time at which it last had received all sent data
    std::shared_ptr<const Image> shown = {};  // last image sent to it
    std::int64_t shown_ns = 0;
  };

  Offer offer_;
  Things things_;
  Picture picture_;
  SocketListener listener_;
  std::vector<Peer> peers_;
  std::jthread thread_;

  void run(const std::stop_token& stop);
  void accept_peers(std::int64_t now_ns);
  bool serve(Peer& peer, const std::vector<Offered>& things, const std::shared_ptr<const Image>& picture,
             std::int64_t now_ns);
};

}  // namespace prosector
