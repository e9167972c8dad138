#pragma once
// 5DT data gloves: five bend sensors, over a serial line or USB.

#include <memory>
#include <string>

#include "drivers/device/stream_device.h"
#include "drivers/gloves/glove_hand.h"

namespace prosector {

/// Driver of the 5DT Data Glove 5 on a serial line at 19200 baud. The driver sends a reset, waits for the
/// answer and starts streaming.
class FiveDtSerialGlove final : public StreamDevice {
 public:
  FiveDtSerialGlove(std::unique_ptr<DevicePort> port, const GestureThresholds& gestures,
                    const GloveConfig& glove);

 private:
  void started(std::int64_t now_ns) override;
  void advance(std::int64_t now_ns) override;
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;

  bool left_;
  GloveHand hand_;
  bool streaming_ = false;
  std::int64_t due_ns_ = 0;  // time of the next reset
};

/// Driver of a wireless 5DT glove through its receiver on a serial line at 9600 baud. The glove streams
/// continuously and accepts no commands.
class FiveDtWirelessGlove final : public StreamDevice {
 public:
  FiveDtWirelessGlove(std::unique_ptr<DevicePort> port, const GestureThresholds& gestures,
                      const GloveConfig& glove);
  DeviceStatus status() const override;

 private:
  void started(std::int64_t) override { at_packet_start_ = false; }
  void advance(std::int64_t) override {}
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;

  bool left_, reports_left_;
  bool at_packet_start_ = false;  // the previous packet has just ended, so that the next byte starts a packet
  GloveHand hand_;
};

/// Driver of the 5DT Data Glove Ultra on USB, which reads its HID reports through the kernel's hidraw. The
/// glove needs no commands.
class FiveDtUsbGlove final : public StreamDevice {
 public:
  FiveDtUsbGlove(std::unique_ptr<DevicePort> port, const GestureThresholds& gestures,
                 const GloveConfig& glove);

 private:
  void started(std::int64_t) override {}
  void advance(std::int64_t) override {}
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;

  GloveHand hand_;
};

std::unique_ptr<Device> open_five_dt(const std::string& path, const GestureThresholds& gestures,
                                     const GloveConfig& glove);
std::unique_ptr<Device> open_five_dt_wireless(const std::string& path, const GestureThresholds& gestures,
                                              const GloveConfig& glove);
std::unique_ptr<Device> open_five_dt_usb(const std::string& path, const GestureThresholds& gestures,
                                         const GloveConfig& glove);

}  // namespace prosector
