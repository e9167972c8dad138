#pragma once
// The page of a camera: its image, and a guided lens calibration.

#include <future>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "client/setup/camera_watch.h"
#include "client/setup/config_draft.h"
#include "client/setup/interface.h"
#include "client/setup/text_styles.h"
#include "drivers/config/found_devices.h"

namespace prosector {

/// Returns the changes of the configuration that assign the lens file (a camera's lens calibration) to the
/// tracker and to the window's eye tracker, if they use `camera`. If neither does and no tracker is
/// configured, the camera becomes the tracker.
std::vector<ConfigChange> lens_changes(const ClientConfig& config, const std::string& camera);

class CameraPage {
 public:
  CameraPage() = default;
  ~CameraPage() { fit_ends_.request_stop(); }
  CameraPage(const CameraPage&) = delete;
  CameraPage& operator=(const CameraPage&) = delete;

  void draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  /// Closes the camera, so that another program can use it. A running fit of its lens continues.
  void close();
  bool running() const { return watch_ != nullptr || fit_.valid(); }
  const Said& said() const { return said_; }

 private:
  std::string address_;
  std::vector<FoundDevice> found_;
  std::int64_t found_ns_ = 0, opened_ns_ = 0;
  bool guides_ = false;
  std::stop_source fit_ends_;
  // Its destructor waits for the fit, so the page's destructor requests a stop first.
  std::future<LensFit> fit_;
  std::string fitted_;  // address of the camera that the fit is for
  std::vector<std::string> outcome_;
  std::unique_ptr<CameraWatch> watch_;
  EvaluatedImage seen_;
  void* texture_ = nullptr;
  std::uint64_t shown_ = 0;  // number of the image in the texture
  Said said_;

  void open(const std::string& address, std::int64_t now_ns);
  void draw_choice(Interface& ui, std::int64_t now_ns);
  void draw_steps(Interface& ui);
  void draw_guide(Interface& ui);
  void draw_picture(Interface& ui);
  void draw_error(Interface& ui, std::int64_t now_ns) const;
  void begin_fit();
  void take_fit(const Interface& ui, ConfigDraft& draft);
};

}  // namespace prosector
