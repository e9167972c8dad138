#pragma once
// A device of HDAPI from its opening to its closing. What happens each millisecond happens in HDAPI's own
// thread, as its documentation wants it: calibration works there only, and frames must not stop when this
// program is late.

#include <cstdint>
#include <functional>

#include "drivers/arm_exchange.h"
#include "drivers/hdapi_library.h"

namespace prosector::hdapi {

/// Conditions of its samples.
enum Condition : int { well, waking, being_calibrated, wants_hand, refused, lost };

class Session {
 public:
  /// Opens a device by name ("default": the default one) and starts the scheduler. Throws InputError saying
  /// what is missing.
  Session(const LibraryAddress& address, const Quat& room_arm, std::function<std::int64_t()> clock);
  ~Session() { close(); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  ArmExchange& exchange() { return exchange_; }
  const Api& api() const { return api_; }

 private:
  void close();
  static Enum in_scheduler(void* session);
  Enum tick();
  Enum read();
  void judge(Enum error, Enum calibration);
  void calibrate(Enum state);
  Enum pop_errors();

  Api api_;
  std::function<std::int64_t()> clock_;
  Quat room_arm_;  // turns the arm's vectors into the room's
  ArmExchange exchange_;
  Handle device_ = no_device;
  Schedule schedule_ = 0;

  // What the scheduler's thread alone touches:
  ArmSample sample_;
  int clean_ = 0, bad_ = 0;         // frames in a row without and with an error
  bool has_pose_ = false;           // the newest frame has a pose that can be one
  bool tells_temperature_ = true;   // the device knows how warm its motors are
  std::int64_t warm_until_ns_ = 0;  // as an error said it
};

}  // namespace prosector::hdapi
