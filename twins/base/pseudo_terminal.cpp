#include "twins/base/pseudo_terminal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "common/error.h"

namespace prosector {

void PseudoTerminal::open(const std::string& link) {
  close();
  const auto fail = [](const std::string& what) {
    throw InputError(fmt::format("{}: {}", what, std::strerror(errno)));
  };
  descriptor_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 128> name{};
  if (descriptor_ < 0 || grantpt(descriptor_) != 0 || unlockpt(descriptor_) != 0 ||
      ptsname_r(descriptor_, name.data(), name.size()) != 0)
    fail("cannot make a pseudo-terminal");
  path_ = name.data();
  client_side_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios line{};
  if (client_side_ < 0 || tcgetattr(client_side_, &line) != 0) fail(fmt::format("cannot open {}", path_));
  cfmakeraw(&line);
  if (tcsetattr(client_side_, TCSANOW, &line) != 0) fail(fmt::format("cannot set {}", path_));
  if (link.empty()) return;
  std::error_code error;
  if (std::filesystem::is_symlink(link, error)) std::filesystem::remove(link, error);
  std::filesystem::create_symlink(path_, link, error);
  if (error) throw InputError(fmt::format("{}: cannot create the link: {}", link, error.message()));
  link_ = link;
}

void PseudoTerminal::close() {
  std::error_code ignored;
  if (!link_.empty()) std::filesystem::remove(link_, ignored);
  link_.clear();
  if (client_side_ >= 0) ::close(client_side_);
  if (descriptor_ >= 0) ::close(descriptor_);
  client_side_ = descriptor_ = -1;
}

}  // namespace prosector
