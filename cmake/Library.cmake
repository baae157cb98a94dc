# Flags shared by every target. The bits of the state must not depend on the compiler's mood: no contraction into fused
# multiply-adds. errno and floating-point traps are not used, so that square roots and selections can be vectorised.
add_library(repose_flags INTERFACE)
target_include_directories(repose_flags INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(repose_flags INTERFACE
  -Wno-psabi     # GCC warns of vectors as return values; ours only occur in functions that are always inlined
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 warns falsely in its own std::string (bug 105651)
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  $<$<BOOL:${REPOSE_WERROR}>:-Werror>)
# Without Open MPI's obsolete C++ classes, whose library is not linked.
target_compile_definitions(repose_flags INTERFACE OMPI_SKIP_MPICXX)

# The first finding ends the process. The environment for running such a build: test preset asan in CMakePresets.json.
option(REPOSE_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
# One build for both: the sources are instrumented once. Coverage, by which the fuzzer chooses, only where a target leads.
option(REPOSE_FUZZ "Build the fuzz targets with clang's libFuzzer, too" OFF)
set(FUZZED_ROOMS base comm files deck scene domain heat measurement output thermal)
# The compiler works longest on what it optimises and instruments; here no run and no test spends its time.
set(COLD_ROOMS deck files pictures output run campaign commands)
set(BRIEF_ROOMS pictures run campaign commands)
if(REPOSE_SANITIZE)
  set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize=float-cast-overflow>)
  target_compile_options(repose_flags INTERFACE ${sanitize})
  target_link_options(repose_flags INTERFACE ${sanitize})
endif()

# repose_library(NAME [SOURCES generated...] LINK ...): the library of one folder under src, of all its sources.
function(repose_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(repose_${name} STATIC ${sources} ${arg_SOURCES})
  target_link_libraries(repose_${name} PUBLIC repose_flags ${arg_LINK})
  if(REPOSE_FUZZ AND name IN_LIST FUZZED_ROOMS)
    target_compile_options(repose_${name} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(name IN_LIST COLD_ROOMS)
    target_compile_options(repose_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(REPOSE_SANITIZE AND name IN_LIST BRIEF_ROOMS)
    target_compile_options(repose_${name} PRIVATE -O0)
  endif()
endfunction()
