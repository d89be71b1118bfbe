# What `cmake --install` puts where, in seven components: programs, viewer, mpi, runtime (the shared
# library), library (what programs are built with), python and documents; and the Debian packages that `cpack -G DEB` makes of them (docs/INSTALL.md).
include(CMakePackageConfigHelpers)

install(TARGETS aomd COMPONENT programs)
install(FILES tools/package/completions/aomd.bash RENAME aomd
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
install(FILES tools/package/completions/_aomd
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT programs)
install(FILES tools/package/completions/aomd.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)

# Each in a file of its own: who links the shared library needs nothing that it is linked with.
install(TARGETS aomd_core EXPORT aomd-core-targets COMPONENT library)
set(exported core)
if(TARGET aomd_shared)
  install(TARGETS aomd_shared EXPORT aomd-shared-targets
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT library)
  list(APPEND exported shared)
endif()
if(TARGET aomd_scene)
  install(TARGETS aomd_scene EXPORT aomd-scene-targets COMPONENT library)
  list(APPEND exported scene)
endif()
foreach(component IN LISTS exported)
  install(EXPORT aomd-${component}-targets NAMESPACE aomd::
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/aomd COMPONENT library)
endforeach()
write_basic_package_version_file(aomd-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/aomd-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/aomd-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/aomd COMPONENT library)
file(RELATIVE_PATH AOMD_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
if(TINYGLTF_LIBRARY)
  set(AOMD_GLTF_LIBS -ltinygltf)
endif()
configure_file(cmake/aomd.pc.in aomd.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/aomd.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)

if(TARGET aomd_python)
  set(AOMD_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where Python packages go, below the prefix")
  install(TARGETS aomd_python LIBRARY DESTINATION ${AOMD_PYTHON_DIR}/aomd COMPONENT python)
  foreach(file __init__.py __init__.pyi options.py py.typed pytest_plugin.py)
    install(FILES tools/python/package/${file} DESTINATION ${AOMD_PYTHON_DIR}/aomd COMPONENT python)
  endforeach()
  get_target_property(interpreter aomd_python AOMD_PYTHON)
  install(CODE "execute_process(COMMAND \"${interpreter}\" -B
    \"${PROJECT_SOURCE_DIR}/tools/package/aomd_wheel.py\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${AOMD_PYTHON_DIR}\" COMMAND_ERROR_IS_FATAL ANY)"
    COMPONENT python)
endif()

if(AOMD_BUILD_VIEWER)
  install(TARGETS aomd-view COMPONENT viewer)
  foreach(font inter jetbrains-mono)  # their licence goes where they go
    install(FILES /usr/share/doc/fonts-${font}/copyright RENAME fonts-${font}.copyright
      DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/aomd-view COMPONENT viewer OPTIONAL)
  endforeach()
  install(FILES assets/desktop/aomd-view.desktop
    DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT viewer)
  install(FILES assets/desktop/aomd-view.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT viewer)
  install(FILES assets/desktop/aomd-view.metainfo.xml
    DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT viewer)
  install(FILES assets/desktop/aomd-view.mime.xml RENAME aomd-view.xml
    DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT viewer)
endif()

if(TARGET aomd-mpi)
  install(TARGETS aomd-mpi COMPONENT mpi)
endif()

# All that is installed, and no tests.
add_custom_target(aomd_installed)
foreach(target aomd aomd_core aomd_shared aomd_python aomd-view aomd-mpi)
  if(TARGET ${target})
    add_dependencies(aomd_installed ${target})
  endif()
endforeach()

# The manual pages are made on installing, from what the programs say of themselves.
find_program(HELP2MAN help2man)
function(aomd_install_manuals component aomd view mpi)
  install(CODE "execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/tools/package/manuals.sh\"
    \"${aomd}\" \"${view}\" \"${mpi}\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\"
    COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
endfunction()
if(HELP2MAN)
  aomd_install_manuals(programs $<TARGET_FILE:aomd> "" "")
  if(AOMD_BUILD_VIEWER)
    aomd_install_manuals(viewer "" $<TARGET_FILE:aomd-view> "")
  endif()
  if(TARGET aomd-mpi)
    aomd_install_manuals(mpi "" "" $<TARGET_FILE:aomd-mpi>)
  endif()
else()
  message(STATUS "Without help2man: no manual pages are installed")
endif()

install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/aomd-doc COMPONENT documents)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/aomd-doc COMPONENT documents)

set(CPACK_PACKAGE_NAME aomd-studio)
set(CPACK_PACKAGE_CONTACT "AOMD Studio <maintainers@aomd-studio.invalid>")
# Each package has a summary of its own: that of the whole stays CPack's, which it leaves out.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${CMAKE_PROJECT_NAME} built using CMake")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENTS_ALL "")

# What Debian wants to find in each package: whose it is, and what has changed.
string(TIMESTAMP today "%a, %d %b %Y 00:00:00 +0000" UTC)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/package/changelog
  "aomd-studio (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md.\n\n"
  " -- ${CPACK_PACKAGE_CONTACT}  ${today}\n")
file(READ LICENSE licence)
string(REGEX REPLACE "^MIT License\n\n[^\n]*\n\n" "" licence "${licence}")
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" licence "${licence}")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/package/copyright
  "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
  "Upstream-Name: AOMD Studio\n\nFiles: *\nCopyright: 2026 AOMD Studio\n"
  "License: Expat\n ${licence}")

# aomd_package(COMPONENT PACKAGE SECTION DEPENDS SUMMARY LINE...): the Debian package of a component.
macro(aomd_package component package section depends summary)
  string(TOUPPER ${component} key)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}")
  string(JOIN "\n" CPACK_DEBIAN_${key}_DESCRIPTION "${summary}" ${ARGN})
  set(documents ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/package/copyright DESTINATION ${documents}
    COMPONENT ${component})
  install(CODE "set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${documents}\")
    file(MAKE_DIRECTORY \${folder})
    execute_process(COMMAND gzip -9nc \"${CMAKE_CURRENT_BINARY_DIR}/package/changelog\"
      OUTPUT_FILE \${folder}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
endmacro()

aomd_package(programs aomd science ""
  "makes surface and volume meshes coarser"
  "aomd makes meshes of triangles and of tetrahedra coarser on the command"
  "line, keeps to the original, its edges and its materials, and says why"
  "an edge stays. It checks, repairs, classifies, compares and converts"
  "meshes too.")
if(AOMD_BUILD_VIEWER)
  aomd_package(viewer aomd-view science ""
    "shows a mesh and what decimation does to it"
    "Each collapse, swap and move can be watched, undone and replayed, and"
    "every refusal is explained. Lessons tell what a mesh database stores."
    "The same program draws without a display.")
endif()
if(TARGET aomd-mpi)
  aomd_package(mpi aomd-mpi science "openmpi-bin"
    "makes surfaces coarser on several machines"
    "aomd-mpi is the command decimate of aomd for processes that mpirun"
    "starts: they share the blocks of a surface, which need not fit into"
    "the memory of one. The result is that of aomd, byte for byte.")
endif()
if(TARGET aomd_shared)
  set(runtime_package libaomd${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  aomd_package(runtime ${runtime_package} libs ""
    "mesh database and decimation, shared library"
    "What programs need that are linked with the library under aomd and"
    "aomd-view, in C++ or in C.")
  # What dpkg-shlibdeps and ldconfig want to know of it.
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/package/shlibs
    "libaomd ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${runtime_package} (>= ${PROJECT_VERSION})\n")
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/package/triggers "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_BINARY_DIR}/package/shlibs;${CMAKE_CURRENT_BINARY_DIR}/package/triggers")
  set(runtime_needed "${runtime_package} (= ${PROJECT_VERSION}), ")
endif()
if(TARGET aomd_python)
  get_target_property(minor aomd_python AOMD_PYTHON_MINOR)
  math(EXPR next_minor "${minor} + 1")
  aomd_package(python python3-aomd python
    "python3 (>= 3.${minor}~), python3 (<< 3.${next_minor}), python3-numpy"
    "makes meshes coarser, from Python"
    "The module aomd: meshes from and to NumPy, decimation with all options"
    "of the program aomd, checks, repair, comparison, step by step with undo,"
    "and pictures without a display.")
endif()
if(TINYGLTF_LIBRARY)
  set(gltf_needed "libtinygltf-dev, ")
endif()
aomd_package(library libaomd-dev libdevel
  "${runtime_needed}${gltf_needed}libglm-dev, libjpeg-dev, libmuparser-dev, libpng-dev, libpugixml-dev, libtinyobjloader-dev, zlib1g-dev"
  "mesh database and decimation for programs in C++ and C"
  "The library under aomd and aomd-view: an algorithm-oriented mesh"
  "database, classification on a geometric model, decimation, and what"
  "measures its results.")
aomd_package(documents aomd-doc doc ""
  "documents of AOMD Studio"
  "How meshes are stored, classified, decimated and looked at, with"
  "measurements, and all commands of aomd and aomd-view.")
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
include(CPack)
