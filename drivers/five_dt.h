#pragma once
// 5DT data gloves: five bend sensors, over a serial line or USB.

#include <memory>
#include <string>

#include "drivers/glove_hand.h"
#include "drivers/stream_device.h"

namespace prosector {

/// The Data Glove 5 at 19200 baud: reset, wait for its answer, stream.
class FiveDtSerialGlove final : public StreamDevice {
 public:
  FiveDtSerialGlove(std::unique_ptr<DevicePort> port, const DeviceConfig& config);

 private:
  void started(std::int64_t now_ns) override;
  void advance(std::int64_t now_ns) override;
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;

  bool left_;
  GloveHand hand_;
  bool streaming_ = false;
  std::int64_t due_ns_ = 0;  // when to reset again
};

/// A wireless glove's receiver at 9600 baud: it sends all the time and hears nothing.
class FiveDtWirelessGlove final : public StreamDevice {
 public:
  FiveDtWirelessGlove(std::unique_ptr<DevicePort> port, const DeviceConfig& config);
  DeviceStatus status() const override;

 private:
  void started(std::int64_t) override { in_step_ = false; }
  void advance(std::int64_t) override {}
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;

  bool left_, says_left_;
  bool in_step_ = false;  // the next byte begins a packet, as one has just ended
  GloveHand hand_;
};

/// The Ultra's reports through the kernel's hidraw; nothing needs sending.
class FiveDtUsbGlove final : public StreamDevice {
 public:
  FiveDtUsbGlove(std::unique_ptr<DevicePort> port, const DeviceConfig& config);

 private:
  void started(std::int64_t) override {}
  void advance(std::int64_t) override {}
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;

  GloveHand hand_;
};

std::unique_ptr<Device> open_five_dt(const std::string& path, const DeviceConfig& config);
std::unique_ptr<Device> open_five_dt_wireless(const std::string& path, const DeviceConfig& config);
std::unique_ptr<Device> open_five_dt_usb(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
