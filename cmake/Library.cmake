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
# Where runs spend their time: tests have them as users do, each source by itself, but under the sanitizers.
set(HOT_ROOMS base comm contact domain integration neighbours simulation)
if(REPOSE_SANITIZE)
  set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize=float-cast-overflow>)
  target_compile_options(repose_flags INTERFACE ${sanitize})
  target_link_options(repose_flags INTERFACE ${sanitize})
endif()

# Off by default: an include that is missing is found by a build without, such as that of tools/run-tests.sh --slow.
option(REPOSE_JOIN "Compile many sources of a library as one, for quicker builds from nothing" OFF)
add_library(repose_joined INTERFACE)
target_compile_options(repose_joined INTERFACE -Wno-shadow)  # sources need not know each other's names

# repose_join(TARGET [PATTERN...]): compiles the sources of a target together, but for those whose paths match, since they and
# others of the target have helpers of the same name.
function(repose_join target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  target_link_libraries(${target} PRIVATE repose_joined)  # last, since its option comes after -Wshadow
  if(ARGN)
    list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    file(GLOB apart CONFIGURE_DEPENDS ${ARGN})
    set_source_files_properties(${apart} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# repose_library(NAME [SOURCES generated...] LINK ... [APART pattern...]): the library of one folder under src, of all its
# sources; APART as the patterns of repose_join.
function(repose_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;APART" ${ARGN})
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
  if(REPOSE_JOIN AND (REPOSE_SANITIZE OR NOT name IN_LIST HOT_ROOMS))
    repose_join(repose_${name} ${arg_APART})
  endif()
endfunction()
