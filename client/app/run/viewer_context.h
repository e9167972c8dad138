#pragma once
// State that the viewer and its view mode share.

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "client/app/desk/figures.h"
#include "client/app/run/options.h"
#include "client/app/session/client_report.h"
#include "client/app/session/connection.h"
#include "client/app/terminal/console.h"
#include "client/view/message_lines.h"
#include "client/view/parts_choice.h"
#include "common/clock.h"

namespace prosector {

struct ViewerContext {
  /// Creates the state that the viewer and its view mode share; the references must outlive it. `print`
  /// prints a line in the terminal.
  ViewerContext(const ClientOptions& client_options, Connection& session_connection,
                const ClientReport& client_report, std::function<void(const std::string&)> print)
      : options(client_options),
        connection(session_connection),
        report(client_report),
        print_line(std::move(print)),
        figures(client_options.words),
        messages(client_options.words) {}
  ViewerContext(const ViewerContext&) = delete;
  ViewerContext& operator=(const ViewerContext&) = delete;

  /// Shows a message line in the frames for its reading time.
  void say(const std::string& line, MessageKind kind) {
    messages.say(line, seconds_since(report.joined_ns), kind);
  }
  /// Prints a line in the terminal, and shows it as a message in the frames.
  void inform(const std::string& line) {
    print_line(line);
    say(line, MessageKind::news);
  }

  const ClientOptions& options;
  Connection& connection;
  const ClientReport& report;
  std::function<void(const std::string&)> print_line;
  Figures figures;
  MessageLines messages;
  PartsChoice parts;
  std::optional<LookFrom> looks_from;  // camera requested at the terminal; nullopt: the scene's
};

}  // namespace prosector
