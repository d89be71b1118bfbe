# The viewer in a real window, on a screen of Xvfb.
if(NOT AOMD_BUILD_VIEWER)
  return()
endif()
find_package(X11)
if(NOT X11_Xtst_FOUND)
  message(STATUS "No libXtst (libxtst-dev): the tests of the real window are left out")
  return()
endif()

aomd_test(window_test aomd_ui X11::X11 X11::Xtst)
target_sources(window_test PRIVATE child.cpp places.cpp viewer_window.cpp x_screen.cpp)
target_compile_definitions(window_test PRIVATE AOMD_VIEW="$<TARGET_FILE:aomd-view>"
  AOMD_PICTURES="${CMAKE_CURRENT_BINARY_DIR}/pictures/window")
add_dependencies(window_test aomd-view)
