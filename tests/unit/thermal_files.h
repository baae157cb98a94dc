#pragma once

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "thermal/tool.h"

namespace repose::thermal {

inline std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A deck of input/ as the tools get it.
inline ToolInput example(const std::string& name, std::vector<std::string> overrides = {},
                         std::vector<DataFile> files = {}) {
  return {
      {name, text_of_file(std::string(REPOSE_SOURCE_DIR) + "/input/" + name)}, std::move(overrides), std::move(files)};
}

/// That `work` throws a DeckError of one line that contains `part`.
template <class Work>
void expect_deck_error(Work&& work, const std::string& part) {
  try {
    work();
    ADD_FAILURE() << "no error: " << part;
  } catch (const DeckError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(part), std::string::npos) << what << "\nwhere this was expected: " << part;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

}  // namespace repose::thermal
