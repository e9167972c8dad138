#pragma once
// Dear ImGui in the client's own pictures: what happened in a window becomes its input, and its triangles are
// drawn by our painter, in a window as offscreen. Pages call ImGui between the beginning and end of a
// picture.

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

/// Where a control was drawn last, for scripts that click.
struct PlacedControl {
  std::string name;
  double left = 0, top = 0, right = 0, bottom = 0;  // pixels of the picture, from the top left
};

class Interface {
 public:
  /// Takes a `context` that outlives it. `scale`: of letters and controls; `words`: of what pages say. Throws
  /// InputError as the painter does, and where there is no font.
  Interface(GlContext& context, const std::filesystem::path& shaders, double scale, Catalogue words = {});
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Takes what happened. What is pressed and let go within one picture is shown pressed for one.
  void take(const std::vector<WindowEvent>& events);
  /// Makes a picture, `seconds` after the last; `pages` calls ImGui.
  void draw(double seconds, const std::function<void()>& pages);
  /// Tells whether what happened is not all taken in yet.
  bool behind() const { return !events_.empty(); }

  /// Notes where the control is that was made last.
  void note(const std::string& name);
  const std::vector<PlacedControl>& placed() const { return placed_; }
  /// Returns what ImGui shows a picture by. It may take the place of one that was shown before.
  void* texture_of(const Image& image, void* instead = nullptr);
  double scale() const { return scale_; }
  /// Returns a text in the user's language (Catalogue).
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
