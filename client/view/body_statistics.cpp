#include "client/view/body_statistics.h"

#include <algorithm>

#include "common/percent_text.h"

namespace prosector {

std::string body_figures(const SceneBody& body, const BodyStatus& status, const Catalogue& words) {
  std::string text = body.name;
  const auto line = [&](const std::string& what) { text += '\n' + what; };
  const unsigned steps = std::max(1u, status.substeps);
  const double ms = 1e3 * status.step;
  line(steps == 1 ? words.tr("1 step of {:.3g} ms", ms) : words.tr("{} steps of {:.3g} ms", steps, ms));
  if (status.asleep) line(words.tr("at rest"));
  if (!status.asleep && !status.converged) line(words.tr("not converged"));
  if (status.error >= 0)
    line(is_known_error(status.error) ? words.tr("error {}", percent_text(status.error))
                                      : words.tr("error unknown"));
  if (status.press_error >= 0)
    line(is_known_error(status.press_error)
             ? words.tr("pressed: force within {}", percent_text(status.press_error))
             : words.tr("pressed: error unknown"));
  if (status.stepped_down > 0) line(words.tr("effort reduced by {}", status.stepped_down));
  return text;
}

}  // namespace prosector
