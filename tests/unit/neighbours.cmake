repose_test(unit_neighbours LABEL unit SOURCES neighbours_pair_lists_test.cpp neighbours_skin_watch_test.cpp
  LINK repose_test_scenes)
