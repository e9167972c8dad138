# prosector_embed(TARGET NAME FILES...): compiles the files into the target, as the list that common/embedded_file.h
# declares: `const std::span<const EmbeddedFile> NAME`. A file that changes is compiled in anew.
set(PROSECTOR_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/write_embedded.cmake)
function(prosector_embed target name)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DOUT=${out} "-DFILES=${ARGN}" -P ${PROSECTOR_EMBED_SCRIPT}
    DEPENDS ${ARGN} ${PROSECTOR_EMBED_SCRIPT} VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()
