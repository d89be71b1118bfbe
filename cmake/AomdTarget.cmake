# What most sources include, compiled once for each library: half of the time to build goes into reading it. A source still
# includes what it uses: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON (the dev preset) builds without.
set(AOMD_COMMON_HEADERS
  <algorithm> <array> <bit> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <set> <span>
  <stdexcept> <string> <string_view> <unordered_map> <utility> <variant> <vector>
  <glm/common.hpp> <glm/geometric.hpp> <glm/vec3.hpp>
  ${PROJECT_SOURCE_DIR}/core/mesh/mesh.h)

# aomd_target(NAME): the settings that every target of this project shares.
function(aomd_target name)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
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
    # A null pointer that is used ends the program by itself; to look at each takes a sixth of the time to compile.
    target_compile_options(${name} PUBLIC -fsanitize=${sanitizers} -fno-sanitize=null -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${name} PUBLIC -fsanitize=${sanitizers})
  endif()
endfunction()

# aomd_library(NAME): the same for a library that may become part of a shared one. Nothing of it can
# be replaced from outside: calls inside of it are bound, and inlined, when it is compiled.
function(aomd_library name)
  aomd_target(${name})
  set_target_properties(${name} PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${name} PRIVATE -fno-semantic-interposition)
endfunction()

# aomd_unity(TARGET [EXCEPT LAYER...]): with CMAKE_UNITY_BUILD (the release preset), up to eight
# files of one folder are compiled as one, so that headers are read and their templates compiled
# once for all of them. What two files of a folder each keep in an unnamed namespace must therefore
# differ in name. AOMD_UNITY_EVERYWHERE passes over EXCEPT and takes three times as many,
# where nobody asks how fast a decimation is.
function(aomd_unity target)
  cmake_parse_arguments(PARSE_ARGV 1 unity "" "" EXCEPT)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD "${CMAKE_UNITY_BUILD}" UNITY_BUILD_MODE GROUP)
  # GCC takes a source that another one includes for a header, in which unnamed namespaces would be
  # a fault.
  if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  set(most 8)
  if(AOMD_UNITY_EVERYWHERE)
    set(most 24)
  endif()
  set(last "")
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE path)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    cmake_path(GET path PARENT_PATH folder)
    string(REGEX MATCH "^[^/]+/[^/]+" layer "${folder}")
    if(layer IN_LIST unity_EXCEPT AND NOT AOMD_UNITY_EVERYWHERE)
      continue()
    endif()
    if(NOT folder STREQUAL last)
      set(last "${folder}")
      set(count 0)
    endif()
    math(EXPR part "${count} / ${most}")
    math(EXPR count "${count} + 1")
    string(MAKE_C_IDENTIFIER "${folder}_${part}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()
