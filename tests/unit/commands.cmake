repose_test(unit_commands LABEL unit SOURCES commands_test.cpp LINK repose_commands)
