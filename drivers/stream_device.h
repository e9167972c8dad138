#pragma once
// What all devices on a byte port share: open, read, heal, judge. A protocol fills in the rest.

#include <memory>
#include <string>
#include <vector>

#include "drivers/device.h"
#include "drivers/device_port.h"
#include "drivers/health_monitor.h"
#include "drivers/stamped_buffer.h"

namespace prosector {

class StreamDevice : public Device {
 public:
  explicit StreamDevice(std::unique_ptr<DevicePort> port);

  void poll(std::vector<DeviceSample>& out) final;
  DeviceStatus status() const override;
  int descriptor() const final { return port_->descriptor(); }

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
  /// Returns, for people, what to check when it can't be opened.
  virtual std::string absent_hint() const { return "check that it is plugged in and that you may read it"; }

  const std::string& path() const { return port_->path(); }
  /// Gives up the port, as what talks there is not what it should be. It is opened again, later each time.
  void refuse(std::string why);
  void send(std::string_view bytes) { port_->write(bytes); }
  StampedBuffer& buffer() { return buffer_; }
  const StampedBuffer& buffer() const { return buffer_; }
  HealthMonitor& health() { return health_; }

 private:
  void open(std::int64_t now_ns);
  void wait_longer(std::int64_t now_ns);

  std::unique_ptr<DevicePort> port_;
  StampedBuffer buffer_;
  HealthMonitor health_;
  std::vector<std::uint8_t> chunk_;
  std::int64_t next_open_ns_ = 0;
  std::int64_t open_delay_ns_;
  std::string refused_;  // why the port was given up, until something valid came
  std::uint64_t refused_records_ = 0;
};

}  // namespace prosector
