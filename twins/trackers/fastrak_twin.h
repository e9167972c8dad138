#pragma once
// A simulated Polhemus FASTRAK, byte for byte: commands, read-backs, error records, data records. Simplified:
// noise does not depend on distance, and the electronics' latency of 3.75 ms is not added.

#include <array>
#include <random>
#include <string>
#include <string_view>

#include "drivers/protocols/fastrak_record.h"
#include "drivers/recordings/motion_script.h"
#include "twins/base/twin.h"
#include "twins/trackers/distorted_field.h"

namespace prosector {

struct FastrakTwinOptions {
  MotionScript script;
  Pose room_device;      // pose of the transmitter (x right, y up, −z forward) in the room frame
  Pose tip;              // scripted point in the receiver's frame: an instrument's tip
  DistortedField field;  // distortion by metal
  TwinTiming timing;
  double noise_cm = 0, noise_deg = 0;  // standard deviations
  std::uint64_t seed = 1;
  double reinitialise_seconds = 10;  // duration of ^Y
  unsigned baud = 115200;            // limits the rate of wide records
};

class FastrakTwin final : public Twin {
 public:
  FastrakTwin(const FastrakTwinOptions& options, std::int64_t now_ns);
  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
               std::vector<TwinOutput>& out) override;
  void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) override;
  std::int64_t due_ns(std::int64_t now_ns) const override;
  void go_on(std::int64_t now_ns) override { clock_.go_on(now_ns); }

 private:
  struct Station {
    bool active = false;
    std::vector<int> items = {2, 4, 1};
    Vec3 hemisphere = {1, 0, 0};
    Pose alignment;  // pose of the alignment frame in the transmitter's frame, cm
    std::array<double, 9> points = {0, 0, 0, 200, 0, 0, 0, 200, 0};  // cm, as last given
    std::array<double, 3> reference = {0, 0, 0};
    Quat boresight = Quat::Identity();
    std::array<double, 6> position_limits = {200, 200, 200, -200, -200, -200};  // cm
    std::array<double, 6> angle_limits = {180, 90, 180, -180, -90, -180};
    double increment = 0;  // cm
  };
  struct Settings {
    bool binary = false, centimetres = false, continuous = false;
    std::array<Station, max_stations> stations;
  };
  struct Reading {
    Vec3 position;  // cm, in the alignment frame
    Quat orientation;
  };
  using Parameters = std::vector<std::string_view>;

  static Settings defaults();
  void single(char command, std::int64_t now_ns, std::vector<TwinOutput>& out);
  void execute(const std::string& command, std::vector<TwinOutput>& out);
  void set_output_list(Station& s, const std::string& head, const Parameters& p,
                       std::vector<TwinOutput>& out);
  void set_station(std::size_t index, const Parameters& p, std::vector<TwinOutput>& out);
  void set_alignment(Station& s, const std::string& head, const Parameters& p, std::vector<TwinOutput>& out);
  template <std::size_t N>
  void set_numbers(std::array<double, N>& values, double scale, const std::string& head, const Parameters& p,
                   std::vector<TwinOutput>& out);
  void refuse(int code, std::vector<TwinOutput>& out) const;
  std::string status_record() const;

  Reading measure(std::size_t station, std::int64_t now_ns);
  TwinOutput record(std::size_t station, std::int64_t now_ns);
  std::size_t active_count() const;
  double units_per_cm() const { return settings_.centimetres ? 1 : 1 / 2.54; }

  FastrakTwinOptions options_;
  Settings settings_, saved_;
  ScriptClock clock_;
  std::mt19937_64 random_;
  std::string pending_;  // command with parameters, before its CR
  std::int64_t now_ns_;
  std::int64_t next_ns_, busy_ns_ = 0;  // next slot of 8.33 ms; end of the current transmission
  std::size_t next_station_ = 0;
  bool suspended_ = false;
  std::array<std::uint64_t, max_stations> records_{};
  std::array<Vec3, max_stations> tracked_;  // last reported position, for hemisphere tracking
  std::array<Vec3, max_stations> sent_;     // last sent position, for the increment
};

}  // namespace prosector
