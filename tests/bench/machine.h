#pragma once
// Description of the machine on which a report was measured.

#include <nlohmann/json.hpp>
#include <string>

namespace prosector {

/// Returns CPU, cores, vector instructions, memory_bytes, build type, and the load average of the last
/// minute. If `load_average` exceeds the number of cores, other processes slow the measurements down.
nlohmann::ordered_json machine();
std::string compiler();
std::string utc_date();  // ISO 8601
std::string commit();    // output of git describe when the build was configured

}  // namespace prosector
