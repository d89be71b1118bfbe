# Commands, documents and drawables; and the viewer as a whole against pictures.
if(NOT AOMD_BUILD_VIEWER)
  return()
endif()

aomd_test(document_test aomd_scene)
aomd_test(document_options_test aomd_scene)
aomd_test(history_places_test aomd_scene)
aomd_test(model_view_test aomd_scene)
aomd_test(drawing_test aomd_scene)
aomd_test(skin_test aomd_scene)
aomd_test(picking_test aomd_scene)
aomd_test(selection_test aomd_scene)
aomd_test(compare_view_test aomd_scene)
aomd_test(class_commands_test aomd_scene)
aomd_test(commands_test aomd_scene)
target_compile_definitions(commands_test PRIVATE AOMD_SOURCE="${PROJECT_SOURCE_DIR}")
aomd_test(palette_test aomd_scene)
aomd_test(unsaved_test aomd_scene)
aomd_test(tables_test aomd_scene)
aomd_test(settings_test aomd_ui)
aomd_test(recovery_test aomd_scene)
aomd_test(outputs_test aomd_scene)
foreach(test recovery_test outputs_test)
  target_compile_definitions(${test} PRIVATE AOMD_VIEW="$<TARGET_FILE:aomd-view>")
  add_dependencies(${test} aomd-view)
endforeach()

# One test a script: its last picture must be its baseline. Results and differences stay in pictures/ of the build.
set(pictures ${CMAKE_CURRENT_BINARY_DIR}/pictures)
file(MAKE_DIRECTORY ${pictures})
file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scripts/*.aomd)
foreach(script IN LISTS scripts)
  get_filename_component(name ${script} NAME_WE)
  set(options "")
  file(STRINGS ${script} first LIMIT_COUNT 1)
  if(first MATCHES "^# options: (.*)$")  # what no command can say: --size, --no-ui
    separate_arguments(options UNIX_COMMAND "${CMAKE_MATCH_1}")
  endif()
  add_test(NAME picture.${name}
    COMMAND aomd-view --headless --size 960x600 --script ${script} --compare ${CMAKE_CURRENT_SOURCE_DIR}/baselines/${name}.png
      --screenshot ${pictures}/${name}.png ${options}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
endforeach()
