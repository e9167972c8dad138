#pragma once
// What a session may be called.

#include <string>

namespace prosector {

/// Throws InputError unless clients can find a session of that name: 1 … max_name_length bytes of UTF-8
/// without control characters, and none of * ? [ ], which name many sessions at once in the network.
void check_session_name(const std::string& name);

}  // namespace prosector
