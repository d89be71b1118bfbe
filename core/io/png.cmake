# Pictures: included by core/io/CMakeLists.txt.
find_package(PNG REQUIRED)
target_sources(aomd_core PRIVATE ${CMAKE_CURRENT_LIST_DIR}/png.cpp)
target_link_libraries(aomd_core PRIVATE PNG::PNG)
