#pragma once
// Callback for progress lines of geometry processing.

#include <functional>
#include <string>

namespace prosector {

using Progress = std::function<void(const std::string& line)>;

}  // namespace prosector
