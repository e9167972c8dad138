#pragma once
// A run of the hosted session, recorded.

#include "server/session/journal/journal.h"
#include "tests/session/hosted.h"
#include "tests/session/temporary_file.h"

namespace prosector::test {

inline JournalHeader header_of(const Simulation& simulation) {
  return {"scene.toml", "name = \"hosted\"", "prosector", simulation.content_hash(), {}};
}

/// Records a press of `ticks` ticks; returns the last hash.
inline std::uint64_t record(const std::filesystem::path& file, std::uint64_t ticks, int threads = 1) {
  const auto journal =
      Journal::create(file, header_of(Simulation(hosted_scene(), options())), JournalLimits{});
  Hosted hosted({}, journal.get(), threads);
  Guest ada = hosted.guest(1, BusEnd::dissector);
  ada.greet("ada", Role::dissector);
  for (std::uint64_t t = 0; t < ticks; ++t) {
    ada.bus->publish(ada.hand_at(press(t)));
    if (t == 70) ada.command(Grasp{});
    hosted.tick();
  }
  hosted.loop.finish();
  return hosted.simulation.state_hash();
}

}  // namespace prosector::test
