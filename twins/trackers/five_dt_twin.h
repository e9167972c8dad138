#pragma once
// A simulated 5DT glove: the serial Data Glove 5, a wireless one, or the Ultra's USB reports.

#include <random>

#include "drivers/protocols/five_dt_record.h"
#include "drivers/recordings/motion_script.h"
#include "twins/base/twin.h"

namespace prosector {

struct FiveDtTwinOptions {
  MotionScript script;
  std::size_t station = 0;  // station of the script with the flexions
  TwinTiming timing;
  bool hid = false;       // sends 64-byte reports continuously instead of packets on demand
  bool wireless = false;  // sends 10-byte packets continuously
  bool left = false;
  double noise_counts = 0;  // standard deviation
  std::uint64_t seed = 1;
  double rate = 100;  // Hz
};

class FiveDtTwin final : public Twin {
 public:
  FiveDtTwin(const FiveDtTwinOptions& options, std::int64_t now_ns);
  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
               std::vector<TwinOutput>& out) override;
  void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) override;
  std::int64_t due_ns(std::int64_t now_ns) const override;
  void go_on(std::int64_t now_ns) override { clock_.go_on(now_ns); }

 private:
  TwinOutput record(std::int64_t now_ns);

  FiveDtTwinOptions options_;
  ScriptClock clock_;
  std::mt19937_64 random_;
  std::int64_t period_ns_, next_ns_;
  bool streaming_;
  std::uint64_t records_ = 0;
};

}  // namespace prosector
