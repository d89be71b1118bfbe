# cmake -DBUILD=... -DWORK=... -DCONFIG=... -P consumer.cmake: installs the library of a build into a new folder, builds a
# program against nothing but that, and runs it.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/files)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed --component library --config "${CONFIG}")
file(GLOB_RECURSE exported ${WORK}/installed/*.cmake)
foreach(file IN LISTS exported)
  file(READ ${file} text)
  if(text MATCHES "[;\"](/[^;\"]+)")
    message(FATAL_ERROR "${file} names ${CMAKE_MATCH_1}, which other machines may not have")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/installed
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer ${WORK}/files)

# The same through pkg-config.
find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE described ${WORK}/installed/aomd.pc)
  get_filename_component(folder "${described}" DIRECTORY)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder}
    ${PKG_CONFIG} --cflags --libs aomd COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE flags)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/consumer.cpp -o ${WORK}/build/by_pkg_config ${flags})
  run(${WORK}/build/by_pkg_config ${WORK}/files)
endif()
