repose_test(unit_calibration LABEL unit
  SOURCES base_distributions_test.cpp calibration_process_test.cpp calibration_likelihood_test.cpp
          calibration_surface_test.cpp calibration_contour_test.cpp calibration_region_test.cpp
          calibration_sensitivity_test.cpp calibration_level_process_test.cpp calibration_curve_test.cpp
  LINK repose_calibration)
# Many estimates each: not part of unit_calibration, which is also run under the sanitizers.
repose_test(calibration_estimate LABEL analytic
  SOURCES calibration_estimate_test.cpp calibration_thin_region_test.cpp
  LINK repose_calibration)
repose_test(calibration_coverage LABEL analytic
  SOURCES calibration_coverage_test.cpp calibration_adaptive_test.cpp
  LINK repose_calibration)
repose_test(calibration_curves LABEL analytic SOURCES calibration_curve_coverage_test.cpp LINK repose_calibration)
repose_test(calibration_levels LABEL analytic SOURCES calibration_level_coverage_test.cpp LINK repose_calibration)
repose_test(calibration_levels_often LABEL slow TIMEOUT 7200 SOURCES calibration_level_coverage_slow_test.cpp
            LINK repose_calibration)
repose_test(calibration_posterior LABEL analytic
  SOURCES calibration_sampling_test.cpp calibration_prior_test.cpp calibration_six_test.cpp
  LINK repose_calibration)
repose_test(calibration_six_often LABEL slow TIMEOUT 7200 SOURCES calibration_six_coverage_slow_test.cpp
            LINK repose_calibration)
