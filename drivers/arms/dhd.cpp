#include "drivers/arms/dhd.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <utility>

#include "common/error.h"
#include "drivers/device/plausible.h"

namespace prosector {
namespace {

constexpr const char* usual_dhd = "libdhd.so";
constexpr int known_dhd_major = 3;
constexpr int max_failed_calls = 100;  // consecutive failed calls after which the device is reopened
constexpr std::uint64_t status_interval_cycles = 50;  // cycles between status queries
constexpr int asked_buttons = 4;

/// Returns the rotation from DHD's axes (x towards the user, y right, z up) to the arm frame.
Mat3 axes() {
  return (Mat3() << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished();
}

}  // namespace

ArmLimits dhd_limits() {
  ArmLimits out;
  out.low = {-0.08, -0.08, -0.055};
  out.high = {0.08, 0.08, 0.055};
  out.peak_force = out.continuous_force = 12;
  out.stiffness = 14500;
  out.max_slew = 1500;
  out.peak_torque = 0.4;
  out.torsion = 5;
  return out;
}

dhd::Session::Session(const LibraryAddress& address) : api_(SharedLibrary(address.library)) {
  int major = 0, minor = 0, release = 0, revision = 0;
  api_.get_sdk_version(&major, &minor, &release, &revision);
  if (major != known_dhd_major)
    throw InputError(fmt::format("library '{}' has version {}.{}.{}; supported: {}", address.library, major,
                                 minor, release, known_dhd_major));
  const std::string& name = address.device;
  int number = 0;
  const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool by_number =
      problem == std::errc() && end == name.data() + name.size() && number >= 0 && number < 128;
  if (!by_number && name != "default")
    throw InputError(fmt::format("dhd: '{}' must be the number of a device, from 0, or \"default\"", name));
  const int opened = by_number ? api_.open_id(static_cast<char>(number)) : api_.open();
  if (opened < 0) throw InputError(fmt::format("device '{}' cannot be opened: {}", name, last_error(api_)));
  id_ = static_cast<char>(opened);
  turns_ = api_.has_active_wrist(id_);
  // A gripper (omega.7, sigma.7) has no button. With emulation enabled, the library reports a closed gripper
  // as a button.
  if (api_.has_gripper(id_)) api_.emulate_button(1, id_);
  if (api_.enable_force(1, id_) >= 0) return;
  const std::string why = last_error(api_);
  api_.close(id_);
  throw InputError(fmt::format("device '{}' rejects forces: {}", name, why));
}

dhd::Session::~Session() {
  if (turns_)
    api_.set_force_and_torque(0, 0, 0, 0, 0, 0, id_);
  else
    api_.set_force(0, 0, 0, id_);
  api_.close(id_);
}

DhdArm::DhdArm(const std::string& path, const ArmConfig& config, std::launch opening,
               std::function<std::int64_t()> clock)
    : address_(split_library(path, usual_dhd)),
      config_(config),
      clock_(std::move(clock)),
      opening_([this] { return std::make_unique<dhd::Session>(address_); }, opening) {}

ArmReading DhdArm::read() {
  const std::int64_t now = clock_();
  const dhd::Session* session = opening_.poll(now);
  if (session == nullptr) return {};
  if (cycles_++ % status_interval_cycles == 0) look(*session);
  ArmReading out;
  if (ask(*session, out)) {
    ++counts_.records;
    if (failed_ < max_failed_calls) return out;
  }
  ++counts_.resyncs;
  if (++failed_ < max_failed_calls) return {};
  ++counts_.reopens;
  opening_.lose("lost: " + dhd::last_error(session->api()), now);
  failed_ = 0;
  return {};
}

/// Reads the pose and the buttons. Returns false if the device reports an error or an implausible pose.
bool DhdArm::ask(const dhd::Session& session, ArmReading& out) {
  const dhd::Api& api = session.api();
  Vec3 p = Vec3::Zero();
  double rows[3][3] = {};
  if (api.get_position(&p.x(), &p.y(), &p.z(), session.id()) < 0 ||
      api.get_orientation_frame(rows, session.id()) < 0)
    return false;
  const Mat3 turn = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&rows[0][0]);
  const Mat3 to_arm = axes();
  const auto stylus = plausible_pose(to_arm * p, to_arm * turn * to_arm.transpose(), arm_reach);
  if (!stylus) return false;
  out.stylus = config_.room_arm * *stylus;
  for (int i = 0; i < asked_buttons; ++i)
    if (api.get_button(i, session.id()) == 1) out.buttons |= 1u << i;
  out.turns = session.turns();
  out.valid = !resting_ && !std::exchange(begins_, false);
  return true;
}

/// Queries the device's status and updates the message for the user.
void DhdArm::look(const dhd::Session& session) {
  std::array<int, dhd::status_size> status{};
  if (session.api().get_status(status.data(), session.id()) < 0) return;
  resting_ = status[dhd::in_reset] != 0;
  const bool was_free = std::exchange(free_, status[dhd::forces_on] != 0);
  begins_ = free_ && !was_free;
  if (resting_)
    condition_ = "the arm is being calibrated: move it to its rest position";
  else if (!free_)
    condition_ = fmt::format("the arm's forces are off (cause {}): press the force button on the arm",
                             status[dhd::off_cause]);
  else
    condition_.clear();
}

void DhdArm::set_force(const Vec3& force) {
  const dhd::Session* session = opening_.get();
  if (session == nullptr) return;
  const bool may = free_ && !resting_ && force.allFinite() && torque_.allFinite();
  const auto to_device = [&](const Vec3& v, double most) {
    const Vec3 bounded = bounded_force(v, may ? most : 0);
    return Vec3(axes().transpose() * (config_.room_arm.q.conjugate() * bounded));
  };
  const Vec3 f = to_device(force, limits_.peak_force), t = to_device(torque_, limits_.peak_torque);
  const dhd::Api& api = session->api();
  const int result = session->turns()
                         ? api.set_force_and_torque(f.x(), f.y(), f.z(), t.x(), t.y(), t.z(), session->id())
                         : api.set_force(f.x(), f.y(), f.z(), session->id());
  failed_ = result < 0 ? failed_ + 1 : 0;
}

DeviceStatus DhdArm::status() const {
  DeviceStatus out = counts_;
  const bool open = opening_.get() != nullptr;
  if (!open)
    out.health = opening_.problem().empty() ? DeviceHealth::connecting : DeviceHealth::absent;
  else
    out.health = failed_ > 0 ? DeviceHealth::silent : DeviceHealth::streaming;
  out.message = open ? condition_ : opening_.problem();
  return out;
}

std::unique_ptr<Arm> open_dhd(const std::string& path, const ArmConfig& config) {
  return std::make_unique<DhdArm>(path, config);
}

}  // namespace prosector
