# find_package(aomd): the library aomd::core.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(PNG)
include(${CMAKE_CURRENT_LIST_DIR}/aomd-targets.cmake)
