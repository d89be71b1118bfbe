# Tests against the plain model of a mesh: included by tests/CMakeLists.txt.
add_library(aomd_oracle STATIC oracle.cpp program.cpp twin.cpp twin_relations.cpp)
aomd_target(aomd_oracle)
target_link_libraries(aomd_oracle PUBLIC aomd_core)

aomd_test(entity_hash_test)
aomd_test(random_program_test aomd_oracle)
aomd_test(templates_test aomd_oracle)
aomd_test(volume_test aomd_oracle)
aomd_test(volume_edits_test)
aomd_test(volume_samples_test)
