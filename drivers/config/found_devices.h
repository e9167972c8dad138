#pragma once
// Lists connected hardware that a driver may support, for the user to choose from. No device is opened.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// A device file, its name, and the addresses that may fit it.
struct FoundDevice {
  std::string name;                    // "ttyUSB0: FTDI USB serial", "hidraw3: 5DT Data Glove"
  std::vector<std::string> addresses;  // "fastrak:/dev/ttyUSB0", "5dt:/dev/ttyUSB0"
};

/// Lists serial ports and USB gloves. `root` is the root of the file system, for tests.
std::vector<FoundDevice> found_devices(const std::filesystem::path& root = "/");
/// Lists cameras, once each: "video0: HD Webcam" at "/dev/video0".
std::vector<FoundDevice> found_cameras(const std::filesystem::path& root = "/");

}  // namespace prosector
