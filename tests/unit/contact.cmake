repose_test(unit_contact LABEL unit
  SOURCES contact_law_test.cpp contact_options_test.cpp contact_materials_test.cpp contact_fixed_point_test.cpp contact_pair_loop_test.cpp
          contact_walls_test.cpp
  LINK repose_test_scenes)

# Nothing else would notice that an innocent change has cost the pair loop its vector instructions, or has let the
# compiler fuse operations. Only an optimised build without instrumentation is vectorised at all.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT REPOSE_SANITIZE)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  add_test(NAME unit_contact_vectorised
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/contact_vectorised.py $<TARGET_FILE:repose_contact>)
  set_tests_properties(unit_contact_vectorised PROPERTIES LABELS unit SKIP_RETURN_CODE 77)
endif()
