# The thermal tools on the decks of input/; what holds a closed form or a coverage is analytic.
repose_test(thermal_bed SANITIZED LABEL analytic SOURCES thermal_bed_test.cpp thermal_air_test.cpp LINK repose_thermal)
repose_test(thermal_source SANITIZED LABEL analytic SOURCES thermal_source_test.cpp LINK repose_thermal)
repose_test(thermal_layered SANITIZED LABEL analytic SOURCES thermal_layered_test.cpp LINK repose_thermal)
repose_test(thermal_tps SANITIZED LABEL analytic SOURCES thermal_tps_test.cpp LINK repose_thermal)
repose_test(thermal_tools LABEL unit
  SOURCES thermal_compare_test.cpp thermal_criteria_test.cpp thermal_mixture_test.cpp thermal_sensor_test.cpp
          thermal_transient_test.cpp
  LINK repose_thermal)
repose_test(thermal_network SANITIZED LABEL analytic SOURCES thermal_network_test.cpp LINK repose_thermal)
