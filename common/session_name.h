#pragma once
// Validation of session names.

#include <string>

namespace prosector {

/// Checks the name of a session. Throws InputError unless clients can find a session of that name. A name has
/// 1 … max_name_length bytes of UTF-8 without control characters and without * ? [ ], which are wildcards in
/// DDS partitions.
void check_session_name(const std::string& name);

}  // namespace prosector
