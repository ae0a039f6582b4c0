# Every library that the program needs, each checked for the features it must have, each with the sentence that says
# what to install when it is missing.

macro(birdstrike_require condition sentence)
  if(NOT ${condition})
    message(FATAL_ERROR "${sentence}")
  endif()
endmacro()

find_package(deal.II 9.4 QUIET HINTS $ENV{DEAL_II_DIR})
birdstrike_require(deal.II_FOUND "deal.II 9.4 or newer is needed: apt-get install libdeal.ii-dev, or set DEAL_II_DIR.")
foreach(feature MPI P4EST TRILINOS HDF5)
  birdstrike_require(DEAL_II_WITH_${feature}
    "deal.II was built without ${feature}: install libdeal.ii-dev (Debian) or rebuild deal.II with -DDEAL_II_WITH_${feature}=ON.")
endforeach()

# deal.II up to 9.5 names its include folders and libraries, later versions have targets alone.
set(dealii_folders ${DEAL_II_INCLUDE_DIRS})
set(dealii_libraries ${DEAL_II_LIBRARIES})
if(NOT dealii_libraries)
  set(dealii_libraries ${DEAL_II_TARGET})
  if(TARGET dealii::interface_trilinos)
    get_target_property(dealii_folders dealii::interface_trilinos INTERFACE_INCLUDE_DIRECTORIES)
  endif()
endif()

# Static equilibrium and modes need these packages of Trilinos. Trilinos 17 has no Epetra: strikes are computed without.
set(BIRDSTRIKE_IMPLICIT AUTO CACHE STRING "Static equilibrium and modes, by Trilinos' Epetra: ON, OFF, or AUTO (where it is)")
set_property(CACHE BIRDSTRIKE_IMPLICIT PROPERTY STRINGS AUTO ON OFF)
set(birdstrike_has_epetra ON)
foreach(header Epetra_CrsMatrix.h Amesos.h ml_MultiLevelPreconditioner.h AnasaziEpetraAdapter.hpp)
  string(MAKE_C_IDENTIFIER ${header} name)
  find_path(BIRDSTRIKE_${name} ${header} HINTS ${dealii_folders} NO_CACHE)
  if(NOT BIRDSTRIKE_${name})
    set(birdstrike_has_epetra OFF)
    set(missing ${header})
  endif()
endforeach()
if(BIRDSTRIKE_IMPLICIT STREQUAL "ON")
  birdstrike_require(birdstrike_has_epetra
    "deal.II's Trilinos has no ${missing}: install libtrilinos-epetra-dev, libtrilinos-amesos-dev, libtrilinos-ml-dev and libtrilinos-anasazi-dev (Debian), rebuild Trilinos (up to 16) with them, or set -DBIRDSTRIKE_IMPLICIT=OFF.")
elseif(NOT birdstrike_has_epetra OR BIRDSTRIKE_IMPLICIT STREQUAL "OFF")
  message(STATUS "Without static equilibrium and modes: Trilinos' Epetra, Amesos, ML and Anasazi are not used.")
  set(birdstrike_has_epetra OFF)
endif()

find_package(Eigen3 QUIET NO_MODULE) # without a version: Eigen 5 says that it does not replace 3.4
if(Eigen3_FOUND AND Eigen3_VERSION VERSION_LESS 3.4)
  set(Eigen3_FOUND OFF)
endif()
birdstrike_require(Eigen3_FOUND "Eigen 3.4 or newer is needed: apt-get install libeigen3-dev.")
find_package(spdlog 1.10 QUIET)
birdstrike_require(spdlog_FOUND "spdlog 1.10 or newer is needed: apt-get install libspdlog-dev libfmt-dev.")
find_package(CLI11 2.1 QUIET)
birdstrike_require(CLI11_FOUND "CLI11 2.1 or newer is needed: apt-get install libcli11-dev.")
find_package(nlohmann_json 3.11 QUIET)
birdstrike_require(nlohmann_json_FOUND "JSON for Modern C++ 3.11 or newer is needed: apt-get install nlohmann-json3-dev.")
find_package(Threads QUIET)
birdstrike_require(Threads_FOUND "A thread library is needed: install the C library's development files.")
if(BIRDSTRIKE_TESTS)
  find_package(GTest 1.12 QUIET)
  birdstrike_require(GTest_FOUND "GoogleTest 1.12 or newer is needed: apt-get install libgtest-dev (or -DBIRDSTRIKE_TESTS=OFF).")
endif()

# deal.II's own compile flags (unrolling, its warning list) stay out where it allows: only headers, libraries and its DEBUG switch.
add_library(birdstrike_dealii INTERFACE)
target_include_directories(birdstrike_dealii SYSTEM INTERFACE ${dealii_folders})
target_link_libraries(birdstrike_dealii INTERFACE ${dealii_libraries})
# MPI's deprecated C++ bindings are not used; without this their inline functions are compiled into every file.
target_compile_definitions(birdstrike_dealii INTERFACE OMPI_SKIP_MPICXX)
# deal.II brings some two hundred shared libraries. GNU ld 2.40 searches through their own dependencies for more than five
# minutes an executable, GNU ld 2.44 for 14 s; mold, gold and lld take one or two.
find_program(BIRDSTRIKE_LINKER NAMES ld.gold ld.mold ld.lld)
if(BIRDSTRIKE_LINKER)
  get_filename_component(linker ${BIRDSTRIKE_LINKER} EXT)
  string(SUBSTRING ${linker} 1 -1 linker)
  target_link_options(birdstrike_dealii INTERFACE -fuse-ld=${linker})
endif()
target_compile_definitions(birdstrike_dealii INTERFACE $<$<CONFIG:Debug>:DEBUG>)
