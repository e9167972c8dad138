// A simulated omega.3 of Force Dimension: a library with DHD's functions, after its documentation. Outside
// tests, position queries advance its time.
#include <array>

#include "common/clock.h"
#include "drivers/arms/dhd_library.h"
#include "twins/arms/library_twin.h"

namespace prosector {
namespace {

constexpr int error_general = -1, yes = 1;

/// Returns the parameters of an omega.3. Peak force and resolution are from its data sheet; mass, damping and
/// friction are assumed.
ArmMechanics omega() {
  ArmMechanics out;
  out.mass = 0.2;
  out.damping = 0.3;
  out.quantum = 1e-5;
  out.peak_force = 12;
  return out;
}

class DhdTwin {
 public:
  DhdTwin() {
    library.on_restart = [this] { open_ = forces_ = emulates_ = false; };
  }

  LibraryTwin library{omega()};

  int open(int id) {
    if (library.faults.away || id != 0 || open_ || library.arm() == nullptr) return error_general;
    open_ = true;
    library.arm()->take(now());
    return id;
  }
  int close() {
    if (!open_) return error_general;
    library.arm()->put_down();
    open_ = forces_ = emulates_ = false;
    return 0;
  }
  bool has_gripper() const { return answer() >= 0 && library.faults.gripper; }
  int emulate_button(bool on) {
    if (const int error = answer(); error < 0) return error;
    if (!library.faults.gripper) return error_general;
    emulates_ = on;
    return 0;
  }
  int enable_force(bool on) {
    if (const int error = answer(); error < 0) return error;
    forces_ = on;
    return 0;
  }
  int position(double* x, double* y, double* z) {
    if (const int error = answer(); error < 0) return error;
    if (library.has_own_clock()) library.advance(now());
    // DHD's axes: x towards the user, y right, z up.
    const Vec3 p = library.arm()->model().measured();
    *x = library.reported(p.z());
    *y = library.reported(p.x());
    *z = library.reported(p.y());
    return 0;
  }
  int orientation(double (*matrix)[3]) {
    if (const int error = answer(); error < 0) return error;
    const Mat3 turn = library.arm()->orientation().toRotationMatrix();
    constexpr std::array<Eigen::Index, 3> axis = {2, 0, 1};  // axes of the arm frame for DHD's x, y, z
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) matrix[i][j] = library.reported(turn(axis[i], axis[j]));
    return 0;
  }
  int button(int index) {
    if (const int error = answer(); error < 0) return error;
    if (library.faults.gripper && !emulates_) return 0;  // a gripper has no button
    return static_cast<int>(library.faults.buttons >> index & 1u);
  }
  int status(int* out) {
    if (const int error = answer(); error < 0) return error;
    out[dhd::in_reset] = library.faults.needs_calibration ? yes : 0;
    out[dhd::forces_on] = forces_ && !library.faults.forces_off ? yes : 0;
    out[dhd::off_cause] = library.faults.forces_off ? yes : 0;
    return 0;
  }
  bool turns() { return answer() >= 0 && library.arm()->turns(); }
  int set_force(const Vec3& force, const Vec3& torque) {
    if (const int error = answer(); error < 0) return error;
    if (library.faults.force_error != 0) return library.faults.force_error;
    const bool acts = forces_ && !library.faults.forces_off;
    const auto taken = [&](const Vec3& v) { return acts ? Vec3(v.y(), v.z(), v.x()) : Vec3(Vec3::Zero()); };
    library.arm()->set_force(taken(force), taken(torque));
    return 0;
  }

 private:
  bool open_ = false, forces_ = false, emulates_ = false;

  std::int64_t now() const { return library.has_own_clock() ? monotonic_ns() : library.now_ns(); }
  int answer() const { return !open_ || library.faults.away ? error_general : library.faults.error; }
};

/// Returns the library's only twin.
DhdTwin& twin() {
  static DhdTwin only;
  return only;
}

}  // namespace
}  // namespace prosector

using prosector::locked;
using prosector::twin;

extern "C" {

void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = twin().library.faults.version;
  *minor = 17;
  *release = 5;
  *revision = 0;
}
int dhdOpen() {
  return locked(twin(), [](auto& t) { return t.open(0); });
}
int dhdOpenID(char id) {
  return locked(twin(), [&](auto& t) { return t.open(id); });
}
int dhdClose(char) {
  return locked(twin(), [](auto& t) { return t.close(); });
}
int dhdEnableForce(unsigned char on, char) {
  return locked(twin(), [&](auto& t) { return t.enable_force(on != 0); });
}
int dhdGetPosition(double* x, double* y, double* z, char) {
  return locked(twin(), [&](auto& t) { return t.position(x, y, z); });
}
int dhdGetOrientationFrame(double (*matrix)[3], char) {
  return locked(twin(), [&](auto& t) { return t.orientation(matrix); });
}
int dhdGetButton(int index, char) {
  return locked(twin(), [&](auto& t) { return t.button(index); });
}
int dhdGetStatus(int* status, char) {
  return locked(twin(), [&](auto& t) { return t.status(status); });
}
bool dhdHasActiveWrist(char) {
  return locked(twin(), [](auto& t) { return t.turns(); });
}
bool dhdHasGripper(char) {
  return locked(twin(), [](auto& t) { return t.has_gripper(); });
}
int dhdEmulateButton(unsigned char on, char) {
  return locked(twin(), [&](auto& t) { return t.emulate_button(on != 0); });
}
int dhdSetForce(double x, double y, double z, char) {
  return locked(twin(), [&](auto& t) { return t.set_force({x, y, z}, prosector::Vec3::Zero()); });
}
int dhdSetForceAndTorque(double x, double y, double z, double about_x, double about_y, double about_z, char) {
  return locked(twin(), [&](auto& t) { return t.set_force({x, y, z}, {about_x, about_y, about_z}); });
}
const char* dhdErrorGetLastStr() {
  return "an error of the simulated Force Dimension arm";
}
prosector::LibraryTwin* prosector_twin() {
  return &twin().library;
}

}  // extern "C"
