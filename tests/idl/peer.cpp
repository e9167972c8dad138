// A small peer for tests between processes.
//   peer serve MEGABYTES [lan|wan IFACE]            a server with that many MB of assets, states at 30 Hz
//   peer join SECONDS [lan|wan IFACE [SERVER]]      prints when it had all assets, and how many states were
//   lost peer announce ID DOMAIN                         joins on loopback, publishes Presence, waits to be
//   killed

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "idl/cyclone_bus.h"
#include "tests/dds_domains.h"

using namespace prosector;
using namespace std::chrono_literals;

namespace {

constexpr std::uint32_t domain = test::dds_domain::peer;
constexpr std::uint32_t chunks_per_frame = 8;
constexpr double tolerated_loss_percent = 5;  // the worst link of the tests loses 1 %

BusConfig config_of(BusEnd end, int argc, char** argv) {
  BusConfig config;
  config.end = end;
  config.domain = domain;
  if (argc > 3) config.profile = argv[3];
  if (argc > 4) config.interface = argv[4];
  if (argc > 5) config.peers.emplace_back(argv[5]);
  return config;
}

void publish_assets(Bus& bus, std::uint32_t megabytes) {
  AssetChunk chunk;
  chunk.total_bytes = megabytes * 1024 * 1024;
  chunk.chunks = static_cast<std::uint32_t>(chunk.total_bytes / asset_chunk_bytes);
  chunk.bytes.assign(asset_chunk_bytes, 0x5a);
  for (chunk.chunk = 0; chunk.chunk < chunk.chunks; ++chunk.chunk) bus.publish(chunk);
}

int serve(int argc, char** argv) {
  const auto bus = make_cyclone_bus(config_of(BusEnd::server, argc, argv));
  bus->publish(SessionInfo{protocol_version, "prosector", "assets", {}, 60, 8, 1});
  publish_assets(*bus, static_cast<std::uint32_t>(std::atoi(argv[2])));
  SoftState state;
  state.positions.assign(soft_chunk_points, Vec3(0.1, 0.2, 0.3));
  state.positions[0] = {0.3, 0.3, 0.4};
  state.velocities.assign(soft_chunk_points, Vec3::Zero());
  for (state.time.tick = 0;; ++state.time.tick) {
    for (state.chunk = 0; state.chunk < chunks_per_frame; ++state.chunk) bus->publish(state);
    std::this_thread::sleep_for(33ms);
  }
}

/// Ticks seen of each chunk: what lies between the first and the last and wasn't seen is lost.
struct Stream {
  std::uint64_t first = 0, last = 0, seen = 0;
};

int join(int argc, char** argv) {
  const std::int64_t start = monotonic_ns();
  const std::int64_t end = start + static_cast<std::int64_t>(std::atof(argv[2]) * 1e9);
  const auto bus = make_cyclone_bus(config_of(BusEnd::observer, argc, argv));
  const auto ms_since_start = [start] { return static_cast<double>(monotonic_ns() - start) / 1e6; };
  std::vector<Received> received;
  std::map<std::uint32_t, Stream> streams;
  std::size_t chunks = 0;
  bool complete = false;
  while (monotonic_ns() < end) {
    bus->wait(5ms);
    bus->take(received);
    for (const Received& r : received) {
      if (std::holds_alternative<SessionInfo>(r.message)) fmt::print("found_ms {:.1f}\n", ms_since_start());
      if (const auto* asset = std::get_if<AssetChunk>(&r.message); asset && ++chunks == asset->chunks) {
        fmt::print("late_join_ms {:.1f}\n", ms_since_start());
        streams.clear();  // loss is told for the time after
        complete = true;
      }
      if (const auto* state = std::get_if<SoftState>(&r.message)) {
        Stream& stream = streams[state->chunk];
        if (stream.seen++ == 0) stream.first = state->time.tick;
        stream.last = std::max(stream.last, state->time.tick);
      }
    }
  }
  std::uint64_t sent = 0, seen = 0;
  for (const auto& [chunk, stream] : streams) {
    sent += stream.last - stream.first + 1;
    seen += stream.seen;
  }
  const double lost =
      sent == 0 ? 100.0 : 100.0 * static_cast<double>(sent - seen) / static_cast<double>(sent);
  fmt::print("stream_loss_percent {:.2f} of {}\n", lost, sent);
  return complete && lost <= tolerated_loss_percent ? 0 : 1;
}

int announce(char** argv) {
  BusConfig config;
  config.domain = static_cast<std::uint32_t>(std::atoi(argv[3]));
  const auto bus = make_cyclone_bus(config);
  bus->publish(Presence{static_cast<ParticipantId>(std::atoll(argv[2])), protocol_version, "peer",
                        Role::observer, ""});
  for (;;) std::this_thread::sleep_for(1s);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 2 ? argv[1] : "";
  try {
    if (mode == "serve") return serve(argc, argv);
    if (mode == "join") return join(argc, argv);
    if (mode == "announce" && argc == 4) return announce(argv);
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  fmt::print(stderr, "usage: peer serve MB | join SECONDS | announce ID DOMAIN\n");
  return 2;
}
