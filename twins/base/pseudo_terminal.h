#pragma once
// The device's end of a simulated serial cable: a pseudo-terminal.

#include <string>

namespace prosector {

class PseudoTerminal {
 public:
  PseudoTerminal() = default;
  ~PseudoTerminal() { close(); }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Creates a pseudo-terminal in raw mode and, if `link` is not empty, a symbolic link of this name to it.
  /// Throws InputError on failure.
  void open(const std::string& link);
  /// Closes the pseudo-terminal, so that the client's side hangs up as when the cable is unplugged, and
  /// removes the symbolic link.
  void close();
  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  const std::string& path() const { return path_; }

 private:
  int descriptor_ = -1,
      client_side_ = -1;  // keeps the client's side open, so that clients can reconnect
  std::string path_, link_;
};

}  // namespace prosector
