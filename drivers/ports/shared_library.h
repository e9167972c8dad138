#pragma once
// Vendor libraries that are loaded when a driver needs them. Prosector builds and runs without them.

#include <string>

namespace prosector {

/// Device and library file of an address "NAME@LIBRARY" of a driver behind a library. Without '@' the library
/// is `usual`, which the loader searches for.
struct LibraryAddress {
  std::string device, library;
};
LibraryAddress split_library(const std::string& path, const char* usual);

class SharedLibrary {
 public:
  /// Loads a file, or a library that the loader finds by `name`. Throws InputError naming it on failure. It
  /// stays loaded until the program ends, because vendor libraries run their own threads.
  explicit SharedLibrary(const std::string& name);

  /// Looks up a function by name. Throws InputError naming function and library if it is missing.
  template <class Function>
  void find(const char* name, Function*& out) const {
    out = reinterpret_cast<Function*>(symbol(name));
  }
  const std::string& name() const { return name_; }

 private:
  void* symbol(const char* name) const;

  std::string name_;
  void* handle_;
};

}  // namespace prosector
