#include "client/render/interface_painter.h"

#include <algorithm>

#include "client/render/render_target.h"
#include "client/render/vertex_stream.h"

namespace prosector {
namespace {

constexpr RendererSettings flat = {.effects = 0};

}  // namespace

struct InterfacePainter::Impl {
  Impl(GlContext& given, const std::filesystem::path& shaders)
      : context(given),
        gl(load_gl(given)),
        target(gl, shaders, flat),
        program(gl, shaders, "interface"),
        stream(gl, {2, 2, 4}) {}
  ~Impl() {
    if (!textures.empty()) gl.DeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  GlContext& context;
  Gl gl;
  RenderTarget target;
  ShaderProgram program;
  VertexStream stream;
  std::vector<GLuint> textures;
};

InterfacePainter::InterfacePainter(GlContext& context, const std::filesystem::path& shaders)
    : impl_(std::make_unique<Impl>(context, shaders)) {}
InterfacePainter::~InterfacePainter() = default;

std::uint32_t InterfacePainter::add_texture(int width, int height, const std::uint8_t* rgba) {
  const Gl& gl = impl_->gl;
  GLuint id = 0;
  gl.GenTextures(1, &id);
  gl.BindTexture(GL_TEXTURE_2D, id);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  impl_->textures.push_back(id);
  change_texture(id, width, height, rgba);
  return static_cast<std::uint32_t>(id);
}

void InterfacePainter::change_texture(std::uint32_t texture, int width, int height,
                                      const std::uint8_t* rgba) {
  const Gl& gl = impl_->gl;
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

void InterfacePainter::draw(const Eigen::Vector3f& ground, const std::vector<InterfaceDraw>& draws) {
  Impl& r = *impl_;
  const Gl& gl = r.gl;
  const int width = r.context.width(), height = r.context.height();
  r.target.bind(width, height);
  gl.Viewport(0, 0, width, height);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearColor(ground.x(), ground.y(), ground.z(), 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_SCISSOR_TEST);
  r.program.use();
  r.program.set("picture", 0);
  gl.ActiveTexture(GL_TEXTURE0);
  std::vector<InterfaceVertex> on_screen;
  for (const InterfaceDraw& draw : draws) {
    const int left = std::max(0, draw.left), right = std::min(width, draw.right);
    const int top = std::max(0, draw.top), bottom = std::min(height, draw.bottom);
    if (left >= right || top >= bottom) continue;
    gl.Scissor(left, height - bottom, right - left, bottom - top);
    gl.BindTexture(GL_TEXTURE_2D, draw.texture);
    on_screen = draw.vertices;
    for (InterfaceVertex& v : on_screen)
      v.at = {2 * v.at.x() / static_cast<float>(width) - 1, 1 - 2 * v.at.y() / static_cast<float>(height)};
    r.stream.draw(on_screen);
  }
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  r.target.resolve();
  if (r.context.has_screen()) r.target.show();
}

Image InterfacePainter::read_pixels() const {
  return impl_->target.read();
}

}  // namespace prosector
