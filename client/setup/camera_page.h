#pragma once
// The page of a camera: what it sees, and its lens found step by step.

#include <future>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "client/setup/camera_watch.h"
#include "client/setup/config_draft.h"
#include "client/setup/interface.h"
#include "client/setup/words.h"
#include "drivers/found_devices.h"

namespace prosector {

/// Returns what names the lens of a camera: for the tracker and the window's eyes that are seen by it. Where
/// neither is, and there is no tracker, the camera becomes that.
std::vector<ConfigChange> naming_lens(const ClientConfig& config, const std::string& camera);

class CameraPage {
 public:
  CameraPage() = default;
  ~CameraPage() { fit_ends_.request_stop(); }
  CameraPage(const CameraPage&) = delete;
  CameraPage& operator=(const CameraPage&) = delete;

  void draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  /// Lets the camera go. A fit goes on.
  void close();
  bool running() const { return watch_ != nullptr || fit_.valid(); }
  const Said& said() const { return said_; }

 private:
  std::string address_;
  std::vector<FoundDevice> found_;
  std::int64_t found_ns_ = 0, opened_ns_ = 0;
  bool guides_ = false;
  std::stop_source fit_ends_;
  std::future<LensFit> fit_;  // waits for its end when it goes: who is gone asks for that before
  std::string fitted_;        // address of the camera whose lens that is
  std::vector<std::string> outcome_;
  std::unique_ptr<CameraWatch> watch_;
  WatchedPicture seen_;
  void* texture_ = nullptr;
  std::uint64_t shown_ = 0;  // picture in the texture
  Said said_;

  void open(const std::string& address, std::int64_t now_ns);
  void draw_choice(Interface& ui, std::int64_t now_ns);
  void draw_steps(Interface& ui);
  void draw_guide(Interface& ui);
  void draw_picture(Interface& ui);
  void draw_trouble(Interface& ui, std::int64_t now_ns) const;
  void begin_fit();
  void take_fit(const Interface& ui, ConfigDraft& draft);
};

}  // namespace prosector
