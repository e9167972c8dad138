#pragma once
// A vendor's library that is opened when a driver needs it. None is needed to build, nor to run without it.

#include <string>

namespace prosector {

/// Splits "NAME@LIBRARY", as addresses of drivers behind libraries have it: the device, and the library's
/// file. Without '@' the library is `usual`, which the loader looks for.
struct LibraryAddress {
  std::string device, library;
};
LibraryAddress split_library(const std::string& path, const char* usual);

class SharedLibrary {
 public:
  /// Opens a file, or what the loader finds by that name. Throws InputError naming it. It stays loaded until
  /// the program ends: vendors' libraries have threads of their own.
  explicit SharedLibrary(const std::string& name);

  /// Fills in the function of that name. Throws InputError naming function and library where it has none.
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
