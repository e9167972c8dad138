#pragma once
// The OpenGL 3.3 functions that the renderer uses, from any context. Private to client/render.

#include <GL/glcorearb.h>

#include "client/render/gl_context.h"

// clang-format off
#define PROSECTOR_GL_FUNCTIONS(X)                                                                          \
  X(BEGINQUERY, BeginQuery) X(ENDQUERY, EndQuery) X(GENQUERIES, GenQueries) X(DELETEQUERIES, DeleteQueries) \
  X(GETQUERYOBJECTUIV, GetQueryObjectuiv)                                                                  \
  X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BINDATTRIBLOCATION, BindAttribLocation)  \
  X(BINDBUFFER, BindBuffer) X(BINDFRAMEBUFFER, BindFramebuffer) X(BINDRENDERBUFFER, BindRenderbuffer)      \
  X(BINDTEXTURE, BindTexture) X(BINDVERTEXARRAY, BindVertexArray)                \
  X(BLENDCOLOR, BlendColor) X(BLENDFUNC, BlendFunc) X(BLENDFUNCSEPARATE, BlendFuncSeparate) X(COLORMASK, ColorMask)                                                          \
  X(BLITFRAMEBUFFER, BlitFramebuffer) X(BUFFERDATA, BufferData) X(BUFFERSUBDATA, BufferSubData)            \
  X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) X(CLEAR, Clear) X(CLEARCOLOR, ClearColor)              \
  X(COMPILESHADER, CompileShader) X(CREATEPROGRAM, CreateProgram) X(CREATESHADER, CreateShader)            \
  X(CULLFACE, CullFace) X(DELETEBUFFERS, DeleteBuffers) X(DELETEFRAMEBUFFERS, DeleteFramebuffers)          \
  X(DELETEPROGRAM, DeleteProgram) X(DELETERENDERBUFFERS, DeleteRenderbuffers)                              \
  X(DELETESHADER, DeleteShader) X(DELETETEXTURES, DeleteTextures) X(DELETEVERTEXARRAYS, DeleteVertexArrays)\
  X(DEPTHFUNC, DepthFunc) X(DEPTHMASK, DepthMask) X(DISABLE, Disable) X(DRAWARRAYS, DrawArrays)            \
  X(DRAWBUFFER, DrawBuffer) X(DRAWELEMENTS, DrawElements) X(ENABLE, Enable)                                \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) X(FINISH, Finish) X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)  \
  X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) X(GENBUFFERS, GenBuffers)                                  \
  X(GENFRAMEBUFFERS, GenFramebuffers) X(GENRENDERBUFFERS, GenRenderbuffers) X(GENTEXTURES, GenTextures)    \
  X(GENVERTEXARRAYS, GenVertexArrays) X(GENERATEMIPMAP, GenerateMipmap) X(GETERROR, GetError) X(GETPROGRAMINFOLOG, GetProgramInfoLog)        \
  X(GETPROGRAMIV, GetProgramiv) X(GETSHADERINFOLOG, GetShaderInfoLog) X(GETSHADERIV, GetShaderiv)          \
  X(GETTEXIMAGE, GetTexImage) X(GETUNIFORMLOCATION, GetUniformLocation) X(LINKPROGRAM, LinkProgram) X(PIXELSTOREI, PixelStorei)        \
  X(POLYGONOFFSET, PolygonOffset) X(READBUFFER, ReadBuffer) X(READPIXELS, ReadPixels)                      \
  X(RENDERBUFFERSTORAGE, RenderbufferStorage)                                                              \
  X(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample) X(SCISSOR, Scissor)                    \
  X(SHADERSOURCE, ShaderSource) X(TEXIMAGE2D, TexImage2D) X(TEXSUBIMAGE2D, TexSubImage2D) X(TEXPARAMETERFV, TexParameterfv) X(TEXPARAMETERI, TexParameteri)                  \
  X(UNIFORM1F, Uniform1f) X(UNIFORM1I, Uniform1i) X(UNIFORM3F, Uniform3f) X(UNIFORM3FV, Uniform3fv)        \
  X(UNIFORM4FV, Uniform4fv) X(UNIFORMMATRIX4FV, UniformMatrix4fv) X(USEPROGRAM, UseProgram)                \
  X(VERTEXATTRIBPOINTER, VertexAttribPointer) X(VIEWPORT, Viewport)
// clang-format on

namespace prosector {

/// OpenGL functions loaded from a context. A member has the function's name without the prefix: gl.Clear(…)
/// calls glClear(…).
struct Gl {
#define PROSECTOR_GL_MEMBER(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
  PROSECTOR_GL_FUNCTIONS(PROSECTOR_GL_MEMBER)
#undef PROSECTOR_GL_MEMBER
};

/// Loads the OpenGL functions from the context, which must be current. Throws InputError with the name of a
/// missing function.
Gl load_gl(const GlContext& context);

}  // namespace prosector
