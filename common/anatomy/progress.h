#pragma once
// Where the making of geometry reports to, line by line.

#include <functional>
#include <string>

namespace prosector {

using Progress = std::function<void(const std::string& line)>;

}  // namespace prosector
