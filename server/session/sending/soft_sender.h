#pragma once
// Selects the chunks of one deformable to send this tick.

#include <cstdint>
#include <vector>

#include "common/body_messages.h"
#include "common/ids.h"
#include "common/math.h"
#include "idl/message.h"
#include "server/session/sending/snapshot.h"
#include "server/session/sending/surface_stream.h"

namespace prosector {

// A chunk is sent when a point has moved this far since the chunk was last sent, or will within a tick by its
// change of velocity. With the error of the transmitted grid (idl/wire) the drawn surface stays within 0.1
// mm.
inline constexpr double soft_send_threshold = 2e-5;  // m
// Every chunk of a body in motion is sent at least this often. This replaces lost samples and supplies late
// joiners.
inline constexpr std::uint64_t soft_refresh_ticks = 30;

class SoftSender {
 public:
  SoftSender(BodyId body, double tick_rate);

  /// Appends the messages for one soft body to `out`: the chunks of points that have moved or are due, or the
  /// body's settled shape. `everything`: sends all chunks, for a client that has just joined.
  void update(const SoftSnapshot& now, SimTime time, bool everything, std::vector<Message>& out);

 private:
  BodyId body_;
  std::shared_ptr<const SurfaceStream> stream_;  // of the last snapshot
  double dt_;
  std::vector<Vec3> x_, v_;              // present values
  std::vector<Vec3> sent_x_, sent_v_;    // values last sent
  std::shared_ptr<const VecX> settled_;  // the shape of the last Settled; null while in motion
  std::uint32_t epoch_ = 0;
  std::uint32_t cursor_ = 0;        // next chunk to refresh
  std::uint32_t known_points_ = 0;  // number of points sent to clients

  void grow();
  void place(const SoftSnapshot& now);
  void settle(const SoftSnapshot& now, SimTime time, std::vector<Message>& out);
  bool changed(std::uint32_t chunk) const;
  std::uint32_t begin(std::uint32_t chunk) const { return chunk * stream_->chunk_points; }
  std::uint32_t end(std::uint32_t chunk) const;
  SoftState send(std::uint32_t chunk, SimTime time, std::uint32_t revision);
};

}  // namespace prosector
