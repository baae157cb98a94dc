repose_test(unit_campaign LABEL unit SOURCES campaign_runs_test.cpp campaign_table_test.cpp LINK repose_campaign)
