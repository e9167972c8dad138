#pragma once
// A rung as JSON, in the table that is kept and in journals.

#include <nlohmann/json.hpp>

#include "server/calibration/rung.h"

namespace prosector {

nlohmann::ordered_json rung_to_json(const Rung& rung);
/// Reads a rung. Throws nlohmann::json::exception where a field is missing or of another kind. Other fields
/// are passed over.
Rung rung_from_json(const nlohmann::ordered_json& row);

}  // namespace prosector
