#pragma once
// What is plugged in that a driver may be for: candidates, for people to choose from. None is opened.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// A device file, what it calls itself, and the addresses under which it might be used.
struct FoundDevice {
  std::string name;                    // "ttyUSB0: FTDI USB serial", "hidraw3: 5DT Data Glove"
  std::vector<std::string> addresses;  // "fastrak:/dev/ttyUSB0", "5dt:/dev/ttyUSB0"
};

/// Lists serial ports and gloves on USB. `root`: of the file system, for tests.
std::vector<FoundDevice> found_devices(const std::filesystem::path& root = "/");
/// Lists cameras, each once: "video0: HD Webcam" at "/dev/video0".
std::vector<FoundDevice> found_cameras(const std::filesystem::path& root = "/");

}  // namespace prosector
