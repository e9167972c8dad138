#include "client/view/contact_overlay.h"

#include <fmt/format.h>

#include <algorithm>

#include "client/text/text_block.h"
#include "client/view/overlay_frame.h"
#include "common/percent_text.h"

namespace prosector {
namespace {

constexpr double text_height = 13, padding = 7;  // points
constexpr double left = 10, bottom = 120;        // points: above the axes, left of the view's centre
const Vec3 green{0.10, 0.90, 0.20};

std::string in_words(const Vec3& v, int digits) {
  return fmt::format("{:.{}f} {:.{}f} {:.{}f}", v.x(), digits, v.y(), digits, v.z(), digits);
}

}  // namespace

std::string contact_figures(const ContactSample& contact, const std::string& body, double error,
                            const Catalogue& words) {
  const double force = contact.force.norm();
  std::string text = words.tr("touching {}", body);
  const auto line = [&](const std::string& what) { text += '\n' + what; };
  line(words.tr("depth\t{:.2f} mm", 1e3 * contact.depth));
  line(words.tr("point\t{} m", in_words(contact.point, 3)));
  line(words.tr("normal\t{}", in_words(contact.normal, 2)));
  line(words.tr("impulse\t{:.4f} N s", contact.impulse));
  line(words.tr("force\t{:.2f} N", force));
  if (error >= 0)
    line(is_known_error(error) ? words.tr("within\t{}", percent_text(error)) : words.tr("error\tunknown"));
  if (force > 0) line(words.tr("along\t{}", in_words(contact.force / force, 2)));
  return text;
}

void add_contact_overlay(DrawList& list, const ContactSample& contact, const std::string& body,
                         double error) {
  const std::string text = contact_figures(contact, body, error, list.words);
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  const double top = OverlayFrame(list).lowest - bottom - padding - text_height * height_of_lines(lines);
  list.texts.push_back({.text = text,
                        .at = {left + padding, top, 0},
                        .height = text_height,
                        .color = green,
                        .ground = TextGround::framed});
}

}  // namespace prosector
