# Installs the library so that find_package(portolan_core) of a project without ROS finds portolan::core.
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_NAME}-config-version.cmake COMPATIBILITY SameMinorVersion)

install(TARGETS ${PROJECT_NAME} EXPORT ${PROJECT_NAME}-targets
  ARCHIVE DESTINATION lib LIBRARY DESTINATION lib)
install(EXPORT ${PROJECT_NAME}-targets NAMESPACE portolan::
  DESTINATION lib/cmake/${PROJECT_NAME})
#catkin_lint: ignore_once missing_file
install(FILES cmake/${PROJECT_NAME}-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}-config-version.cmake
  DESTINATION lib/cmake/${PROJECT_NAME})
install(DIRECTORY include/ DESTINATION include)
