repose_test(unit_integration LABEL unit SOURCES integration_verlet_test.cpp integration_time_step_test.cpp
  LINK repose_test_scenes)
