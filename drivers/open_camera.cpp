#include <string_view>

#include "drivers/camera/base/camera.h"
#include "drivers/camera/capture/igtl_camera.h"
#include "drivers/camera/capture/video_camera.h"
#include "twins/camera/synthetic_camera.h"

namespace prosector {

std::unique_ptr<Camera> open_camera(const std::string& address, std::int64_t start_ns) {
  constexpr std::string_view synthetic = "synthetic:";
  if (address.starts_with(synthetic))
    return std::make_unique<SyntheticCamera>(SyntheticScene::load(address.substr(synthetic.size())),
                                             start_ns);
  if (is_igtl_camera(address)) return open_igtl_camera(address);
  return open_video(address);
}

}  // namespace prosector
