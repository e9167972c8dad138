// prosector-client: join or observe a session.

#include <fmt/format.h>

#include <new>

#include "client/app/commands/render_scene.h"
#include "client/app/run/options.h"
#include "client/app/run/run_client.h"
#include "client/app/run/run_setup.h"
#include "common/clock.h"
#include "common/error.h"
#include "common/process_limits.h"

int main(int argc, char** argv) {
  const std::int64_t started_ns = prosector::monotonic_ns();
  try {
    const auto parsed = prosector::parse_command_line(argc, argv);
    if (const int* code = std::get_if<int>(&parsed)) return *code;
    prosector::check_process_limits();
    if (const auto* task = std::get_if<prosector::Task>(&parsed)) return (*task)();
    if (const auto* render = std::get_if<prosector::RenderOptions>(&parsed))
      return prosector::render_scene(*render);
    if (const auto* setup = std::get_if<prosector::SetupOptions>(&parsed))
      return prosector::run_setup(*setup);
    return prosector::run_client(std::get<prosector::ClientOptions>(parsed), started_ns);
  } catch (const prosector::InputError& error) {
    fmt::print(stderr, "prosector-client: {}\n", error.what());
    return 2;
  } catch (const prosector::InternalError& error) {
    fmt::print(stderr, "prosector-client: internal error: {}. Please report this.\n", error.what());
    return 1;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "prosector-client: out of memory\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "prosector-client: unexpected: {}\n", error.what());
    return 1;
  }
}
