# The Debian packages that deploy/package.sh makes: one for each component of install.cmake but `setup`.
set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME prosector)
set(CPACK_PACKAGE_CONTACT "Prosector developers <prosector@localhost>")
set(CPACK_COMPONENTS_ALL server client tools dev)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
# After the files are in place, before they are packed.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/deploy/package/finish.cmake)
set(CPACK_PROSECTOR_SOURCE ${CMAKE_SOURCE_DIR})

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)

set(CPACK_DEBIAN_SERVER_PACKAGE_NAME prosector-server)
set(CPACK_DEBIAN_SERVER_DESCRIPTION "hosts sessions of a shared dissecting room
Simulates organs that deform, bones and instruments, and shows them to all
who join with prosector-client. Scenes and a systemd unit come with it; the
unit is off until it is enabled, and keeps to this machine.")
set(CPACK_DEBIAN_SERVER_PACKAGE_SUGGESTS "prosector-client, python3")
set(CPACK_DEBIAN_SERVER_PACKAGE_CONTROL_EXTRA "")
foreach(script conffiles postinst prerm postrm)
  list(APPEND CPACK_DEBIAN_SERVER_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/deploy/package/server/${script})
endforeach()

set(CPACK_DEBIAN_CLIENT_PACKAGE_NAME prosector-client)
set(CPACK_DEBIAN_CLIENT_DESCRIPTION "joins or watches a shared dissecting room
Draws what a prosector-server simulates, and takes part with a mouse, a
gamepad, a tracker or a data glove. Simulated devices come with it.")
# Both are opened at run time: windows draw with the first, and where there is neither GPU nor display, the second does.
# Text needs one font at least; with those recommended it has more scripts (client/text/font_catalogue.cpp).
set(CPACK_DEBIAN_CLIENT_PACKAGE_DEPENDS "libgl1, libosmesa6, fontconfig-config, fonts-dejavu-core")
set(CPACK_DEBIAN_CLIENT_PACKAGE_RECOMMENDS "fonts-lohit-deva, fonts-droid-fallback")
# OpenXR's loader is opened for who has a headset.
set(CPACK_DEBIAN_CLIENT_PACKAGE_SUGGESTS "prosector-server, libopenxr-loader1")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME prosector-tools)
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "drafts and checks scenes, measures models of tissue
Drafts scenes of meshes and label maps, checks scene files, weighs every model of tissue by
cost and error on this machine, and lets people play at random in a scene.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "libosmesa6, fontconfig-config, fonts-dejavu-core")
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS prosector-server)

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libprosector-dev)
set(CPACK_DEBIAN_DEV_DESCRIPTION "soft and rigid bodies in contact, for programs of one's own
The physics of Prosector by itself: finite elements, springs and rigid bodies
that touch, without network or drawing. find_package(Prosector) of CMake gives
Prosector::physics.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libbullet-dev, libeigen3-dev, libfmt-dev, libhwy-dev, libtbb-dev, libtomlplusplus-dev, \
libxxhash-dev, pkg-config, zlib1g-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "cmake, g++, prosector-server")

include(CPack)
