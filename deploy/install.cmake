# What `cmake --install` installs, by the package that deploy/package.cmake puts it into: components server, client, tools, dev.
# No package has `setup`. Programs carry their shaders, DDS profiles and stereo profiles in them: the files beside them are to
# start from.
set(server_programs prosector-server prosector-import)
set(client_programs prosector-client prosector-fastrak-twin prosector-5dt-twin prosector-device-twin prosector-board)
set(tools_programs prosector-scene)
if(PROSECTOR_TESTS)
  list(APPEND tools_programs prosector-bench prosector-play)
endif()

# Each program and its man page, which says what its --help says.
foreach(component server client tools)
  foreach(program ${${component}_programs})
    set(page ${CMAKE_BINARY_DIR}/man/${program}.1)
    add_custom_command(OUTPUT ${page} COMMAND ${CMAKE_SOURCE_DIR}/deploy/man_page.py $<TARGET_FILE:${program}> ${page}
      DEPENDS ${program} ${CMAKE_SOURCE_DIR}/deploy/man_page.py VERBATIM)
    list(APPEND man_pages ${page})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
  endforeach()
endforeach()
add_custom_target(man_pages ALL DEPENDS ${man_pages})

set(data ${CMAKE_INSTALL_DATADIR}/prosector)
set(deploy ${CMAKE_SOURCE_DIR}/deploy)
install(DIRECTORY ${deploy}/scenes ${deploy}/dds DESTINATION ${data} COMPONENT server)
install(PROGRAMS ${deploy}/fetch_anatomy.sh ${deploy}/inv3_to_nifti.py DESTINATION ${data} COMPONENT server)
install(FILES ${deploy}/package/prosector-server.service DESTINATION lib/systemd/system COMPONENT server)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT server)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT server)

install(DIRECTORY ${deploy}/stereo ${deploy}/demo DESTINATION ${data} COMPONENT client)
install(FILES ${deploy}/client.toml DESTINATION ${data} COMPONENT client)
install(PROGRAMS ${deploy}/fetch_models.sh DESTINATION ${data} COMPONENT client)
install(FILES ${deploy}/package/prosector-client.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT client)

install(FILES ${deploy}/packages.txt DESTINATION ${data} COMPONENT setup)
install(PROGRAMS ${deploy}/setup.sh DESTINATION ${data} COMPONENT setup)

# The physics by itself, for find_package(Prosector): the libraries, what they need of ours, and the public headers with
# all that these include.
function(own_libraries target found)
  set(all ${${found}} ${target})
  get_target_property(uses ${target} INTERFACE_LINK_LIBRARIES)
  foreach(use ${uses})
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" use ${use})
    if(use MATCHES "^prosector_" AND NOT use IN_LIST all)
      own_libraries(${use} all)
    endif()
  endforeach()
  set(${found} ${all} PARENT_SCOPE)
endfunction()
set(libraries)
own_libraries(prosector_physics libraries)
foreach(library ${libraries})
  string(REPLACE "prosector_" "" name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS ${libraries} EXPORT Prosector ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/Prosector)
install(EXPORT Prosector NAMESPACE Prosector:: FILE ProsectorTargets.cmake DESTINATION ${config} COMPONENT dev)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/ProsectorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${deploy}/package/ProsectorConfig.cmake ${CMAKE_BINARY_DIR}/ProsectorConfigVersion.cmake DESTINATION ${config}
  COMPONENT dev)

set(public_headers server/physics/simulation.h server/physics/mechanics/soft/soft_body.h server/physics/mechanics/soft/mechanical_energy.h
  server/physics/mechanics/soft/unfold.h common/scene/load_scene.h common/error.h common/version.h)
install(CODE "
  set(source [[${CMAKE_SOURCE_DIR}]])
  set(headers [[${public_headers}]])
  set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/prosector\")" COMPONENT dev)
install(SCRIPT ${deploy}/package/install_headers.cmake COMPONENT dev)
install(DIRECTORY ${deploy}/example DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libprosector-dev COMPONENT dev)
