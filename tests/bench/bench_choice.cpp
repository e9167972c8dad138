#include "tests/bench/bench_choice.h"

#include <filesystem>

#include "server/calibration/table_file.h"

namespace prosector {

ChoiceOptions choice_options(const std::string& cache, RungMeter& meter) {
  ChoiceOptions out{.table_file = std::filesystem::path(cache) / "rungs.json",
                    .machine = machine_and_build(),
                    .measure = [&](const RungTrial& trial) { return meter.measure(trial); },
                    .sources = {}};
  out.sources.cache_dir = cache;
  return out;
}

}  // namespace prosector
