#pragma once
// Vendor libraries that are loaded when a driver needs them. Prosector builds and runs without them.

#include <string>

namespace prosector {

/// Device and vendor library of a device address "NAME@LIBRARY": the device's name, and the library's file.
/// Without '@' the library is the driver's usual one, which the dynamic loader searches for.
struct LibraryAddress {
  std::string device, library;
};
LibraryAddress split_library(const std::string& path, const char* usual);

class SharedLibrary {
 public:
  /// Loads a shared library by its path, or by a `name` that the dynamic loader searches for. Throws
  /// InputError that names the library on failure. The library stays loaded until the program ends, because
  /// vendor libraries run their own threads.
  explicit SharedLibrary(const std::string& name);

  /// Looks up the library's function `name` and stores its address in `out`. Throws InputError that names
  /// function and library if it is missing.
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
