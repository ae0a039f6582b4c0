# One library per room. Usage: birdstrike_room(blade DEPENDS core material LIBRARIES birdstrike_dealii ALONE elements/)
# Most of a file's compilation is Eigen and SIMD: several files at a time read them once (BIRDSTRIKE_UNITY). Files whose path matches a
# regular expression of ALONE are compiled by themselves: loops of a step, which the compiler optimises as they stand, and files that share
# a name outside functions. Headers of PRECOMPILE, Eigen and SIMD above all, are parsed once for these.

add_library(birdstrike_options INTERFACE)
target_compile_options(birdstrike_options INTERFACE -Wall -Wextra -Wpedantic)
# include/ holds what other rooms may see; a room names its own headers from source/.
target_include_directories(birdstrike_options INTERFACE ${CMAKE_SOURCE_DIR}/include ${CMAKE_SOURCE_DIR}/source)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(birdstrike_options INTERFACE -Wno-restrict) # false alarms in std::string (GCC bug 105329)
endif()
if(BIRDSTRIKE_WERROR)
  target_compile_options(birdstrike_options INTERFACE -Werror)
endif()
if(BIRDSTRIKE_NATIVE)
  target_compile_options(birdstrike_options INTERFACE -march=native)
  # Structures of whole registers are copied as such: a register of 64 bytes that is read from two halves waits until both
  # have left the store buffer. GCC copies by 32 bytes wherever it prefers them for its own vectors.
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag("-mmove-max=512 -mstore-max=512" BIRDSTRIKE_HAS_MOVE_MAX)
  if(BIRDSTRIKE_HAS_MOVE_MAX)
    target_compile_options(birdstrike_options INTERFACE -mmove-max=512 -mstore-max=512)
  endif()
endif()
if(BIRDSTRIKE_SANITIZE)
  set(sanitizers_address address,undefined)
  set(sanitizers_thread thread)
  if(NOT DEFINED sanitizers_${BIRDSTRIKE_SANITIZE})
    message(FATAL_ERROR "BIRDSTRIKE_SANITIZE is '${BIRDSTRIKE_SANITIZE}'. Allowed: OFF, address (with undefined behaviour), thread.")
  endif()
  set(sanitizers -fsanitize=${sanitizers_${BIRDSTRIKE_SANITIZE}} -fno-sanitize-recover=all)
  target_compile_options(birdstrike_options INTERFACE ${sanitizers} -fno-omit-frame-pointer)
  target_link_options(birdstrike_options INTERFACE ${sanitizers})
endif()
# Eigen's products of lanes stay in registers. GCC takes the inlining that Eigen asks for as a wish, and left 77 calls of a scalar product,
# before each of which all registers are put away, in the loop over shells. Not with a sanitizer, as BIRDSTRIKE_FLATTEN.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT BIRDSTRIKE_SANITIZE)
  target_compile_definitions(birdstrike_options INTERFACE "EIGEN_STRONG_INLINE=inline __attribute__((always_inline))")
endif()
# Sums keep their order (bitwise repeatable); errno and traps of the math library are not used.
target_compile_options(birdstrike_options INTERFACE $<$<CONFIG:Release>:-O3> -fno-math-errno -fno-trapping-math)
# The build id tells stored runs of one build from those of another (core/program.h).
target_link_options(birdstrike_options INTERFACE -Wl,--as-needed -Wl,--build-id=sha1)

function(birdstrike_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 forgets in a precompiled header where number.h silences its own AVX-512 intrinsics (GCC bug 105593).
    target_compile_options(${target} PRIVATE -Wno-uninitialized -Wno-maybe-uninitialized)
  endif()
endfunction()

function(birdstrike_room name)
  cmake_parse_arguments(ROOM "" "" "DEPENDS;LIBRARIES;ALONE;PRECOMPILE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/source/${name}/*.cc)
  list(TRANSFORM ROOM_DEPENDS PREPEND birdstrike_)
  add_library(birdstrike_${name} STATIC ${sources})
  if(BIRDSTRIKE_UNITY)
    set_target_properties(birdstrike_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    foreach(pattern ${ROOM_ALONE})
      set(alone ${sources})
      list(FILTER alone INCLUDE REGEX "/source/${name}/.*${pattern}")
      set_source_files_properties(${alone} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      set_property(GLOBAL APPEND PROPERTY BIRDSTRIKE_ALONE ${alone})
    endforeach()
  endif()
  target_link_libraries(birdstrike_${name} PUBLIC birdstrike_options Eigen3::Eigen ${ROOM_DEPENDS} ${ROOM_LIBRARIES})
  if(BIRDSTRIKE_UNITY AND ROOM_PRECOMPILE)
    birdstrike_precompile(birdstrike_${name} ${ROOM_PRECOMPILE})
  endif()
endfunction()

# Unit tests of one room: tests/unit/<room>/*.cc become the executable <room>_tests. Those that READ_FILES of the source
# tree are told where it is; the others compile alike in every clone. Nine tenths of a test's compilation are headers:
# several files at a time read them once. CTest runs the executable in so many PARTS, each every n-th TEST in a process of
# its own, side by side; a process for each TEST would load the two hundred libraries of deal.II a thousand times, 0.27 s
# each. One TEST alone: bin/<room>_tests --gtest_filter=Suite.Name.
function(birdstrike_unit_tests name)
  cmake_parse_arguments(TESTS "READ_FILES" "PARTS" "LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/unit/${name}/*.cc)
  add_executable(${name}_tests ${sources})
  target_link_libraries(${name}_tests PRIVATE birdstrike_${name} GTest::gtest_main ${TESTS_LIBRARIES})
  if(TESTS_READ_FILES)
    target_compile_definitions(${name}_tests PRIVATE BIRDSTRIKE_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  endif()
  if(BIRDSTRIKE_UNITY_TESTS)
    set_target_properties(${name}_tests PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # it takes a batch's files for headers, whose fixtures should have a name
      target_compile_options(${name}_tests PRIVATE -Wno-subobject-linkage)
    endif()
  endif()
  set(longest 900) # s
  if(BIRDSTRIKE_SANITIZE) # some twenty times as long
    set(longest 7200)
  endif()
  foreach(part RANGE 1 ${TESTS_PARTS})
    set(test ${name}.part_${part}_of_${TESTS_PARTS})
    math(EXPR index "${part} - 1")
    add_test(NAME ${test} COMMAND ${name}_tests --gtest_brief=1)
    set_tests_properties(${test} PROPERTIES TIMEOUT ${longest}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${TESTS_PARTS};GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()
