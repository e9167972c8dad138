// The table of drivers.
#include <algorithm>

#include "drivers/camera/face/face_device.h"
#include "drivers/camera/hands/hands_device.h"
#include "drivers/device.h"
#include "drivers/device_address.h"
#include "drivers/fastrak.h"
#include "drivers/five_dt.h"
#include "drivers/igtl_device.h"
#include "drivers/leap_device.h"
#include "drivers/recorded.h"
#include "drivers/space_mouse.h"
#include "drivers/tags_device.h"
#include "drivers/vrpn_device.h"

namespace prosector {

const std::vector<DriverRow>& drivers() {
  static const std::vector<DriverRow> rows = {
      {"fastrak", "Polhemus FASTRAK tracker on a serial port, fastrak:/dev/ttyS0", open_fastrak},
      {"5dt", "5DT Data Glove 5 on a serial port, 5dt:/dev/ttyS1", open_five_dt},
      {"5dt-wireless", "wireless 5DT Data Glove at its receiver's serial port, 5dt-wireless:/dev/ttyS1",
       open_five_dt_wireless},
      {"5dt-usb", "5DT Data Glove Ultra over USB, 5dt-usb:/dev/hidraw0", open_five_dt_usb},
      {"vrpn", "a tracker, buttons, analog or dials of a VRPN server, vrpn:Tracker0@lab", open_vrpn_device},
      {"igtl", "a tracker of an OpenIGTLink server, igtl:HOST[:PORT][/TOOL,TOOL,...]", open_igtl},
      {"leap", "both hands by Ultraleap's WebSocket, leap:localhost:6437", open_leap, true},
      {"spacemouse", "a SpaceMouse by spacenavd's socket, spacemouse:/run/spnav.sock", open_space_mouse},
      {"tags",
       "printed boards before a camera, tags:0, tags:/dev/video0, tags:clip.mkv, tags:synthetic:SCENE.toml",
       open_tags, false, true},
      {"hands", "bare hands before a camera, or two, hands:CAMERA[,CAMERA] as with tags", open_hands, true,
       true},
      {"face", "the eyes of a face before a camera, face:CAMERA as with tags; station 1 is between them",
       open_face, false, true, true},
      {"recorded", "samples from a CSV file, played once, recorded:hand.csv", open_recorded},
      {"recorded-loop", "the same, again and again, recorded-loop:hand.csv", open_recorded_loop},
  };
  return rows;
}

DeviceAddress parse_device_address(const std::string& address) {
  return split_address("device", address, drivers());
}

const DriverRow& driver_of(const std::string& address) {
  const DeviceAddress parsed = parse_device_address(address);
  return *std::find_if(drivers().begin(), drivers().end(),
                       [&](const DriverRow& r) { return parsed.driver == r.name; });
}

std::string first_camera(const std::string& address) {
  if (address.empty() || !driver_of(address).is_camera) return "";
  const std::string path = parse_device_address(address).path;
  return path.substr(0, path.find(','));
}

std::unique_ptr<Device> open_device(const std::string& address, const DeviceConfig& config) {
  return driver_of(address).open(parse_device_address(address).path, config);
}

}  // namespace prosector
