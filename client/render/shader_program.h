#pragma once
// A linked GL program. Private to client/render.

#include <filesystem>
#include <string>
#include <vector>

#include "client/render/gl.h"
#include "common/math.h"

namespace prosector {

class ShaderProgram {
 public:
  /// Compiles the shaders NAME.vert and NAME.frag of the folder (empty: of the embedded files) with the
  /// macros `defines`, and links them. Throws InputError with file, line and the compiler's message.
  ShaderProgram(const Gl& gl, const std::filesystem::path& folder, const std::string& name,
                const std::vector<std::string>& defines = {});
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const { gl_.UseProgram(program_); }
  // Sets a uniform of the program in use; a uniform that the compiler removed is ignored.
  void set(const char* name, int value) const { gl_.Uniform1i(location(name), value); }
  void set(const char* name, double value) const { gl_.Uniform1f(location(name), static_cast<float>(value)); }
  void set(const char* name, const Vec3& value) const;
  void set(const char* name, const Eigen::Matrix4d& value) const;
  void set(const char* name, const std::vector<Eigen::Vector4f>& values) const;

 private:
  GLint location(const char* name) const { return gl_.GetUniformLocation(program_, name); }

  const Gl& gl_;
  GLuint program_ = 0;
};

}  // namespace prosector
