#pragma once
// Common base of devices on a byte port: opens, reads, reconnects and monitors health. Derived classes
// implement the protocol.

#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.h"
#include "drivers/device/health_monitor.h"
#include "drivers/ports/device_port.h"
#include "drivers/ports/timestamped_buffer.h"

namespace prosector {

class StreamDevice : public Device {
 public:
  explicit StreamDevice(std::unique_ptr<DevicePort> port);

  void poll(std::vector<DeviceSample>& out) final;
  DeviceStatus status() const override;
  int descriptor() const final { return port_->descriptor(); }

 protected:
  /// Starts the device's protocol from its beginning. It is called after the port has been opened.
  virtual void started(std::int64_t now_ns) = 0;
  /// Advances the device's protocol without waiting: sends commands that are due, and restarts the protocol
  /// if the device is silent.
  virtual void advance(std::int64_t now_ns) = 0;
  /// Removes complete records from the received bytes in buffer() and appends their samples to `out`. Reports
  /// valid records and garbage to health().
  virtual void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) = 0;
  /// Returns the hint for the user that is shown while a device of this type is open but sends nothing.
  virtual std::string silent_hint() const = 0;
  /// Returns the hint for the user that is shown while a device of this type sends only unreadable data.
  virtual std::string babble_hint() const = 0;
  /// Returns the hint for the user that is shown while a device of this type cannot be opened.
  virtual std::string absent_hint() const {
    return "check that it is plugged in and that you have read permission";
  }

  const std::string& path() const { return port_->path(); }
  /// Closes the port because its other end is not a suitable device; `why` is the reason shown to the user.
  /// poll() reopens the port with increasing delays.
  void refuse(std::string why);
  void send(std::string_view bytes) { port_->write(bytes); }
  TimestampedBuffer& buffer() { return buffer_; }
  const TimestampedBuffer& buffer() const { return buffer_; }
  HealthMonitor& health() { return health_; }

 private:
  void open(std::int64_t now_ns);
  void increase_retry_delay(std::int64_t now_ns);

  std::unique_ptr<DevicePort> port_;
  TimestampedBuffer buffer_;
  HealthMonitor health_;
  std::vector<std::uint8_t> chunk_;
  std::int64_t next_open_ns_ = 0;
  std::int64_t open_delay_ns_;
  std::string refused_;  // why the port was closed, until the next valid record
  std::uint64_t records_at_refusal_ = 0;
};

}  // namespace prosector
