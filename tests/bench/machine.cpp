#include "tests/bench/machine.h"

#include <fstream>
#include <string>
#include <thread>

namespace prosector {
namespace {

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

nlohmann::json machine() {
  return {{"cpu", cpu_name()},
          {"cores", std::thread::hardware_concurrency()},
          {"compiler", "g++ " __VERSION__},
          {"build", PROSECTOR_BUILD_TYPE},
          {"commit", PROSECTOR_COMMIT}};
}

}  // namespace prosector
