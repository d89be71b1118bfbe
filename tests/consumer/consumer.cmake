# cmake -DBUILD=... -DWORK=... -DCONFIG=... -DCOMPILER=... [-DPYTHON=...] -P consumer.cmake: installs
# the library of a build below a new folder, as packages are made, builds programs against nothing but
# that, and runs them.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/files)
set(ENV{DESTDIR} ${WORK}/stage)
foreach(component library runtime python)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix /usr --component ${component} --config "${CONFIG}")
endforeach()
set(ENV{DESTDIR})
set(installed ${WORK}/stage/usr)
file(GLOB_RECURSE exported ${installed}/*.cmake)
foreach(file IN LISTS exported)
  file(READ ${file} text)
  if(text MATCHES "[;\"](/[^;\"]+)")
    message(FATAL_ERROR "${file} names ${CMAKE_MATCH_1}, which other machines may not have")
  endif()
endforeach()
# What a header that the core lists declares is there for who links the shared library; others are
# for aomd::scene, an archive.
file(READ ${CMAKE_CURRENT_LIST_DIR}/../../core/CMakeLists.txt listed)
file(GLOB_RECURSE headers RELATIVE ${installed}/include/aomd/core ${installed}/include/aomd/core/*.h)
foreach(header IN LISTS headers)
  file(READ ${installed}/include/aomd/core/${header} text)
  string(FIND "${listed}" "${header}" place)
  if(place EQUAL -1)
    continue()
  endif()
  if(NOT text MATCHES "#pragma GCC visibility push" AND NOT header MATCHES "version.h$")
    message(FATAL_ERROR "${header} lacks #pragma GCC visibility")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${installed}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${WORK}/build)
file(GLOB programs ${WORK}/build/consumer_core ${WORK}/build/consumer_shared ${WORK}/build/consumer_c
  ${WORK}/build/consumer_scene)
foreach(program IN LISTS programs)
  run(${program} ${WORK}/files)
endforeach()

# A component that there is not is said to be missing, by name, beside those that there are.
file(WRITE ${WORK}/wrong/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.22)\nproject(wrong LANGUAGES CXX)\nfind_package(aomd COMPONENTS core mpi)
message(STATUS \"aomd_FOUND is \${aomd_FOUND}\")\n")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/wrong -B ${WORK}/wrong/build
  -DCMAKE_PREFIX_PATH=${installed} -DCMAKE_CXX_COMPILER=${COMPILER}
  OUTPUT_VARIABLE said ERROR_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[ \n]+" " " said "${said}")
if(NOT said MATCHES "aomd has no component mpi here: there are core, .*aomd_FOUND is (FALSE|0)")
  message(FATAL_ERROR "a component that is not there: ${said}")
endif()

# What the shared library has to offer is its own: nothing of what it was made with.
file(GLOB library ${installed}/lib/libaomd.so ${installed}/lib/*/libaomd.so)
execute_process(COMMAND nm -DC --defined-only ${library} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "\n[0-9a-f]+ [TDB] ([^a][^\n]*|a[^o][^\n]*)" foreign "${symbols}")
if(foreign OR NOT symbols MATCHES "aomd::Mesh::create_vertex")
  message(FATAL_ERROR "${library} has ${foreign}, or lacks what it should have")
endif()

# The same through pkg-config.
find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE described ${installed}/aomd.pc)
  get_filename_component(folder "${described}" DIRECTORY)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder}
    ${PKG_CONFIG} --cflags --libs aomd COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE flags)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  get_filename_component(libraries "${library}" DIRECTORY)
  set(ENV{LD_LIBRARY_PATH} ${libraries})
  run(${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/consumer.cpp -o ${WORK}/build/by_pkg_config ${flags})
  run(${WORK}/build/by_pkg_config ${WORK}/files)
  run(cc -std=c99 ${CMAKE_CURRENT_LIST_DIR}/consumer.c -o ${WORK}/build/c_by_pkg_config ${flags} -lm)
  run(${WORK}/build/c_by_pkg_config ${WORK}/files)
endif()

if(PYTHON)
  set(ENV{PYTHONPATH} ${installed}/lib/python3/dist-packages)
  run(${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/consumer.py ${WORK}/files)
endif()
