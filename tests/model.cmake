# Models and snapping: included by tests/CMakeLists.txt.
find_package(nlohmann_json REQUIRED)
aomd_test(model_test)
aomd_test(analytic_model_test)
aomd_test(gmsh_model_test)
aomd_test(snap_test nlohmann_json::nlohmann_json)
target_compile_definitions(snap_test PRIVATE AOMD_PROGRAM="$<TARGET_FILE:aomd>")
add_dependencies(snap_test aomd)
# The test makes its STEP file with Gmsh itself.
if(AOMD_GMSH AND GMSH_INCLUDE AND GMSH_LIBRARY)
  target_compile_definitions(gmsh_model_test PRIVATE AOMD_TEST_WITH_GMSH)
  target_include_directories(gmsh_model_test SYSTEM PRIVATE ${GMSH_INCLUDE})
  target_link_libraries(gmsh_model_test PRIVATE ${GMSH_LIBRARY})
endif()
