repose_test(unit_fields LABEL unit SOURCES fields_kernel_test.cpp fields_coarse_grain_test.cpp LINK repose_fields)
