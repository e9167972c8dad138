#pragma once
// An open HDAPI device. The work of each millisecond runs in HDAPI's own thread, as its documentation
// requires. Calibration works only there, and frames must continue when this program is late.

#include <cstdint>
#include <functional>

#include "drivers/arms/arm_exchange.h"
#include "drivers/arms/hdapi_library.h"

namespace prosector::hdapi {

/// Condition of an HDAPI arm in the samples that its thread publishes. `waking`: too few frames without an
/// error so far. `wants_hand`: the user must calibrate it. `refused`: it rejected a force. `lost`: the device
/// must be reopened.
enum Condition : int { well, waking, being_calibrated, wants_hand, refused, lost };

class Session {
 public:
  /// Opens an HDAPI device by its name, or the default one for "default", and starts HDAPI's servo thread.
  /// `room_arm` is the rotation from the arm frame to the room frame; `clock` returns the time in ns. Throws
  /// InputError with the reason on failure.
  Session(const LibraryAddress& address, const Quat& room_arm, std::function<std::int64_t()> clock);
  ~Session() { close(); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  ArmExchange& exchange() { return exchange_; }
  const Api& api() const { return api_; }

 private:
  void close();
  static Enum scheduler_callback(void* session);
  Enum tick();
  Enum read();
  void judge(Enum error, Enum calibration);
  void calibrate(Enum state);
  Enum pop_errors();

  Api api_;
  std::function<std::int64_t()> clock_;
  Quat room_arm_;  // rotation from the arm frame to the room frame
  ArmExchange exchange_;
  Handle device_ = no_device;
  Schedule schedule_ = 0;

  // Used by the scheduler's thread only:
  ArmSample sample_;
  int clean_ = 0, bad_ = 0;          // consecutive frames without and with an error
  bool has_pose_ = false;            // the latest frame has a plausible pose
  bool reports_temperature_ = true;  // the device reports motor temperatures
  std::int64_t warm_until_ns_ = 0;   // end of the hot state that an error reported
};

}  // namespace prosector::hdapi
