# What most sources include, compiled once for each library: half of the time to build goes into reading it. A source still
# includes what it uses: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON (the dev preset) builds without.
set(AOMD_COMMON_HEADERS
  <algorithm> <array> <bit> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <set> <span>
  <stdexcept> <string> <string_view> <unordered_map> <utility> <variant> <vector>
  <glm/common.hpp> <glm/geometric.hpp> <glm/vec3.hpp>
  ${PROJECT_SOURCE_DIR}/core/mesh/mesh.h)

# aomd_target(NAME): the settings that every target of this project shares.
function(aomd_target name)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/aomd>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wunused
    $<$<BOOL:${AOMD_WERROR}>:-Werror>)
  # GCC 12 warns about `"text" + std::string` at -O3 (GCC bugs 105651 and 105329).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${name} PRIVATE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
  endif()
  if(AOMD_SANITIZE)
    set(sanitizers $<IF:$<STREQUAL:${AOMD_SANITIZE},THREAD>,thread,address$<COMMA>undefined>)
    target_compile_options(${name} PUBLIC -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${name} PUBLIC -fsanitize=${sanitizers})
  endif()
endfunction()
