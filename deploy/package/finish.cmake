# Puts into each package, before it is packed, what `cmake --install` has no place for: the copyright file, the changelog, the
# server's settings; strips the libraries, and compresses the man pages.
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
  execute_process(COMMAND ${CPACK_PROSECTOR_SOURCE}/deploy/package/finish.sh ${CPACK_PROSECTOR_SOURCE} ${name} ${root}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
