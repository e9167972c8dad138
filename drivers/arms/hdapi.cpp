#include "drivers/arms/hdapi.h"

#include <fmt/format.h>

#include <utility>

#include "drivers/arms/omni.h"

namespace prosector {
namespace {

constexpr const char* usual_hd = "libHD.so";

}  // namespace

HdapiArm::HdapiArm(const std::string& path, const ArmConfig& config, std::launch opening,
                   std::function<std::int64_t()> clock)
    : address_(split_library(path, usual_hd)),
      config_(config),
      limits_(omni_limits()),  // the Omni and the Touch have the lowest limits of all its arms
      clock_(std::move(clock)),
      opening_([this] { return std::make_unique<hdapi::Session>(address_, config_.room_arm.q, clock_); },
               opening) {}

ArmReading HdapiArm::read() {
  const std::int64_t now = clock_();
  hdapi::Session* session = opening_.poll(now);
  if (session == nullptr) return {};
  last_ = session->exchange().sample();
  const bool lost = last_.condition == hdapi::lost;
  if (!lost && !session->exchange().silent(now, opening_.opened_ns()))
    return session->exchange().reading(now, config_.room_arm);
  earlier_.records += last_.records;
  earlier_.resyncs += last_.bad;
  ++earlier_.reopens;
  opening_.lose(lost ? "lost: " + hdapi::error_text(session->api(), static_cast<hdapi::Enum>(last_.code))
                     : "HDAPI's servo loop has stopped; the arm is being reopened",
                now);
  last_ = {};
  return {};
}

void HdapiArm::set_force(const Vec3& force) {
  if (opening_.get() != nullptr) opening_.get()->exchange().set_force(force, limits_.peak_force, clock_());
}

DeviceStatus HdapiArm::status() const {
  DeviceStatus out = earlier_;
  out.records += last_.records;
  out.resyncs += last_.bad;
  const bool open = opening_.get() != nullptr;
  if (!open)
    out.health = opening_.problem().empty() ? DeviceHealth::connecting : DeviceHealth::absent;
  else
    out.health = last_.condition == hdapi::waking || last_.records == 0 ? DeviceHealth::connecting
                                                                        : DeviceHealth::streaming;
  out.message = open ? words() : opening_.problem();
  return out;
}

/// Returns the message about the open device for the user.
std::string HdapiArm::words() const {
  switch (last_.condition) {
    case hdapi::being_calibrated:
      return "the arm is being calibrated: put the stylus into its inkwell";
    case hdapi::wants_hand:
      return "the arm needs calibration: put the stylus into its inkwell; if nothing happens, press its "
             "first button";
    case hdapi::refused:
      return "it rejected a force: " +
             hdapi::error_text(opening_.get()->api(), static_cast<hdapi::Enum>(last_.code));
    default:
      return last_.reading.hot ? "the arm's motors are hot: force is reduced until they have cooled down"
                               : "";
  }
}

std::unique_ptr<Arm> open_hdapi(const std::string& path, const ArmConfig& config) {
  return std::make_unique<HdapiArm>(path, config);
}

}  // namespace prosector
