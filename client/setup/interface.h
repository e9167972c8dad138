#pragma once
// `Dear ImGui` in the client's renderer: window events become its input, and InterfacePainter draws its
// triangles, in a window or offscreen. Pages call ImGui between the beginning and end of a frame.

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/language/catalogue.h"
#include "client/render/interface_painter.h"
#include "client/render/window_context.h"

struct ImGuiContext;

namespace prosector {

/// Name and latest position of a control of the set-up window, for test scripts that click it.
struct PlacedControl {
  std::string name;
  double left = 0, top = 0, right = 0, bottom = 0;  // pixels of the frame, from the top left
};

class Interface {
 public:
  /// Creates the user interface. `context` must outlive it; `scale` is the factor of the sizes of text and
  /// controls; `words` are the translations. Throws InputError if OpenGL, a shader or the fonts are
  /// unavailable.
  Interface(GlContext& context, const std::filesystem::path& shaders, double scale, Catalogue words = {});
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Queues window events for the next frames. If a button or key is pressed and released between two frames,
  /// it is still shown as pressed for one frame.
  void take(const std::vector<WindowEvent>& events);
  /// Draws a frame: passes queued events to ImGui, calls `pages`, which calls ImGui's functions, and draws
  /// the resulting controls. `seconds`: time since the last frame.
  void draw(double seconds, const std::function<void()>& pages);
  /// Returns whether window events are still queued, so that a further frame must be drawn soon.
  bool behind() const { return !events_.empty(); }

  /// Records the position of ImGui's last created control under this name, for placed().
  void note(const std::string& name);
  const std::vector<PlacedControl>& placed() const { return placed_; }
  /// Uploads an image and returns its texture handle for ImGui. `instead`: handle of a texture whose image to
  /// replace; null: creates a new texture.
  void* texture_of(const Image& image, void* instead = nullptr);
  double scale() const { return scale_; }
  /// Returns the translations of the set-up window's texts into the user's language.
  const Catalogue& words() const { return words_; }
  const char* tr(const char* english) const { return words_.tr(english); }
  std::string tr(const std::string& english) const { return words_.tr(english); }
  template <class First, class... More>
  std::string tr(fmt::format_string<First, More...> english, First&& first, More&&... more) const {
    return words_.tr(english, std::forward<First>(first), std::forward<More>(more)...);
  }
  Image read_pixels() const { return painter_.read_pixels(); }

 private:
  GlContext& context_;
  InterfacePainter painter_;
  double scale_;
  Catalogue words_;
  ImGuiContext* imgui_;
  std::deque<WindowEvent> events_;
  std::vector<PlacedControl> placed_;

  void make_fonts();
  void take_in();
  bool take_in(const WindowEvent& event);
  std::vector<InterfaceDraw> triangles() const;
};

}  // namespace prosector
