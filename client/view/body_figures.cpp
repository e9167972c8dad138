#include "client/view/body_figures.h"

#include <fmt/format.h>

namespace prosector {

std::string body_figures(const SceneBody& body, const BodyStatus& status) {
  std::string text = body.name;
  if (status.substeps > 0)
    text += fmt::format("\n{} steps of {:.3g} ms", status.substeps, 1e3 * status.step);
  else
    text += fmt::format("\n1 step of {:.3g} ms", 1e3 * status.step);
  if (status.asleep) text += "\nat rest";
  if (!status.asleep && !status.converged) text += "\nnot converged";
  if (status.error >= 0) text += fmt::format("\n{:.2g} % off", 100 * status.error);
  if (status.stepped_down > 0) text += fmt::format("\nstepped down {}", status.stepped_down);
  return text;
}

}  // namespace prosector
