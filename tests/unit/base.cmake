repose_test(base_tests LABEL unit
  SOURCES base_math_test.cpp base_philox_test.cpp base_quad_test.cpp
  LINK repose_base)
