"""Extensions of colcon: packages of build type ament_cmake, without CMake. Only this folder imports colcon."""
