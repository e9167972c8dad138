#pragma once
// A simulated service of Ultraleap's with hands of Prosector's hand model: the script's first station is the
// right hand, its second the left one.

#include "drivers/protocols/leap_messages.h"
#include "twins/trackers/tracker_clock.h"

namespace prosector {

/// Returns the hand of a simulated Ultraleap frame: the joints of the hand model at this wrist pose and these
/// flexions (0 open … 1 closed). The wrist is in the device frame, m.
leap::Hand simulated_hand(bool left, const Pose& wrist, const std::array<double, fingers>& flexion);

class LeapTwin final : public Twin {
 public:
  LeapTwin(const TrackerTwinOptions& options, std::int64_t now_ns)
      : hands_(std::min<std::size_t>(options.stations, 2)), clock_(options, now_ns) {}

  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
               std::vector<TwinOutput>& out) override;
  void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) override;
  std::int64_t due_ns(std::int64_t) const override { return clock_.next_ns(); }
  void go_on(std::int64_t now_ns) override { clock_.go_on(now_ns); }
  void reset_client() override;

 private:
  std::size_t hands_;
  TrackerClock clock_;
  std::string request_;
  bool talks_ = false;
  std::uint64_t records_ = 0;
};

}  // namespace prosector
