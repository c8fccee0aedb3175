# Tests that lose the Vulkan device or run out of its memory, by a layer of their own. Included by CMakeLists.txt.
if (NOT rtglyphs_fault_layer_folder)
  return ()
endif ()
foreach (test IN ITEMS LostDevice:lost_device FailedImage:failed_image)
  string(REPLACE ":" ";" test "${test}")
  list(GET test 0 name)
  list(GET test 1 script)
  rtglyphs_regression_test(${name}
    ENVIRONMENT "VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation:VK_LAYER_RTGLYPHS_fault"
      "VK_ADD_LAYER_PATH=${rtglyphs_fault_layer_folder}" "RTGLYPHS_FAULT=${output}/fault-${script}"
    COMMAND "${RTGLYPHS_PVPYTHON}" "${regression}/${script}.py")
endforeach ()
