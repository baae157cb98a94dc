repose_test(thermal_bed LABEL unit SOURCES thermal_bed_test.cpp thermal_air_test.cpp LINK repose_thermal)
repose_test(thermal_source LABEL analytic SOURCES thermal_source_test.cpp LINK repose_thermal)
repose_test(thermal_tps LABEL analytic SOURCES thermal_tps_test.cpp LINK repose_thermal)
repose_test(thermal_criteria LABEL unit SOURCES thermal_criteria_test.cpp LINK repose_thermal)
