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

/// A control's latest position, for test scripts that click.
struct PlacedControl {
  std::string name;
  double left = 0, top = 0, right = 0, bottom = 0;  // pixels of the frame, from the top left
};

class Interface {
 public:
  /// Stores a reference to `context`, which must outlive the object. `scale`: of text and controls; `words`:
  /// translations for pages. Throws InputError as the painter does, and without fonts.
  Interface(GlContext& context, const std::filesystem::path& shaders, double scale, Catalogue words = {});
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Adds window events. A press and release within one frame is shown as pressed for one frame.
  void take(const std::vector<WindowEvent>& events);
  /// Draws a frame, `seconds` after the last one; `pages` calls ImGui.
  void draw(double seconds, const std::function<void()>& pages);
  /// Returns whether events are still queued.
  bool behind() const { return !events_.empty(); }

  /// Records the position of the last created control.
  void note(const std::string& name);
  const std::vector<PlacedControl>& placed() const { return placed_; }
  /// Returns ImGui's texture handle for an image. `instead`: a texture to replace; null: a new one.
  void* texture_of(const Image& image, void* instead = nullptr);
  double scale() const { return scale_; }
  /// Returns the translations into the user's language.
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
