#pragma once
// What figures were measured on, so that they can be compared.

#include <nlohmann/json.hpp>
#include <string>

namespace prosector {

/// CPU, cores, vector instructions, memory_bytes, build type, and how many processes wanted a core over the
/// last minute (`load_average`): above the number of cores something else slows the figures down.
nlohmann::ordered_json machine();
std::string compiler();
std::string utc_date();  // ISO 8601
std::string commit();    // git describe when the build was configured

}  // namespace prosector
