#pragma once
// Lists connected hardware that a driver may support, for the user to choose from. No device is opened.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// A device found on this computer: its name for the user, and the addresses of drivers that may fit it.
struct FoundDevice {
  std::string name;                    // "ttyUSB0: FTDI USB serial", "hidraw3: 5DT Data Glove"
  std::vector<std::string> addresses;  // "fastrak:/dev/ttyUSB0", "5dt:/dev/ttyUSB0"
};

/// Lists the serial ports and USB data gloves of this computer. `root` is the root of the file system,
/// another one than "/" only in tests.
std::vector<FoundDevice> found_devices(const std::filesystem::path& root = "/");
/// Lists the cameras of this computer, each once although it may have several device files. An example is the
/// name "video0: HD Webcam" with the address "/dev/video0".
std::vector<FoundDevice> found_cameras(const std::filesystem::path& root = "/");

}  // namespace prosector
