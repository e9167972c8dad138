// A stream of bytes may arrive in any pieces: every driver must read the same samples from it wherever it is
// cut.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <filesystem>

#include "common/clock.h"
#include "drivers/config/device_config.h"
#include "drivers/device/driver_table.h"
#include "twins/base/pseudo_terminal.h"
#include "twins/trackers/fastrak_twin.h"
#include "twins/trackers/five_dt_twin.h"

namespace prosector {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Samples = std::vector<DeviceSample>;

/// A driver on a terminal whose other end is the test's: the twin answers the dialogue, then nothing arrives
/// but what the test writes.
class Wire {
 public:
  /// `last` ends the driver's dialogue with the device; 0: it has none.
  Wire(const std::string& driver, const DeviceConfig& config, Twin& twin, char last) {
    const std::string link =
        (std::filesystem::temp_directory_path() / ("prosector-wire-" + std::to_string(getpid()))).string();
    terminal_.open(link);
    device_ = open_device(driver + ":" + link, config);
    Samples none;
    device_->poll(none);
    if (last != 0) answer(twin, last);
  }

  /// The samples that come of one piece, all of which has arrived at the driver's end.
  Samples feed(std::span<const std::uint8_t> piece) {
    Samples out;
    if (piece.empty()) return out;
    EXPECT_EQ(::write(terminal_.descriptor(), piece.data(), piece.size()),
              static_cast<ssize_t>(piece.size()));
    const std::int64_t end = monotonic_ns() + 2'000'000'000;
    int waiting = 0;
    while (waiting < static_cast<int>(piece.size()) && monotonic_ns() < end)
      ioctl(device_->descriptor(), FIONREAD, &waiting);
    EXPECT_EQ(waiting, static_cast<int>(piece.size()));
    device_->poll(out);
    return out;
  }

 private:
  void answer(Twin& twin, char last) {
    pollfd fd = {.fd = terminal_.descriptor(), .events = POLLIN, .revents = 0};
    const std::int64_t end = monotonic_ns() + 10'000'000'000;
    for (char said = 0; said != last && monotonic_ns() < end;) {
      Samples none;
      device_->poll(none);
      if (::poll(&fd, 1, 5) <= 0) continue;
      std::array<std::uint8_t, 256> chunk;
      const ssize_t n = ::read(terminal_.descriptor(), chunk.data(), chunk.size());
      if (n <= 0) continue;
      const auto heard = std::span(chunk).first(static_cast<std::size_t>(n));
      std::vector<TwinOutput> out;
      twin.receive(heard, monotonic_ns(), out);
      for (const TwinOutput& o : out)
        EXPECT_EQ(::write(terminal_.descriptor(), o.bytes.data(), o.bytes.size()),
                  static_cast<ssize_t>(o.bytes.size()));
      said = static_cast<char>(heard.back());
    }
  }

  PseudoTerminal terminal_;
  std::unique_ptr<Device> device_;
};

MotionScript moving_script() {
  MotionScript script;
  for (std::size_t station = 0; station < 2; ++station) {
    script.add(station, 0, {{0.2, 0.1, -0.3}, Quat(0.9, 0.2, -0.1, 0.3).normalized()});
    script.add(station, 1, {{-0.1, 0.4, -0.7}, Quat(0.7, -0.2, 0.5, 0.1).normalized()});
  }
  script.add(0, 0, std::array<double, fingers>{0, 0.2, 0.4, 0.6, 0.8});
  script.add(0, 1, std::array<double, fingers>{1, 0.7, 0.5, 0.3, 0.1});
  return script;
}

/// Four records, and on a line that knows where one begins garbage before the third that looks like a
/// beginning.
Bytes stream_of(Twin& twin, bool with_garbage) {
  const Bytes garbage = with_garbage ? Bytes{'x', '0', '1', 0x80, 0x55, '\r', '\n', '2'} : Bytes{};
  std::vector<TwinOutput> out;
  for (std::int64_t t = monotonic_ns(); out.size() < 4; t += 50'000'000) twin.produce(t, out);
  Bytes bytes;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i == 2) bytes.insert(bytes.end(), garbage.begin(), garbage.end());
    bytes.insert(bytes.end(), out[i].bytes.begin(), out[i].bytes.end());
  }
  return bytes;
}

void expect_same(const Samples& whole, const Samples& split, const std::string& where) {
  ASSERT_EQ(split.size(), whole.size()) << where;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(split[i].station, whole[i].station) << where;
    EXPECT_EQ(split[i].raw_pose, whole[i].raw_pose) << where;
    EXPECT_EQ(split[i].pose.p, whole[i].pose.p) << where;
    EXPECT_EQ(split[i].pose.q.coeffs(), whole[i].pose.q.coeffs()) << where;
    EXPECT_EQ(split[i].raw_flexion, whole[i].raw_flexion) << where;
    EXPECT_EQ(split[i].flexion, whole[i].flexion) << where;
    EXPECT_EQ(split[i].gesture, whole[i].gesture) << where;
  }
}

void split_everywhere(const std::string& driver, const DeviceConfig& config, Twin& twin, char last) {
  Wire wire(driver, config, twin, last);
  const Bytes stream = stream_of(twin, last != 0);
  wire.feed(stream);  // gestures have a memory: from here on each stream follows the same one
  const Samples whole = wire.feed(stream);
  ASSERT_EQ(whole.size(), 4u);  // no garbage taken for a record, no record lost
  const std::span<const std::uint8_t> all(stream);
  for (std::size_t at = 1; at < all.size(); ++at) {
    Samples split = wire.feed(all.first(at));
    for (const DeviceSample& s : wire.feed(all.subspan(at))) split.push_back(s);
    expect_same(whole, split, driver + " cut at byte " + std::to_string(at));
    if (testing::Test::HasFailure()) return;
  }
  Samples bytewise;
  for (std::size_t at = 0; at < all.size(); ++at)
    for (const DeviceSample& s : wire.feed(all.subspan(at, 1))) bytewise.push_back(s);
  expect_same(whole, bytewise, driver + " byte by byte");
}

TEST(Split, FastrakRecordsWhereverTheyAreCut) {
  for (const bool binary : {true, false}) {
    SCOPED_TRACE(binary ? "binary" : "ASCII");
    FastrakTwinOptions options;
    options.script = moving_script();
    FastrakTwin twin(options, monotonic_ns());
    DeviceConfig config;
    config.placement.stations = 3;
    config.fastrak.binary = binary;
    split_everywhere("fastrak", config, twin, 'C');
  }
}

TEST(Split, GlovePacketsAndReportsWhereverTheyAreCut) {
  for (const bool hid : {false, true})
    for (const bool left : {false, true}) {
      SCOPED_TRACE(std::string(hid ? "USB" : "serial") + (left ? " left" : " right"));
      FiveDtTwinOptions options;
      options.script = moving_script();
      options.hid = hid;
      options.left = left;
      FiveDtTwin twin(options, monotonic_ns());
      DeviceConfig config;
      config.glove.left = left;
      config.glove.calibration = GloveCalibration{};
      config.glove.calibration->closed.fill(hid ? 1300 : 255);
      split_everywhere(hid ? "5dt-usb" : "5dt", config, twin, hid ? '\0' : 'D');
    }
}

}  // namespace
}  // namespace prosector
