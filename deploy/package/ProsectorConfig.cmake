# find_package(Prosector): Prosector::physics, the simulation by itself, with scenes made in code or read from files.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(fmt)
find_dependency(hwy)
find_dependency(TBB)
find_dependency(Threads)
find_dependency(tomlplusplus)
find_dependency(ZLIB)
find_dependency(PkgConfig)
pkg_check_modules(BULLET REQUIRED QUIET IMPORTED_TARGET bullet)
pkg_check_modules(XXHASH REQUIRED QUIET IMPORTED_TARGET libxxhash)

include(${CMAKE_CURRENT_LIST_DIR}/ProsectorTargets.cmake)
target_link_libraries(Prosector::physics INTERFACE Prosector::scene)
target_compile_features(Prosector::physics INTERFACE cxx_std_20)
# The alignment that the library was built with, also where a program is compiled for wider vectors.
target_compile_definitions(Prosector::physics INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
