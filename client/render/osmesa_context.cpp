// Mesa's offscreen library. Opened at run time with RTLD_LOCAL, because it exports the same gl* symbols as
// libGL and must never be linked together with it.

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include <GL/osmesa.h>

#include "client/render/gl_context.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr const char* library_name = "libOSMesa.so.8";

/// The four functions in use, with the handle that keeps them loaded.
struct OsMesaLibrary {
  void* handle;
  decltype(&OSMesaCreateContextAttribs) create_context;
  decltype(&OSMesaDestroyContext) destroy_context;
  decltype(&OSMesaMakeCurrent) make_current;
  decltype(&OSMesaGetProcAddress) get_proc_address;
};

OsMesaLibrary open_library() {
  void* handle = dlopen(library_name, RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw InputError(fmt::format("OSMesa: cannot open {}; install libosmesa6", library_name));
  const auto symbol = [handle](const char* name) {
    void* address = dlsym(handle, name);
    if (!address) throw InputError(fmt::format("OSMesa: {} has no {}", library_name, name));
    return address;
  };
  return {handle,
          reinterpret_cast<decltype(&OSMesaCreateContextAttribs)>(symbol("OSMesaCreateContextAttribs")),
          reinterpret_cast<decltype(&OSMesaDestroyContext)>(symbol("OSMesaDestroyContext")),
          reinterpret_cast<decltype(&OSMesaMakeCurrent)>(symbol("OSMesaMakeCurrent")),
          reinterpret_cast<decltype(&OSMesaGetProcAddress)>(symbol("OSMesaGetProcAddress"))};
}

class OsMesaContext final : public GlContext {
 public:
  OsMesaContext(int width, int height) : library_(open_library()), width_(width), height_(height) {
    check_picture_size(width, height);
    const int wish[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        3,
                        0};
    context_ = library_.create_context(wish, nullptr);
    if (!context_)
      throw InputError(
          "OSMesa: cannot create an OpenGL 3.3 core context; install libosmesa6 of a version from 22.3 to "
          "25.0");
    if (!library_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
      library_.destroy_context(context_);
      throw InputError("OSMesa: the OpenGL context cannot be made current");
    }
  }
  ~OsMesaContext() override {
    // The library stays loaded, because its driver has running threads.
    library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    library_.destroy_context(context_);
  }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  void* proc(const char* name) const override {
    return reinterpret_cast<void*>(library_.get_proc_address(name));
  }
  int width() const override { return width_; }
  int height() const override { return height_; }
  bool has_screen() const override { return false; }
  void present() override {}
  std::string description() const override { return describe_gl(*this, "OSMesa"); }

 private:
  OsMesaLibrary library_;
  int width_, height_;
  OSMesaContext context_ = nullptr;
  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(4);  // dummy colour buffer, never drawn to
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context(int width, int height) {
  return std::make_unique<OsMesaContext>(width, height);
}

}  // namespace prosector
