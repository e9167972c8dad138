#include "client/app/session/client_report.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <nlohmann/json.hpp>

#include "common/clock.h"
#include "common/error.h"

namespace prosector {

ArrivalLog::ArrivalLog(const std::filesystem::path& file) : out_(file) {
  if (!out_) throw InputError(fmt::format("--latency-log {}: cannot be written", file.string()));
  out_ << "arrived_ns,participant,sequence,tick\n";
}

void ArrivalLog::received(const Received& received) {
  const auto* user = std::get_if<UserState>(&received.message);
  if (user == nullptr || received.liveness == Liveness::gone) return;
  std::uint64_t& last = last_sequence_[user->participant];
  if (user->input_sequence == last) return;
  last = user->input_sequence;
  fmt::print(out_, "{},{},{},{}\n", received.arrival_ns, user->participant, user->input_sequence,
             user->time.tick);
}

void write_report(const ClientReport& report, Connection& connection, const std::filesystem::path& file) {
  const std::int64_t now = monotonic_ns();
  const auto ms_since_start = [&](const std::optional<std::int64_t>& t) -> nlohmann::json {
    if (!t) return nullptr;
    return 1e-6 * static_cast<double>(*t - report.started_ns);
  };
  const BusCounters counters = connection.counters();
  nlohmann::json out;
  out["name"] = connection.name();
  out["join_ms"] = ms_since_start(report.joined_ns);
  out["late_join_ms"] = ms_since_start(report.complete_ns);
  out["first_picture_ms"] = ms_since_start(report.first_picture_ns);
  out["bytes_in"] = counters.bytes_in;
  if (report.complete_ns && now > *report.complete_ns)
    out["stream_kbit_s"] = 8e-3 * static_cast<double>(counters.bytes_in - report.bytes_at_complete) /
                           (1e-9 * static_cast<double>(now - *report.complete_ns));
  out["invalid_dropped"] = counters.dropped_total;
  out["pictures"] = report.pictures;
  out["ms_per_picture"] =
      report.pictures > 0 ? 1e3 * report.drawing_seconds / static_cast<double>(report.pictures) : 0.0;
  out["longest_picture_ms"] = 1e3 * report.longest_drawing_seconds;
  out["renderer"] = report.renderer;
  if (report.pacing)
    out["headset"] = {
        {"frames", report.pacing->frames()},           {"in_time", report.pacing->in_time()},
        {"missed", report.pacing->missed()},           {"period_ms", report.pacing->period_ms()},
        {"interval_ms", report.pacing->interval_ms()}, {"longest_interval_ms", report.pacing->longest_ms()}};
  connection.with_replica([&](Replica& replica) {
    out["playout_delay_ms"] = replica.time().playout_delay_ms();
    out["topology_hash"] = to_hex(replica.bodies().topology_hash());
    out["contradictions"] = replica.refused();
  });
  std::ofstream stream(file);
  stream << out.dump(2) << "\n";
  if (!stream) fmt::print(stderr, "--summary {}: cannot be written\n", file.string());
}

}  // namespace prosector
