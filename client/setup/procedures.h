#pragma once
// The calibrations that pages lead through, by name.

#include <memory>
#include <span>
#include <vector>

#include "client/setup/guided_calibration.h"

namespace prosector {

/// What a person says before one begins.
enum class Asked : std::uint8_t { points, role, grid, hand, seconds, against, shape, landmarks };

struct ProcedureRow {
  const char* name;
  const char* about;
  std::unique_ptr<GuidedCalibration> (*begin)(const ClientConfig&, const CalibrationWishes&);
  std::vector<Asked> asked;
};

std::span<const ProcedureRow> tracker_procedures();
std::span<const ProcedureRow> glove_procedures();

}  // namespace prosector
