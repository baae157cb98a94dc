repose_test(unit_simulation LABEL unit
  SOURCES simulation_phases_test.cpp simulation_measures_test.cpp simulation_hash_test.cpp
  LINK repose_test_scenes
  APART simulation_hash_test.cpp)
