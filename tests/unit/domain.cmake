repose_test(unit_domain LABEL unit SOURCES domain_exits_test.cpp domain_layer_order_test.cpp LINK repose_test_scenes)
