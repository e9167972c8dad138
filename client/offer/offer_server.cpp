#include "client/offer/offer_server.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <utility>

#include "common/clock.h"

namespace prosector {
namespace {

constexpr std::size_t most_peers = 32;
constexpr std::int64_t peer_timeout_ns = 10'000'000'000;  // timeout of a peer that does not receive
constexpr std::int64_t picture_interval_ns = 60'000'000;  // minimum interval between two images
constexpr int idle_ms = 100;
constexpr std::chrono::microseconds interval(16667);

std::int64_t since_epoch_ns() {
  return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

OfferServer::OfferServer(const Offer& offer, Things things, Picture picture)
    : offer_(offer),
      things_(std::move(things)),
      picture_(std::move(picture)),
      listener_(offer.address, offer.port),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

OfferServer::~OfferServer() {
  thread_.request_stop();
  thread_.join();
}

std::string OfferServer::words() const {
  return fmt::format("publishing the poses of hands, heads and held tools{} by {} at {} port {}",
                     picture_ ? ", and camera images," : "", offer_.protocol->name, offer_.address, port());
}

void OfferServer::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    accept_peers(monotonic_ns());
    if (peers_.empty()) {
      pollfd waiting{listener_.descriptor(), POLLIN, 0};
      ::poll(&waiting, 1, idle_ms);
      continue;
    }
    const auto next = std::chrono::steady_clock::now() + interval;
    const std::vector<Offered> things = things_();
    const std::shared_ptr<const Image> picture = picture_ ? picture_() : nullptr;
    const std::int64_t now_ns = monotonic_ns();
    std::erase_if(peers_, [&](Peer& peer) { return !serve(peer, things, picture, now_ns); });
    std::this_thread::sleep_until(next);
  }
}

/// Accepts waiting connections up to the limit.
void OfferServer::accept_peers(std::int64_t now_ns) {
  for (int descriptor = listener_.accept(); descriptor >= 0; descriptor = listener_.accept()) {
    if (peers_.size() < most_peers)
      peers_.push_back({socket_line(descriptor, "peer"), offer_.protocol->talk(), now_ns});
    else
      ::close(descriptor);
  }
}

/// Reads from a peer and sends it the objects, unless earlier data is still unsent. Returns whether the
/// connection stays open.
bool OfferServer::serve(Peer& peer, const std::vector<Offered>& things,
                        const std::shared_ptr<const Image>& picture, std::int64_t now_ns) {
  std::vector<std::uint8_t> bytes;
  if (!peer.line->receive(bytes) || !peer.talk->hear(bytes)) return false;
  if (peer.line->is_full()) return now_ns - peer.last_drained_ns < peer_timeout_ns;
  peer.last_drained_ns = now_ns;
  OfferConnection::Bytes said = peer.talk->say(things, since_epoch_ns());
  if (picture && picture != peer.shown && now_ns - peer.shown_ns >= picture_interval_ns) {
    const OfferConnection::Bytes shown = peer.talk->show(*picture, since_epoch_ns());
    said.insert(said.end(), shown.begin(), shown.end());
    peer.shown = picture;
    peer.shown_ns = now_ns;
  }
  if (!said.empty()) peer.line->send(said);
  return true;
}

}  // namespace prosector
