repose_test(unit_import_script LABEL unit SOURCES import_script_test.cpp LINK repose_import)
repose_test(unit_import_deck LABEL unit SOURCES import_deck_test.cpp LINK repose_import)
repose_test(unit_import_grains LABEL unit SOURCES import_grains_test.cpp LINK repose_import)
