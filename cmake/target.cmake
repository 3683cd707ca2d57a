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
target_include_directories(kanec_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include)
if(KANEC_SANITIZE)
  target_compile_options(kanec_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(kanec_flags INTERFACE -fsanitize=address,undefined)
endif()
if(KANEC_FUZZ)
  target_compile_options(kanec_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Compiles the sources as few, of at most `most` each and as many in each.
function(kanec_unity name most)
  if(KANEC_UNITY)
    list(LENGTH ARGN count)
    math(EXPR batches "(${count} + ${most} - 1) / ${most}")
    math(EXPR batch_size "(${count} + ${batches} - 1) / ${batches}")
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch_size})
  endif()
endfunction()

# kanec_library(NAME SOURCES a.cpp b.cpp LINK other targets [PRECOMPILE heavy headers] [ALONE] [COLD]): the link line is the
# whole permission of a folder. Sources still include what they use; that several are compiled as one (KANEC_UNITY) and
# precompiled headers only save time. Names in a folder's unnamed namespaces differ for that. ALONE: one by one, where a
# source is large by itself. COLD: nothing in it is hot, and a compiler is quicker that optimises less.
function(kanec_library name)
  cmake_parse_arguments(ARG "ALONE;COLD" "" "SOURCES;LINK;PRECOMPILE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  if(NOT ARG_ALONE)
    kanec_unity(${name} 12 ${ARG_SOURCES})
  endif()
  target_link_libraries(${name} PUBLIC kanec_flags ${ARG_LINK})
  if(ARG_COLD)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(ARG_PRECOMPILE)
    target_precompile_headers(${name} PRIVATE ${ARG_PRECOMPILE})
  endif()
endfunction()

# What all test programs share: GoogleTest's headers precompiled once, and where things are.
function(kanec_test_flags name)
  target_link_libraries(${name} PRIVATE kanec_flags Threads::Threads GTest::gtest_main GTest::gmock)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_compile_definitions(${name} PRIVATE KANEC_SOURCE_DIR="${PROJECT_SOURCE_DIR}" KANEC_BINARY_DIR="${PROJECT_BINARY_DIR}")
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)  # as the shared headers, in programs as well
endfunction()

# kanec_test(NAME SOURCES ... LINK ... [ALONE] [OWN_FLAGS]): one GoogleTest program; each test is known to ctest as
# NAME.Suite.test. OWN_FLAGS: compiled with others than the shared headers.
function(kanec_test name)
  cmake_parse_arguments(ARG "ALONE;OWN_FLAGS" "" "SOURCES;LINK" ${ARGN})
  if(NOT TARGET kanec_test_headers)
    file(WRITE ${PROJECT_BINARY_DIR}/tests/headers.cpp "// Nothing but the headers that are precompiled.\n")
    add_library(kanec_test_headers STATIC ${PROJECT_BINARY_DIR}/tests/headers.cpp)
    kanec_test_flags(kanec_test_headers)
    target_precompile_headers(kanec_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  kanec_test_flags(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  if(NOT ARG_ALONE)
    kanec_unity(${name} 8 ${ARG_SOURCES})
  endif()
  if(NOT ARG_OWN_FLAGS)
    target_precompile_headers(${name} REUSE_FROM kanec_test_headers)
  endif()
  gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300)
endfunction()
