# What `cmake --install` installs. Programs carry their shaders, DDS profiles and stereo profiles in them: the files beside them
# are to start from.
set(programs prosector-server prosector-client prosector-scene prosector-import prosector-fastrak-twin prosector-5dt-twin)
if(PROSECTOR_TESTS)
  list(APPEND programs prosector-bench)
endif()
install(TARGETS ${programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

set(data ${CMAKE_INSTALL_DATADIR}/prosector)
foreach(folder scenes dds stereo demo)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/deploy/${folder} DESTINATION ${data})
endforeach()
install(FILES ${CMAKE_SOURCE_DIR}/deploy/client.toml ${CMAKE_SOURCE_DIR}/deploy/packages.txt DESTINATION ${data})
install(PROGRAMS ${CMAKE_SOURCE_DIR}/deploy/setup.sh ${CMAKE_SOURCE_DIR}/deploy/fetch_anatomy.sh
  ${CMAKE_SOURCE_DIR}/deploy/inv3_to_nifti.py DESTINATION ${data})
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/CHANGELOG.md ${CMAKE_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
