# Lets find_package(ParaView) pass on Debian 13 and newer. To be included before it.
#
# Debian's paraview-dev lists ParaView's Python modules as NAME.so, but its package has NAME.cpython-VERSION.so, and CMake's
# check that the files of a package exist ends with an error. A plugin links none of these modules.
# This file asks CMake to leave the check out for the targets of modules that are there under the other name, and for no
# others. CMake 3.28 and newer skip the check for a target whose variable _cmake_import_check_xcframework_for_TARGET
# names a folder; older versions have no such means, and Debian 13 and newer have newer ones.
file(GLOB rtglyphs_target_files
  "${ParaView_DIR}/ParaViewPython*-targets-*.cmake"
  "${ParaView_DIR}/vtk/VTKPython-targets-*.cmake"
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/ParaViewPython*-targets-*.cmake"
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/vtk/VTKPython-targets-*.cmake")
set(rtglyphs_module_pattern [[_cmake_import_check_files_for_([^ ]+) "\${_IMPORT_PREFIX}/(lib/python3/dist-packages/[^"]+)\.so"]])
foreach (target_file IN LISTS rtglyphs_target_files)
  file(STRINGS "${target_file}" lines REGEX "${rtglyphs_module_pattern}")
  foreach (line IN LISTS lines)
    string(REGEX MATCH "${rtglyphs_module_pattern}" line "${line}")
    set(target "${CMAKE_MATCH_1}")
    set(module "/usr/${CMAKE_MATCH_2}")
    file(GLOB present "${module}.cpython-*.so")
    if (present AND NOT EXISTS "${module}.so")
      set("_cmake_import_check_xcframework_for_${target}" "${CMAKE_CURRENT_LIST_DIR}")
    endif ()
  endforeach ()
endforeach ()
unset(rtglyphs_module_pattern)
unset(rtglyphs_target_files)
