repose_test(unit_photo LABEL analytic
  SOURCES photo_pile_test.cpp photo_plate_test.cpp photo_observable_test.cpp
  LINK repose_photo
  APART photo_plate_test.cpp)
