repose_test(unit_measurement LABEL unit
  SOURCES measurement_piles.cpp measurement_pile_test.cpp measurement_angle_test.cpp measurement_draw_test.cpp
          measurement_scattering_test.cpp measurement_discharge_test.cpp measurement_drum_test.cpp
          measurement_bed_test.cpp measurement_shear_test.cpp
  LINK repose_pictures
  APART measurement_angle_test.cpp)
