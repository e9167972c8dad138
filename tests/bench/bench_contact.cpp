// Contact test suite: force, friction, momentum, rest, and robustness to extreme input.

#include <filesystem>

#include "tests/bench/contact_plot.h"
#include "tests/bench/contact_run.h"
#include "tests/bench/subjects.h"

namespace prosector {

const std::vector<ContactCase>& contact_cases() {
  static const std::vector<ContactCase> cases = {
      {"hertz", hertz_case}, {"incline", incline_case},   {"exchange", exchange_case},
      {"ratio", ratio_case}, {"pour", pour_case},         {"squeeze", squeeze_case},
      {"probe", probe_case}, {"teleport", teleport_case}, {"boxes", falling_boxes_case},
      {"held", held_case},   {"thrown", thrown_case},     {"layer", layer_case},
      {"usual", usual_case}, {"organ", organ_case}};
  return cases;
}

std::vector<std::string> contact_case_names() {
  std::vector<std::string> names;
  for (const ContactCase& row : contact_cases()) names.emplace_back(row.name);
  return names;
}

Report bench_contact(const ContactBenchOptions& options) {
  Report report("contact");
  ContactRows rows(report);
  for (const ContactCase& row : contact_cases()) {
    if (!options.only.empty() && options.only != row.name) continue;
    rows.begin(row.name);
    row.measure(rows, options.quick);
  }
  if (!options.picture_folder.empty())
    draw_hertz(report.rows())
        .write((std::filesystem::path(options.picture_folder) / "contact-hertz.svg").string());
  return report;
}

}  // namespace prosector
