# SPDX-License-Identifier: BSD-3-Clause
# What every target of the project shares: warnings, include root, sanitizers. Not: any list of sources.

# -ffp-contract=off: constants are folded in double-double arithmetic, which a contracted
# multiply-add would change, and with it the bytes of the emitted code.
add_library(kanec_flags INTERFACE)
target_compile_options(kanec_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(kanec_flags INTERFACE -Wno-restrict)  # false alarms on string + literal, GCC bug 105651
endif()
target_include_directories(kanec_flags INTERFACE ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/include)
if(KANEC_SANITIZE)
  target_compile_options(kanec_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(kanec_flags INTERFACE -fsanitize=address,undefined)
endif()
if(KANEC_FUZZ)
  target_compile_options(kanec_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# kanec_library(NAME SOURCES a.cpp b.cpp LINK other targets [PRECOMPILE heavy headers]): the link line is the whole
# permission of a folder. Sources still include what they use; precompiled headers only save time.
function(kanec_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRECOMPILE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC kanec_flags ${ARG_LINK})
  if(ARG_PRECOMPILE)
    target_precompile_headers(${name} PRIVATE ${ARG_PRECOMPILE})
  endif()
endfunction()

# kanec_test(NAME SOURCES ... LINK ...): one GoogleTest program; each test is known to ctest as NAME.Suite.test.
function(kanec_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${name} PRIVATE kanec_flags ${ARG_LINK} GTest::gtest_main GTest::gmock)
  target_precompile_headers(${name} PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
  target_compile_definitions(${name} PRIVATE KANEC_SOURCE_DIR="${CMAKE_SOURCE_DIR}" KANEC_BINARY_DIR="${CMAKE_BINARY_DIR}")
  gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300)
endfunction()
