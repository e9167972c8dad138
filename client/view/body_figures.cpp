#include "client/view/body_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/counted.h"
#include "common/percent_text.h"

namespace prosector {

std::string body_figures(const SceneBody& body, const BodyStatus& status) {
  std::string text = body.name;
  text += fmt::format("\n{} of {:.3g} ms", counted(std::max(1u, status.substeps), "step"), 1e3 * status.step);
  if (status.asleep) text += "\nat rest";
  if (!status.asleep && !status.converged) text += "\nnot converged";
  if (status.error >= 0)
    text += is_known_error(status.error) ? fmt::format("\n{} off", percent_text(status.error))
                                         : "\nerror not known";
  if (status.press_error >= 0)
    text += is_known_error(status.press_error)
                ? fmt::format("\npressed: force within {}", percent_text(status.press_error))
                : "\npressed: error not known";
  if (status.stepped_down > 0) text += fmt::format("\nstepped down {}", status.stepped_down);
  return text;
}

}  // namespace prosector
