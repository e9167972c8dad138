#pragma once
// Rungs as JSON, for the cached table and for journals.

#include <nlohmann/json.hpp>

#include "server/calibration/rung.h"

namespace prosector {

nlohmann::ordered_json rung_to_json(const Rung& rung);
/// Reads a rung (model configuration) from a JSON object. Throws nlohmann::json::exception where a field is
/// missing or has a wrong type. Ignores other fields.
Rung rung_from_json(const nlohmann::ordered_json& row);

}  // namespace prosector
