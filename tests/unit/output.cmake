repose_test(unit_output_text LABEL unit SOURCES output_text_test.cpp LINK repose_output)
repose_test(unit_output_snapshot SANITIZED LABEL parallel RANKS 1 2 3 4 SOURCES output_snapshot_test.cpp LINK repose_output)

# The readers of the world, h5py and VTK's own, must see what was written.
add_executable(output_snapshot_writer output_snapshot_writer.cpp)
target_link_libraries(output_snapshot_writer PRIVATE repose_output)
set(system_python /usr/bin/python3)  # the one for which Debian packages h5py and VTK
foreach(ranks 1 3)
  add_test(NAME regression_read_snapshot.${ranks}
    COMMAND ${system_python} ${PROJECT_SOURCE_DIR}/tests/regression/read_snapshot.py
            ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:output_snapshot_writer>)
  set_tests_properties(regression_read_snapshot.${ranks} PROPERTIES LABELS regression TIMEOUT 300 PROCESSORS ${ranks})
endforeach()
