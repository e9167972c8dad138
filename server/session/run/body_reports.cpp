#include "server/session/run/body_reports.h"

#include <utility>

namespace prosector {

BodyReports::BodyReports(const Simulation& simulation, std::map<std::string, Prospect> expected)
    : simulation_(simulation),
      expected_(std::move(expected)),
      meter_(simulation, expected_),
      metered_(simulation.body_count()) {}

void BodyReports::add_pieces() {
  for (; metered_ < simulation_.body_count(); ++metered_)
    meter_.add_body(simulation_, static_cast<BodyId>(metered_));
}

std::vector<Outgoing> BodyReports::take() {
  std::vector<Outgoing> out = parts_.take(simulation_);
  for (const BodyStatus& status : meter_.take(simulation_)) out.push_back({status});
  return out;
}

void BodyReports::restart() {
  meter_ = BodyMeter(simulation_, expected_);
  metered_ = simulation_.body_count();
}

}  // namespace prosector
