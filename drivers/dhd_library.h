#pragma once
// Force Dimension's DHD, as its public documentation describes it: what of libdhd.so is used here. SI units;
// x towards the user, y right, z up. Results of 0 and more are well, below 0 wrong.

#include <cstddef>
#include <string>

#include "drivers/shared_library.h"

namespace prosector::dhd {

inline constexpr signed char usual_device = -1;
inline constexpr std::size_t status_size = 32;                             // more than any version fills in
inline constexpr std::size_t in_reset = 3, forces_on = 5, off_cause = 14;  // of the status
inline constexpr int motor_saturated = 2;                                  // a result

/// The functions. Each has the name of DHD's without its dhd.
struct Api {
  /// Finds them. Throws InputError naming what is missing.
  explicit Api(const SharedLibrary& library);

  void (*get_sdk_version)(int* major, int* minor, int* release, int* revision);
  int (*open)();
  int (*open_id)(char id);
  int (*close)(char id);
  int (*enable_force)(unsigned char on, char id);
  int (*get_position)(double* x, double* y, double* z, char id);
  int (*get_orientation_frame)(double (*matrix)[3], char id);
  int (*get_button)(int index, char id);
  int (*get_status)(int* status, char id);
  bool (*has_active_wrist)(char id);
  bool (*has_gripper)(char id);
  int (*emulate_button)(unsigned char on, char id);
  int (*set_force)(double x, double y, double z, char id);
  int (*set_force_and_torque)(double x, double y, double z, double about_x, double about_y, double about_z,
                              char id);
  const char* (*error_get_last_str)();
};

/// Returns the last error in words.
std::string last_error(const Api& api);

}  // namespace prosector::dhd
