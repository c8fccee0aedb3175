# Builds the plugin, with all that it is built with, for a ParaView of paraview.org, in one of Kitware's images, which hold that ParaView and its compiler:
#   docker run --rm -v "$PWD:/source" -w /source kitware/paraview_org-plugin-devel:6.1.1 \
#     scl enable gcc-toolset-10 -- cmake -P Testing/Setup/build_for_binaries.cmake
# Leaves build-binaries/RayTracedGlyphs-...tar.xz. README.md beside this file says more.
#   -DPARAVIEW=DIR     another ParaView, with its development files
#   -DSOURCES=PLACE    another place for the sources of what it is built with (dependencies/CMakeLists.txt)
#   -DBUILD=DIR        another folder to build in
#   -DOPTIONS=LIST     further options for the configuration of the plugin
cmake_minimum_required(VERSION 3.21)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH clone)
cmake_path(GET clone PARENT_PATH clone)
if (NOT BUILD)
  set(BUILD "${clone}/build-binaries")
endif ()

# Where the images have ParaView. On GitLab, which lays its own folder over /builds, it is elsewhere, but looked for here.
if (NOT PARAVIEW)
  if (CMAKE_HOST_WIN32)
    set(PARAVIEW "C:/pv/build/install")
  else ()
    set(PARAVIEW /builds/gitlab-kitware-sciviz-ci/build/install)
    if (NOT EXISTS "${PARAVIEW}" AND EXISTS /paraview/gitlab-kitware-sciviz-ci)
      file(CREATE_LINK /paraview/gitlab-kitware-sciviz-ci /builds/gitlab-kitware-sciviz-ci SYMBOLIC)
    endif ()
  endif ()
endif ()
file(GLOB_RECURSE found "${PARAVIEW}/lib*/paraview-config.cmake")
if (NOT found)
  message(FATAL_ERROR "There is no ParaView with its development files in '${PARAVIEW}'. Run this in one of Kitware's images, or name another with -DPARAVIEW=DIR.")
endif ()

set(generator)
find_program(ninja NAMES ninja ninja-build)
if (ninja)
  set(generator -G Ninja "-DCMAKE_MAKE_PROGRAM=${ninja}")
endif ()
function (run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction ()

set(dependencies "${BUILD}/dependencies")
set(options)
if (SOURCES)
  set(options "-DSOURCES=${SOURCES}")
endif ()
# SPIRV-Tools asks for Python, which ParaView has.
run("${CMAKE_COMMAND}" -S "${clone}/Testing/Setup/dependencies" -B "${BUILD}/dependencies-build" ${generator}
  "-DCMAKE_INSTALL_PREFIX=${dependencies}" ${options})
run("${CMAKE_COMMAND}" --build "${BUILD}/dependencies-build")

run("${CMAKE_COMMAND}" -S "${clone}" -B "${BUILD}/plugin" ${generator} -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DRTGLYPHS_USE_QT=ON
  "-DCMAKE_PREFIX_PATH=${dependencies};${PARAVIEW}" -DCMAKE_INSTALL_LIBDIR=lib
  -DVulkan_LIBRARY=unused # nothing links it, but CMake looks for it
  ${OPTIONS})
run("${CMAKE_COMMAND}" --build "${BUILD}/plugin" --parallel)
run("${CMAKE_COMMAND}" --install "${BUILD}/plugin" --prefix "${BUILD}/install")
run("${CMAKE_COMMAND}" -E chdir "${BUILD}/plugin" "${CMAKE_CPACK_COMMAND}" -B "${BUILD}")
