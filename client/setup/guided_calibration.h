#pragma once
// A guide with its device: one calibration from start to result.

#include <memory>
#include <string>
#include <vector>

#include "drivers/fitting/field_guide.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/timed_guides.h"

namespace prosector {

class GuidedCalibration {
 public:
  /// Opens the device at `address` and starts the guide, which leads the user through the steps of a
  /// calibration. Throws InputError for an address without a driver.
  GuidedCalibration(std::unique_ptr<Guide> guide, const std::string& address, const DeviceConfig& device);
  /// Opens the devices at `address` and `other`, which the user moves together, and starts the guide, which
  /// measures the delay of the first relative to the second. Throws InputError for an address without a
  /// driver.
  GuidedCalibration(std::unique_ptr<DelayGuide> guide, const std::string& address, const DeviceConfig& device,
                    const std::string& other);

  /// Takes the samples that the device has sent since the last call, and passes them to the guide.
  void poll();
  void back() { guide_->back(); }
  GuideStep step() const { return guide_->step(); }
  DeviceStatus device() const { return device_->status(); }
  const Guide& guide() const { return *guide_; }

 private:
  std::unique_ptr<Guide> guide_;
  std::unique_ptr<Device> device_, other_;  // the second one if a delay is measured
  DelayGuide* delay_ = nullptr;             // the guide that compares them
  std::vector<DeviceSample> samples_;
};

/// Returns the address of the configuration's tracker. Throws InputError if no tracker is configured.
const std::string& tracker_of(const ClientConfig& config);

/// Settings that the user enters for a calibration; each kind of calibration uses some of them.
struct CalibrationSettings {
  StationRole role = StationRole::right_hand;  // role of the receiver to calibrate
  std::size_t hand = right_hand;               // of the glove
  std::vector<Vec3> points;                    // m, room: points to touch
  std::vector<Vec3> landmarks;                 // m, frame of a phantom's shape: points to touch
  Vec3 target = Vec3::Zero();                  // m, in that frame: point at which the error is reported
  FieldGrid grid;
  double seconds = 10;  // duration of rest or motion
  std::string against;  // address of a second device that moves along
};

/// Starts the calibration of the tracker's position in the room. The other functions start those of an
/// instrument's tip, the magnetic field, a phantom, a glove, noise and latency. They open the devices of the
/// configuration, and throw InputError if one is missing or the settings are invalid.
std::unique_ptr<GuidedCalibration> begin_room(const ClientConfig& config, const CalibrationSettings& wishes);
std::unique_ptr<GuidedCalibration> begin_tip(const ClientConfig& config, const CalibrationSettings& wishes);
std::unique_ptr<GuidedCalibration> begin_field(const ClientConfig& config, const CalibrationSettings& wishes);
std::unique_ptr<GuidedCalibration> begin_phantom(const ClientConfig& config,
                                                 const CalibrationSettings& wishes);
std::unique_ptr<GuidedCalibration> begin_glove(const ClientConfig& config, const CalibrationSettings& wishes);
std::unique_ptr<GuidedCalibration> begin_noise(const ClientConfig& config, const CalibrationSettings& wishes);
std::unique_ptr<GuidedCalibration> begin_latency(const ClientConfig& config,
                                                 const CalibrationSettings& wishes);

/// Name of the file with the map of the magnetic field's distortion, in the configuration file's folder.
inline constexpr const char* field_map_file = "field.toml";

}  // namespace prosector
