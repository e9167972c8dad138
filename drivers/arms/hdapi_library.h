#pragma once
// The functions of OpenHaptics' HDAPI (libHD.so) that are used here, after its public documentation. Lengths
// in mm, forces in N; x right, y up, z towards the user.

#include <string>

#include "drivers/ports/shared_library.h"

namespace prosector::hdapi {

using Enum = unsigned int;
using Handle = unsigned int;
using Schedule = unsigned long;
struct ErrorInfo {
  Enum code;
  int internal;
  Handle device;
};
using Callback = Enum (*)(void* data);

inline constexpr Handle no_device = 0xffffffff;
inline constexpr Enum done = 0, again = 1;  // return values of a callback

// Parameters to query, set or enable.
inline constexpr Enum current_buttons = 0x2000, current_transform = 0x2052, current_force = 0x2700;
inline constexpr Enum version = 0x2500, calibration_style = 0x2555, motor_temperature = 0x2605;
inline constexpr Enum force_output = 0x4000, max_force_clamping = 0x4001, force_ramping = 0x4002;

// Error codes. Errors 0x02xx are transient; after the others the device must be reopened.
inline constexpr Enum success = 0, bad_handle = 0x104, warm_motors = 0x200, exceeded_max_force = 0x201,
                      device_fault = 0x300, already_initiated = 0x301, comm_error = 0x302,
                      illegal_begin = 0x400, illegal_end = 0x401, frame_error = 0x402;

// Calibration states, and calibration styles as bits.
inline constexpr Enum calibrated = 0x5000, needs_update = 0x5001, needs_hand = 0x5002;
inline constexpr Enum by_encoder_reset = 1, automatic = 2, by_inkwell = 4;

inline constexpr std::size_t transform_size = 16;  // column-major; the last column is the position
inline constexpr std::size_t most_motors = 6;      // maximum number of motor temperatures, 0 … 1 each
inline constexpr unsigned short usual_priority = 0x7fff;

/// Pointers to the functions of OpenHaptics' library HDAPI, named after them without the prefix "hd".
struct Api {
  /// Looks up HDAPI's functions in the loaded library. Throws InputError that names a missing function.
  explicit Api(const SharedLibrary& library);

  Handle (*init_device)(const char* name);
  void (*disable_device)(Handle);
  void (*make_current_device)(Handle);
  void (*begin_frame)(Handle);
  void (*end_frame)(Handle);
  ErrorInfo (*get_error)();
  const char* (*get_error_string)(Enum);
  const char* (*get_string)(Enum);
  void (*enable)(Enum);
  void (*get_doublev)(Enum, double*);
  void (*set_doublev)(Enum, const double*);
  void (*get_integerv)(Enum, int*);
  Enum (*check_calibration)();
  void (*update_calibration)(Enum style);
  Schedule (*schedule_asynchronous)(Callback, void* data, unsigned short priority);
  void (*unschedule)(Schedule);
  void (*start_scheduler)();
  void (*stop_scheduler)();
};

/// Returns HDAPI's description of an error, followed by the error's number in hexadecimal.
std::string error_text(const Api& api, Enum error);

}  // namespace prosector::hdapi
