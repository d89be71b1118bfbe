# Pictures, camera and the GPU half of the viewer.
aomd_test(png_test)
aomd_test(image_diff_test)
if(AOMD_BUILD_VIEWER)
  aomd_test(camera_test aomd_scene)
  aomd_test(scene_test aomd_scene)
  aomd_test(render_test aomd_app)
  target_compile_definitions(render_test PRIVATE AOMD_SHADERS="${PROJECT_SOURCE_DIR}/shaders")
endif()
