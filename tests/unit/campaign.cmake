repose_test(unit_campaign LABEL unit SOURCES campaign_curve_test.cpp campaign_display_test.cpp campaign_estimate_test.cpp campaign_experiments_test.cpp campaign_report_test.cpp
          campaign_runs_test.cpp
          campaign_table_test.cpp
  LINK repose_campaign
  APART campaign_estimate_test.cpp campaign_runs_test.cpp)
