#pragma once
// A guide with the device that it watches: one calibration from its beginning to what came out.

#include <memory>
#include <string>
#include <vector>

#include "drivers/fitting/field_guide.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/timed_guides.h"

namespace prosector {

class GuidedCalibration {
 public:
  /// Begins with a guide, and opens the device. Throws InputError for an address of no driver.
  GuidedCalibration(std::unique_ptr<Guide> guide, const std::string& address, const DeviceConfig& device);
  /// Begins with a guide that compares the device with another one.
  GuidedCalibration(std::unique_ptr<DelayGuide> guide, const std::string& address, const DeviceConfig& device,
                    const std::string& other);

  /// Lets what the device told go through the guide.
  void poll();
  void back() { guide_->back(); }
  GuideStep step() const { return guide_->step(); }
  DeviceStatus device() const { return device_->status(); }
  const Guide& guide() const { return *guide_; }

 private:
  std::unique_ptr<Guide> guide_;
  std::unique_ptr<Device> device_, other_;  // the second where it is compared
  DelayGuide* delay_ = nullptr;             // the guide that compares them
  std::vector<DeviceSample> samples_;
};

/// Returns a configuration's tracker. Throws InputError where it names none.
const std::string& tracker_of(const ClientConfig& config);

/// What a person says before a calibration begins.
struct CalibrationWishes {
  StationRole role = StationRole::right_hand;  // whose receiver touches, swings or rests
  std::size_t hand = right_hand;               // of the glove
  std::vector<Vec3> points;                    // m, room: to be touched
  std::vector<Vec3> landmarks;                 // m, of a phantom's shape: to be touched
  Vec3 target = Vec3::Zero();                  // m, of that shape: where its error is told
  FieldGrid grid;
  double seconds = 10;  // to rest, or to move
  std::string against;  // address of a second device that moves along
};

/// Begins a calibration with the devices of a configuration. Throws InputError where it names none, or what
/// is wished can't be.
std::unique_ptr<GuidedCalibration> begin_room(const ClientConfig& config, const CalibrationWishes& wishes);
std::unique_ptr<GuidedCalibration> begin_tip(const ClientConfig& config, const CalibrationWishes& wishes);
std::unique_ptr<GuidedCalibration> begin_field(const ClientConfig& config, const CalibrationWishes& wishes);
std::unique_ptr<GuidedCalibration> begin_phantom(const ClientConfig& config, const CalibrationWishes& wishes);
std::unique_ptr<GuidedCalibration> begin_glove(const ClientConfig& config, const CalibrationWishes& wishes);
std::unique_ptr<GuidedCalibration> begin_noise(const ClientConfig& config, const CalibrationWishes& wishes);
std::unique_ptr<GuidedCalibration> begin_latency(const ClientConfig& config, const CalibrationWishes& wishes);

/// The file of a field map, beside the configuration.
inline constexpr const char* field_map_file = "field.toml";

}  // namespace prosector
