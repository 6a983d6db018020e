# What every portolan package builds with: C++17, Release unless said otherwise, warnings, and on request
# warnings as errors and sanitizers. Works with catkin and without.
include_guard(GLOBAL)

option(PORTOLAN_WERROR "Treat compiler warnings as errors" OFF)
set(PORTOLAN_SANITIZE "" CACHE STRING "Sanitizers for all our targets, such as address,undefined")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Type of build" FORCE)
endif()

# portolan_target_defaults(<target>...): language, warnings and sanitizers of a target of ours.
function(portolan_target_defaults)
  foreach(target IN LISTS ARGN)
    target_compile_features(${target} PUBLIC cxx_std_17)
    set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_EXTENSIONS OFF)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
    if(PORTOLAN_WERROR)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
    if(PORTOLAN_SANITIZE)
      # GCC warns of uninitialized parts of std::variant where it instruments; ordinary builds keep that warning.
      set(sanitize -fsanitize=${PORTOLAN_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
      target_compile_options(${target} PRIVATE ${sanitize})
      target_link_options(${target} PRIVATE ${sanitize})
    endif()
  endforeach()
endfunction()

# portolan_add_tests(<library>...): one GoogleTest executable, <package>_test, from all of test/**/*.cpp that is
# not a *_rostest.cpp, linked to the libraries.
function(portolan_add_tests)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS test/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_rostest\\.cpp$")
  if(NOT sources)
    return()
  endif()
  set(target ${PROJECT_NAME}_test)
  if(COMMAND catkin_add_gtest)
    if(NOT CATKIN_ENABLE_TESTING)
      return()
    endif()
    catkin_add_gtest(${target} ${sources})
  else()
    find_package(GTest REQUIRED)
    add_executable(${target} ${sources})
    target_link_libraries(${target} GTest::GTest)
    # In eight parts, so that `ctest -j` has something to share out.
    foreach(part RANGE 7)
      add_test(NAME ${target}_${part} COMMAND ${target})
      set_tests_properties(${target}_${part} PROPERTIES
        ENVIRONMENT "GTEST_TOTAL_SHARDS=8;GTEST_SHARD_INDEX=${part}")
    endforeach()
  endif()
  if(TARGET GTest::gtest_main)
    target_link_libraries(${target} GTest::gtest_main)
  elseif(TARGET gtest_main)
    target_link_libraries(${target} gtest_main)
  else()
    target_link_libraries(${target} GTest::Main)
  endif()
  target_link_libraries(${target} ${ARGN})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/test)
  portolan_target_defaults(${target})
endfunction()
