#include "client/setup/guided_calibration.h"

#include <utility>

#include "common/error.h"
#include "drivers/config/tracker_roles.h"
#include "drivers/device/driver_table.h"
#include "drivers/fitting/glove_guide.h"
#include "drivers/fitting/phantom_guide.h"
#include "drivers/fitting/room_guide.h"
#include "drivers/fitting/tip_guide.h"

namespace prosector {

const std::string& tracker_of(const ClientConfig& config) {
  if (config.tracker.empty())
    throw InputError(msg("No tracker is configured. Choose it on the Devices page."));
  return config.tracker;
}

GuidedCalibration::GuidedCalibration(std::unique_ptr<Guide> guide, const std::string& address,
                                     const DeviceConfig& device)
    : guide_(std::move(guide)), device_(open_device(address, device)) {}

GuidedCalibration::GuidedCalibration(std::unique_ptr<DelayGuide> guide, const std::string& address,
                                     const DeviceConfig& device, const std::string& other)
    : device_(open_device(address, device)), other_(open_device(other, {})), delay_(guide.get()) {
  guide_ = std::move(guide);
}

void GuidedCalibration::poll() {
  if (other_) {
    samples_.clear();
    other_->poll(samples_);
    for (const DeviceSample& sample : samples_)
      if (sample.has_pose && sample.station == 0) delay_->add_other_position(sample.time_ns, sample.pose.p);
  }
  samples_.clear();
  device_->poll(samples_);
  for (const DeviceSample& sample : samples_)
    if (!guide_->step().done) guide_->take(sample);
}

std::unique_ptr<GuidedCalibration> begin_room(const ClientConfig& config, const CalibrationSettings& wishes) {
  const ClientConfig seen = config_for_role(config, wishes.role);
  const std::string& tracker = tracker_of(seen);
  return std::make_unique<GuidedCalibration>(std::make_unique<RoomGuide>(seen, wishes.role, wishes.points),
                                             tracker, RoomGuide::device(seen));
}

std::unique_ptr<GuidedCalibration> begin_tip(const ClientConfig& config, const CalibrationSettings& wishes) {
  const ClientConfig seen = config_for_role(config, wishes.role);
  const std::string& tracker = tracker_of(seen);
  return std::make_unique<GuidedCalibration>(std::make_unique<TipGuide>(seen, wishes.role), tracker,
                                             TipGuide::device(seen, wishes.role));
}

std::unique_ptr<GuidedCalibration> begin_field(const ClientConfig& config,
                                               const CalibrationSettings& wishes) {
  const ClientConfig seen = config_for_role(config, wishes.role);
  const std::string& tracker = tracker_of(seen);
  return std::make_unique<GuidedCalibration>(
      std::make_unique<FieldGuide>(seen, wishes.role, wishes.grid, field_map_file), tracker,
      FieldGuide::device(seen));
}

std::unique_ptr<GuidedCalibration> begin_phantom(const ClientConfig& config,
                                                 const CalibrationSettings& wishes) {
  const std::string tracker = board_tracker_address(tracker_of(config));
  return std::make_unique<GuidedCalibration>(
      std::make_unique<PhantomGuide>(config, wishes.role, wishes.landmarks, std::vector{wishes.target}),
      tracker, PhantomGuide::device(config));
}

std::unique_ptr<GuidedCalibration> begin_glove(const ClientConfig& config,
                                               const CalibrationSettings& wishes) {
  const GloveSettings& glove = config.gloves[wishes.hand];
  if (glove.address.empty())
    throw InputError(wishes.hand == left_hand
                         ? msg("No left glove is configured. Choose it on the Devices page.")
                         : msg("No right glove is configured. Choose it on the Devices page."));
  return std::make_unique<GuidedCalibration>(
      std::make_unique<GloveGuide>(wishes.hand, GloveGuide::least_span_of(glove.address)), glove.address,
      glove.device);
}

std::unique_ptr<GuidedCalibration> begin_noise(const ClientConfig& config,
                                               const CalibrationSettings& wishes) {
  const ClientConfig seen = config_for_role(config, wishes.role);
  const std::string& tracker = tracker_of(seen);
  return std::make_unique<GuidedCalibration>(
      std::make_unique<RestGuide>(station_of_role(seen, wishes.role), wishes.seconds), tracker,
      seen.tracker_device);
}

std::unique_ptr<GuidedCalibration> begin_latency(const ClientConfig& config,
                                                 const CalibrationSettings& wishes) {
  const ClientConfig seen = config_for_role(config, wishes.role);
  const std::string& tracker = tracker_of(seen);
  if (wishes.against.empty())
    throw InputError(msg("Enter a second device that moves together with the receiver."));
  return std::make_unique<GuidedCalibration>(
      std::make_unique<DelayGuide>(station_of_role(seen, wishes.role), wishes.seconds), tracker,
      seen.tracker_device, wishes.against);
}

}  // namespace prosector
