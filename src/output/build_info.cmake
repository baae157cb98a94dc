# cmake -Dsource=DIR -Dgit=PROGRAM -Dversion=... -Dcompiler=... -Dflags=... -Doutput=FILE -P build_info.cmake
# Writes build_info.cpp, untouched when nothing changed. A source tree without its own .git (a tarball, perhaps unpacked
# inside another repository) has no commit.
set(commit "")
if(git AND EXISTS ${source}/.git)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0
                          ${git} -C ${source} describe --always --abbrev=40 --dirty --exclude=*
                  OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(NOT commit)
  set(commit unknown)
endif()
string(STRIP "${flags}" flags)
configure_file(${CMAKE_CURRENT_LIST_DIR}/build_info.cpp.in ${output} @ONLY)
