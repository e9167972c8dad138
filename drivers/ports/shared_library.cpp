#include "drivers/ports/shared_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "common/error.h"

namespace prosector {

LibraryAddress split_library(const std::string& path, const char* usual) {
  const auto at = path.find('@');
  if (at == std::string::npos) return {path, usual};
  return {path.substr(0, at), path.substr(at + 1)};
}

SharedLibrary::SharedLibrary(const std::string& name)
    : name_(name), handle_(::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
  if (handle_ != nullptr) return;
  const char* why = ::dlerror();
  throw InputError(
      fmt::format("the vendor's library '{}' cannot be loaded ({}); install it, or append its file to the "
                  "device: DEVICE@/path/to/library.so",
                  name, why != nullptr ? why : "no reason given"));
}

void* SharedLibrary::symbol(const char* name) const {
  if (void* found = ::dlsym(handle_, name)) return found;
  throw InputError(
      fmt::format("library '{}' has no function {}: it is a different library or version", name_, name));
}

}  // namespace prosector
