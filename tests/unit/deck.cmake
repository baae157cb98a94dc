repose_test(deck_units LABEL unit SOURCES deck_units_test.cpp LINK repose_deck)
repose_test(deck_read LABEL unit SOURCES deck_read_test.cpp LINK repose_deck)
repose_test(deck_contact LABEL unit SOURCES deck_contact_test.cpp LINK repose_deck)
repose_test(deck_errors LABEL unit SOURCES deck_errors_test.cpp LINK repose_deck)
repose_test(deck_round_trip LABEL unit SOURCES deck_round_trip_test.cpp LINK repose_deck)
target_include_directories(deck_round_trip PRIVATE ${PROJECT_SOURCE_DIR}/tests)
repose_test(deck_command_line LABEL unit SOURCES deck_command_line_test.cpp 
LINK repose_commands)
