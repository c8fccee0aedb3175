# Tests that lose the Vulkan device or run out of its memory, by a layer of their own. Included by CMakeLists.txt.
find_package(Vulkan REQUIRED)
find_path(RTGLYPHS_LAYER_HEADER vulkan/vk_layer.h HINTS ${Vulkan_INCLUDE_DIRS})
if (NOT RTGLYPHS_LAYER_HEADER)
  message(STATUS "No test of a lost device: vulkan/vk_layer.h was not found")
  return ()
endif ()
add_library(rtglyphs_fault_layer MODULE FaultLayer.cxx)
target_include_directories(rtglyphs_fault_layer PRIVATE "${RTGLYPHS_LAYER_HEADER}" ${Vulkan_INCLUDE_DIRS})
target_compile_features(rtglyphs_fault_layer PRIVATE cxx_std_17)
rtglyphs_warnings(rtglyphs_fault_layer)
set(layers "${CMAKE_CURRENT_BINARY_DIR}/layers")
file(GENERATE OUTPUT "${layers}/fault_layer.json" INPUT "${regression}/fault_layer.json.in")
foreach (test IN ITEMS LostDevice:lost_device FailedImage:failed_image)
  string(REPLACE ":" ";" test "${test}")
  list(GET test 0 name)
  list(GET test 1 script)
  rtglyphs_regression_test(${name} SERIAL
    ENVIRONMENT "VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation:VK_LAYER_RTGLYPHS_fault"
      "VK_ADD_LAYER_PATH=${layers}" "RTGLYPHS_FAULT=${output}/lose-device"
    COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/${script}.py")
endforeach ()
