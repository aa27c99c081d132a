# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
#
# The ROS 2 package is configured: against the installed library, and stand-ins for ROS's packages
# with the targets, variables and calls that theirs have.
#
#   cmake -D sources=DIR -D prefix=DIR -D compiler=FILE -D folder=DIR -P check_ros2.cmake
file(REMOVE_RECURSE ${folder})
set(stand_ins ${folder}/stand_ins)
foreach(name rclcpp tf2_ros)
  file(WRITE ${stand_ins}/Find${name}.cmake
    "add_library(${name}::${name} INTERFACE IMPORTED)\nset(${name}_INTERFACES ${name}::${name})\n")
endforeach()
foreach(name nav_msgs sensor_msgs)
  set(target ${name}::${name}__rosidl_generator_cpp)
  file(WRITE ${stand_ins}/Find${name}.cmake
    "add_library(${target} INTERFACE IMPORTED)\nset(${name}_TARGETS ${target})\nset(${name}_INTERFACES ${target})\n")
endforeach()
# As ament's, which names no keyword: CMake takes no mixture with PRIVATE.
file(WRITE ${stand_ins}/Findament_cmake.cmake [[
function(ament_target_dependencies target)
  foreach(name ${ARGN})
    target_link_libraries(${target} ${${name}_INTERFACES})
  endforeach()
endfunction()
macro(ament_package)
endmacro()
]])
execute_process(COMMAND ${CMAKE_COMMAND} -S ${sources} -B ${folder}/build
  -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_MODULE_PATH=${stand_ins}
  RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the ROS 2 package cannot be configured:\n${said}")
endif()
