# find_package(portolan_core) for projects without ROS; gives the target portolan::core.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(octomap)
find_dependency(yaml-cpp)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/portolan_core-targets.cmake)
