# One library per room. Usage: birdstrike_room(blade DEPENDS core material LIBRARIES birdstrike_dealii)

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
endif()
if(BIRDSTRIKE_SANITIZE)
  target_compile_options(birdstrike_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(birdstrike_options INTERFACE -fsanitize=address,undefined)
endif()
# Sums keep their order (bitwise repeatable); errno and traps of the math library are not used.
target_compile_options(birdstrike_options INTERFACE $<$<CONFIG:Release>:-O3> -fno-math-errno -fno-trapping-math)
# The build id tells stored runs of one build from those of another (core/program.h).
target_link_options(birdstrike_options INTERFACE -Wl,--as-needed -Wl,--build-id=sha1)

function(birdstrike_room name)
  cmake_parse_arguments(ROOM "" "" "DEPENDS;LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/source/${name}/*.cc)
  list(TRANSFORM ROOM_DEPENDS PREPEND birdstrike_)
  add_library(birdstrike_${name} STATIC ${sources})
  target_link_libraries(birdstrike_${name} PUBLIC birdstrike_options Eigen3::Eigen ${ROOM_DEPENDS} ${ROOM_LIBRARIES})
endfunction()

# Unit tests of one room: tests/unit/<room>/*.cc become the executable <room>_tests, one CTest entry per TEST.
function(birdstrike_unit_tests name)
  cmake_parse_arguments(TESTS "" "" "LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/unit/${name}/*.cc)
  add_executable(${name}_tests ${sources})
  target_link_libraries(${name}_tests PRIVATE birdstrike_${name} GTest::gtest_main ${TESTS_LIBRARIES})
  target_compile_definitions(${name}_tests PRIVATE BIRDSTRIKE_TEST_DATA="${CMAKE_SOURCE_DIR}/tests/data"
    BIRDSTRIKE_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  gtest_discover_tests(${name}_tests TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 900)
endfunction()
