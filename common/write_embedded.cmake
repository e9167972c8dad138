# cmake -DNAME=… -DFILES=… -DOUT=FILE.cpp -P write_embedded.cmake: writes the source text that prosector_embed compiles.
set(rows "")
foreach(file ${FILES})
  get_filename_component(base ${file} NAME)
  if(base MATCHES "[.]mo$")  # bytes, zeros among them
    file(READ ${file} bytes HEX)
    string(LENGTH "${bytes}" digits)
    math(EXPR size "${digits} / 2")
    string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
    string(APPEND rows "    {\"${base}\", {\"${bytes}\", ${size}}},\n")
    continue()
  endif()
  file(READ ${file} text)
  string(APPEND rows "    {\"${base}\", R\"embedded(${text})embedded\"},\n")
endforeach()
file(WRITE ${OUT} "// Made by common/write_embedded.cmake.
#include \"common/embedded_file.h\"

namespace prosector {
namespace {
constexpr EmbeddedFile files[] = {
${rows}};
}  // namespace
extern const std::span<const EmbeddedFile> ${NAME};
const std::span<const EmbeddedFile> ${NAME} = files;
}  // namespace prosector
")
