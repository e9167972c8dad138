#include "client/render/shader_program.h"

#include <fmt/format.h>

#include "client/render/shader_source.h"
#include "common/error.h"

namespace prosector {
namespace {

GLuint compile(const Gl& gl, GLenum stage, const ShaderSource& source) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.text.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint ok = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  GLint length = 0;
  gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  gl.GetShaderInfoLog(shader, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  gl.DeleteShader(shader);
  throw InputError(
      fmt::format("shader {} does not compile:\n{}", source.files[0].string(), readable_log(log, source)));
}

}  // namespace

ShaderProgram::ShaderProgram(const Gl& gl, const std::filesystem::path& folder, const std::string& name,
                             const std::vector<std::string>& defines)
    : gl_(gl) {
  const ShaderSource vertex_source = load_shader_source(folder, name + ".vert", defines);
  const ShaderSource fragment_source = load_shader_source(folder, name + ".frag", defines);
  const GLuint vertex = compile(gl, GL_VERTEX_SHADER, vertex_source);
  GLuint fragment = 0;
  try {
    fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_source);
  } catch (...) {
    gl.DeleteShader(vertex);
    throw;
  }
  program_ = gl.CreateProgram();
  gl.AttachShader(program_, vertex);
  gl.AttachShader(program_, fragment);
  gl.LinkProgram(program_);
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  GLint ok = 0;
  gl.GetProgramiv(program_, GL_LINK_STATUS, &ok);
  if (ok) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  gl.DeleteProgram(program_);
  throw InputError(fmt::format("the shaders {0}.vert and {0}.frag cannot be linked to a program:\n{1}",
                               (folder / name).string(), log));
}

ShaderProgram::~ShaderProgram() {
  gl_.DeleteProgram(program_);
}

void ShaderProgram::set(const char* name, const Vec3& value) const {
  const Eigen::Vector3f v = value.cast<float>();
  gl_.Uniform3fv(location(name), 1, v.data());
}

void ShaderProgram::set(const char* name, const Eigen::Matrix4d& value) const {
  const Eigen::Matrix4f m = value.cast<float>();
  gl_.UniformMatrix4fv(location(name), 1, GL_FALSE, m.data());
}

void ShaderProgram::set(const char* name, const std::vector<Eigen::Vector4f>& values) const {
  if (!values.empty()) gl_.Uniform4fv(location(name), static_cast<GLsizei>(values.size()), values[0].data());
}

}  // namespace prosector
