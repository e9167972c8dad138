#include "client/view/contact_overlay.h"

#include <fmt/format.h>

#include <algorithm>

#include "client/text/text_block.h"
#include "client/view/overlay_frame.h"
#include "common/percent_text.h"

namespace prosector {
namespace {

constexpr double text_height = 13, padding = 7;  // points
constexpr double left = 10, bottom = 120;        // points: above the axes, left of the middle of the picture
const Vec3 green{0.10, 0.90, 0.20};

std::string in_words(const Vec3& v, int digits) {
  return fmt::format("{:.{}f} {:.{}f} {:.{}f}", v.x(), digits, v.y(), digits, v.z(), digits);
}

}  // namespace

std::string contact_figures(const ContactSample& contact, const std::string& body, double error) {
  const double force = contact.force.norm();
  std::string text = fmt::format("touching {}\n", body);
  text += fmt::format("depth\t{:.2f} mm\n", 1e3 * contact.depth);
  text += fmt::format("point\t{} m\n", in_words(contact.point, 3));
  text += fmt::format("normal\t{}\n", in_words(contact.normal, 2));
  text += fmt::format("impulse\t{:.4f} N s\n", contact.impulse);
  text += fmt::format("force\t{:.2f} N", force);
  if (error >= 0)
    text += is_known_error(error) ? fmt::format("\nwithin\t{}", percent_text(error)) : "\nerror\tnot known";
  if (force > 0) text += fmt::format("\nalong\t{}", in_words(contact.force / force, 2));
  return text;
}

void add_contact_overlay(DrawList& list, const ContactSample& contact, const std::string& body,
                         double error) {
  const std::string text = contact_figures(contact, body, error);
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  const double top = OverlayFrame(list).lowest - bottom - padding - text_height * height_of_lines(lines);
  list.texts.push_back({.text = text,
                        .at = {left + padding, top, 0},
                        .height = text_height,
                        .color = green,
                        .ground = TextGround::framed});
}

}  // namespace prosector
