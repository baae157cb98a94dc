# cmake --install BUILD --prefix DIR: the program, what belongs to it, and the paths of the libraries it was linked with, so
# that those of modules are found without LD_LIBRARY_PATH.
include(GNUInstallDirs)
set(share ${CMAKE_INSTALL_DATADIR}/repose)
file(GLOB python_tools ${PROJECT_SOURCE_DIR}/tools/*.py)

install(TARGETS repose RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY input DESTINATION ${share})
install(DIRECTORY jobscripts DESTINATION ${share})
install(PROGRAMS ${python_tools} DESTINATION ${share}/tools)
install(DIRECTORY tools/python DESTINATION ${share} PATTERN __pycache__ EXCLUDE)
install(FILES packaging/repose.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES packaging/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME repose)
install(FILES README.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN *.md PATTERN *.png)
