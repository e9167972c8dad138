#include "client/view/contact_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "client/view/overlay_frame.h"

namespace prosector {
namespace {

constexpr double text_height = 13, padding = 7;             // points
constexpr double left = 118, bottom = message_band;         // points: right of the axes
constexpr double line_spacing = 1.3, letter_width = 0.615;  // of a line's height
const Vec3 green{0.10, 0.90, 0.20};

std::string in_words(const Vec3& v, int digits) {
  return fmt::format("{:.{}f} {:.{}f} {:.{}f}", v.x(), digits, v.y(), digits, v.z(), digits);
}

}  // namespace

std::string contact_figures(const ContactSample& contact, const std::string& body) {
  const double force = contact.force.norm();
  std::string text = fmt::format("touching {}\n", body);
  text += fmt::format("depth   {:.2f} mm\n", 1e3 * contact.depth);
  text += fmt::format("point   {} m\n", in_words(contact.point, 3));
  text += fmt::format("normal  {}\n", in_words(contact.normal, 2));
  text += fmt::format("impulse {:.4f} N s\n", contact.impulse);
  text += fmt::format("force   {:.2f} N", force);
  if (force > 0) text += fmt::format("\nalong   {}", in_words(contact.force / force, 2));
  return text;
}

void add_contact_overlay(DrawList& list, const ContactSample& contact, const std::string& body) {
  const std::string text = contact_figures(contact, body);
  std::size_t longest = 0, length = 0;
  double lines = 1;
  for (const char c : text) {
    length = c == '\n' ? 0 : length + 1;
    longest = std::max(longest, length);
    if (c == '\n') ++lines;
  }
  const OverlayFrame frame(list);
  const double width = letter_width * text_height * static_cast<double>(longest) + 2 * padding;
  const double height = text_height * (1 + line_spacing * (lines - 1)) + 2 * padding;
  const double right = left + width, below = frame.height - bottom, top = below - height;
  const std::array<Vec3, 4> box = {frame.at(left, below), frame.at(right, below), frame.at(right, top),
                                   frame.at(left, top)};
  for (std::size_t k = 0; k < box.size(); ++k)
    list.lines.push_back({box[k], box[(k + 1) % box.size()], green, 2, true});
  list.texts.push_back(
      {.text = text, .at = {left + padding, top + padding, 0}, .height = text_height, .color = green});
}

}  // namespace prosector
