# Builds the plugin outside ParaView's own tree, against an installed ParaView.

# Without Qt the plugin needs only ParaView's server side, and so no Qt packages on the machine.
# ParaView says itself whether, and with which, it was built; Qt's development files must be there too. They are only
# looked for: once one version is loaded, ParaView can no longer load the other.
set(rtglyphs_qt_places)
foreach (version IN ITEMS 6 5)
  list(APPEND rtglyphs_qt_places lib/cmake/Qt${version} lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/Qt${version})
endforeach ()
find_file(RTGLYPHS_QT_CONFIG NAMES Qt6Config.cmake Qt5Config.cmake
  HINTS ${CMAKE_PREFIX_PATH} "${Qt6_DIR}" "${Qt5_DIR}"
  PATHS ${CMAKE_SYSTEM_PREFIX_PATH}
  PATH_SUFFIXES ${rtglyphs_qt_places})
mark_as_advanced(RTGLYPHS_QT_CONFIG)
set(rtglyphs_qt_found OFF)
if (RTGLYPHS_QT_CONFIG)
  set(rtglyphs_qt_found ON)
endif ()
option(RTGLYPHS_USE_QT "Build the parts for ParaView's graphical interface" ${rtglyphs_qt_found})

include("${CMAKE_CURRENT_LIST_DIR}/DebianPythonModules.cmake")
if (RTGLYPHS_USE_QT)
  find_package(ParaView 5.11 REQUIRED)
  if (NOT PARAVIEW_USE_QT)
    message(STATUS "RayTracedGlyphs: ${ParaView_DIR} was built without Qt; building without it.")
  endif ()
else ()
  # ParaView finds the packages that the VTK modules of the named components need, but not what those of its modules
  # beneath need (HDF5, NetCDF, Python), so these are named as well.
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingViews RemotingServerManager)
  set(PARAVIEW_USE_QT OFF)
endif ()

set(_paraview_plugin_default_RayTracedGlyphs ON)
paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/paraview.plugin"
  PROVIDES_PLUGINS rtglyphs_plugins
  REQUIRES_MODULES rtglyphs_required_modules)

foreach (module IN LISTS rtglyphs_required_modules)
  if (NOT TARGET "${module}")
    message(FATAL_ERROR "RayTracedGlyphs needs the ParaView module ${module}, "
      "which ${ParaView_DIR} does not have.")
  endif ()
endforeach ()

# paraview_plugin_build() adds the folder of the scanned file as a subdirectory. That is this
# project's root, which would add itself; the plugin's own folder is meant.
set_property(GLOBAL PROPERTY _paraview_plugin_RayTracedGlyphs_file
  "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin")

# What users need is the component `plugin`, which is installed unless another one is asked for: ParaView's macros also
# install archives for programs that link modules statically.
install(CODE "if (NOT CMAKE_INSTALL_COMPONENT)\n  set(CMAKE_INSTALL_COMPONENT plugin)\nendif ()")
paraview_plugin_build(
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME "raytracedglyphs.xml"
  PLUGINS_COMPONENT plugin
  TARGET_COMPONENT plugin
  INSTALL_HEADERS OFF
  PLUGINS ${rtglyphs_plugins})
# Documents that users read, in the folders in which they refer to each other.
foreach (document LICENSE README.md Data/RECIPES.md Plugin/CHANGES.md Plugin/LIMITS.md Representation/FEATURES.md
    Representation/PROPERTIES.md Representation/README.md)
  cmake_path(GET document PARENT_PATH folder)
  install(FILES ${document} DESTINATION "${CMAKE_INSTALL_DOCDIR}/${folder}" COMPONENT plugin)
endforeach ()
add_custom_target(uninstall
  COMMAND "${CMAKE_COMMAND}" "-DMANIFEST=${CMAKE_BINARY_DIR}/install_manifest_plugin.txt"
    -P "${CMAKE_CURRENT_LIST_DIR}/Uninstall.cmake"
  VERBATIM)

# `cpack` in the build folder packs what is installed.
set(CPACK_GENERATOR TXZ)
set(CPACK_PACKAGE_FILE_NAME "RayTracedGlyphs-${PROJECT_VERSION}-paraview-${ParaView_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_STRIP_FILES ON)
include(CPack)
