repose_test(scene_wall_tests LABEL unit
  SOURCES scene_flat_wall_test.cpp scene_profile_test.cpp scene_touch_test.cpp scene_motion_test.cpp scene_servo_test.cpp
          scene_wall_surface_test.cpp
  LINK repose_scene
  APART scene_profile_test.cpp scene_servo_test.cpp)
target_include_directories(scene_wall_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests)
repose_test(scene_insertion_tests LABEL unit
  SOURCES scene_csv_test.cpp scene_fill_test.cpp scene_insertion_test.cpp scene_overlap_test.cpp
          scene_periodicity_test.cpp scene_placement_test.cpp
  LINK repose_scene
  APART scene_insertion_test.cpp)
repose_test(scene_size_tests LABEL unit
  SOURCES scene_size_csv_test.cpp scene_sizes_test.cpp
  LINK repose_scene)
repose_test(scene_mesh_tests LABEL unit SOURCES scene_mesh_test.cpp scene_stl_test.cpp LINK repose_scene)
target_include_directories(scene_mesh_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests)
