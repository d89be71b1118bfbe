# Commands, documents and drawables; and the viewer as a whole against pictures.
if(NOT AOMD_BUILD_VIEWER)
  return()
endif()

aomd_test(document_test aomd_scene)
aomd_test(document_options_test aomd_scene)
aomd_test(history_places_test aomd_scene)
aomd_test(branches_test aomd_scene)
aomd_test(runs_test aomd_scene)
aomd_test(stop_test aomd_scene)
aomd_test(model_view_test aomd_scene)
aomd_test(drawing_test aomd_scene)
aomd_test(skin_test aomd_scene)
aomd_test(picking_test aomd_scene)
aomd_test(selection_test aomd_scene)
aomd_test(neighbours_test aomd_scene)
aomd_test(tensor_test aomd_scene)
aomd_test(compare_view_test aomd_scene)
aomd_test(inside_view_test aomd_scene)
aomd_test(class_commands_test aomd_scene)
aomd_test(commands_test aomd_scene)
aomd_test(script_coverage_test aomd_scene)
foreach(test commands_test script_coverage_test)
  target_compile_definitions(${test} PRIVATE AOMD_SOURCE="${PROJECT_SOURCE_DIR}")
endforeach()
aomd_test(lesson_test aomd_scene)
aomd_test(lesson_player_test aomd_scene)
aomd_test(palette_test aomd_scene)
aomd_test(line_help_test aomd_scene)
aomd_test(unsaved_test aomd_scene)
aomd_test(tables_test aomd_scene)
aomd_test(settings_test aomd_ui)
aomd_test(recovery_test aomd_scene)
aomd_test(outputs_test aomd_scene)
foreach(test recovery_test outputs_test)
  target_compile_definitions(${test} PRIVATE AOMD_VIEW="$<TARGET_FILE:aomd-view>")
  add_dependencies(${test} aomd-view)
endforeach()
target_sources(recovery_test PRIVATE child.cpp)

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

# Every panel and dialog in both themes, on a usual screen and on a dense one. The dialogs show a folder of their own.
set(panels ${CMAKE_CURRENT_SOURCE_DIR}/baselines/panels)
file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scripts/panels/*.aomd)
foreach(script IN LISTS scripts)
  get_filename_component(name ${script} NAME_WE)
  foreach(theme light dark)
    foreach(screen "1280x800 1" "1920x1080 1.5")
      separate_arguments(screen UNIX_COMMAND "${screen}")
      list(GET screen 0 size)
      list(GET screen 1 scale)
      set(picture ${name}_${theme}_${size}.png)
      set(options "")
      if(name STREQUAL dialog_recovery)  # work that two programs left; whoever finds it locks it
        set(work ${CMAKE_CURRENT_BINARY_DIR}/recovery/${theme}_${size})
        file(COPY ${CMAKE_CURRENT_SOURCE_DIR}/scripts/recovery/ DESTINATION ${work})
        set(options --recovery ${work})
      endif()
      add_test(NAME panel.${name}_${theme}_${size}
        COMMAND ${CMAKE_COMMAND} -E env TZ=UTC HOME=${CMAKE_CURRENT_SOURCE_DIR}/scripts/home
          $<TARGET_FILE:aomd-view> --headless --transparent --theme ${theme} --size ${size} --scale ${scale} --script ${script}
            --compare ${panels}/${picture} --screenshot ${pictures}/${picture} ${options}
        WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/scripts/home/meshes)
    endforeach()
  endforeach()
endforeach()

# Scripts whose point is no picture: they end well, where every `expect` holds.
file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scripts/run/*.aomd)
foreach(script IN LISTS scripts)
  get_filename_component(name ${script} NAME_WE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/runs/${name})  # what it writes stays there
  file(MAKE_DIRECTORY ${folder})
  add_test(NAME script.${name} COMMAND aomd-view --headless --size 480x320 --script ${script} WORKING_DIRECTORY ${folder})
endforeach()
