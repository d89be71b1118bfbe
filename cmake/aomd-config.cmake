# find_package(aomd): the library aomd::core.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(muparser)
find_dependency(PNG)
find_dependency(pugixml)
find_dependency(Threads)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/aomd-targets.cmake)
