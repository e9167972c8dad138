#pragma once
// The device's end of a simulated serial cable.

#include <string>

namespace prosector {

class PseudoTerminal {
 public:
  PseudoTerminal() = default;
  ~PseudoTerminal() { close(); }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Makes a raw terminal and, if `link` isn't empty, points that symbolic link to it. Throws InputError when
  /// that fails.
  void open(const std::string& link);
  /// Hangs up, as when the plug is pulled; removes the link.
  void close();
  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  const std::string& path() const { return path_; }

 private:
  int descriptor_ = -1,
      client_side_ = -1;  // the client's side is held open too, so that clients may come and go
  std::string path_, link_;
};

}  // namespace prosector
