#pragma once
// What all devices on a byte port share: open, read, heal, judge. A protocol fills in the rest.

#include <string>
#include <vector>

#include "drivers/byte_port.h"
#include "drivers/device.h"
#include "drivers/health_monitor.h"
#include "drivers/stamped_buffer.h"

namespace prosector {

class StreamDevice : public Device {
 public:
  StreamDevice(const std::string& path, unsigned baud);

  void poll(std::vector<DeviceSample>& out) final;
  DeviceStatus status() const override;
  int descriptor() const final { return port_.descriptor(); }

 protected:
  /// Starts the dialogue from its beginning: the port has just been opened.
  virtual void started(std::int64_t now_ns) = 0;
  /// Moves the dialogue on: send what is due, start over when the device is silent. Does not wait.
  virtual void advance(std::int64_t now_ns) = 0;
  /// Takes from buffer() what is complete, reports records and garbage to health().
  virtual void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) = 0;
  /// Returns, for people, what to check when this kind of device is silent.
  virtual std::string silent_hint() const = 0;
  /// Returns, for people, what to check when nothing readable arrives.
  virtual std::string babble_hint() const = 0;

  void send(std::string_view bytes) { port_.write(bytes); }
  StampedBuffer& buffer() { return buffer_; }
  const StampedBuffer& buffer() const { return buffer_; }
  HealthMonitor& health() { return health_; }

 private:
  void open(std::int64_t now_ns);

  BytePort port_;
  StampedBuffer buffer_;
  HealthMonitor health_;
  std::vector<std::uint8_t> chunk_;
  std::int64_t next_open_ns_ = 0;
  std::int64_t open_delay_ns_;
};

}  // namespace prosector
