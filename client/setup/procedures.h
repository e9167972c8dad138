#pragma once
// The guided calibrations by name.

#include <memory>
#include <span>
#include <vector>

#include "client/setup/guided_calibration.h"

namespace prosector {

/// Settings that a calibration can ask the user for before it starts.
enum class CalibrationSetting : std::uint8_t { points, role, grid, hand, seconds, against, shape, landmarks };

struct ProcedureRow {
  const char* name;
  const char* about;
  std::unique_ptr<GuidedCalibration> (*begin)(const ClientConfig&, const CalibrationSettings&);
  std::vector<CalibrationSetting> asked;
};

std::span<const ProcedureRow> tracker_procedures();
std::span<const ProcedureRow> glove_procedures();

}  // namespace prosector
