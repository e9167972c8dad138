#pragma once
// The functions of Force Dimension's DHD (libdhd.so) that are used here, after its public documentation. SI
// units; x towards the user, y right, z up. Results below 0 are errors.

#include <cstddef>
#include <string>

#include "drivers/ports/shared_library.h"

namespace prosector::dhd {

inline constexpr signed char usual_device = -1;
inline constexpr std::size_t status_size = 32;                             // at least the length that any
                                                                           // version fills in
inline constexpr std::size_t in_reset = 3, forces_on = 5, off_cause = 14;  // indices in the status
inline constexpr int motor_saturated = 2;                                  // a result code

/// Pointers to the functions of Force Dimension's library DHD, named after them without the prefix "dhd".
struct Api {
  /// Looks up DHD's functions in the loaded library. Throws InputError that names a missing function.
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

/// Returns the description of the last error in the library DHD, or "unnamed error".
std::string last_error(const Api& api);

}  // namespace prosector::dhd
