#include <gtest/gtest.h>

#include "base/error.h"
#include "commands/command_line.h"

namespace repose {
namespace {

using Action = CommandLine::Action;

CommandLine parse(std::vector<std::string> words) {
  words.insert(words.begin(), "repose");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return parse_command_line(static_cast<int>(words.size()), argv.data());
}

TEST(ParseCommandLine, Run) {
  const CommandLine line = parse({"run", "--set", "time.step=-1", "deck.toml", "--output", "out", "--set",
                                  "gravity=[0,0,-1]", "--set=run.title=two words, or more", "--vector-level", "avx2"});
  EXPECT_EQ(line.action, Action::run);
  EXPECT_EQ(line.deck, "deck.toml");
  EXPECT_EQ(line.output, "out");
  EXPECT_EQ(line.overrides,
            (std::vector<std::string>{"time.step=-1", "gravity=[0,0,-1]", "run.title=two words, or more"}));
  EXPECT_EQ(line.vector_level, "avx2");
  EXPECT_FALSE(line.quiet);
}

TEST(ParseCommandLine, InfoAndExport) {
  const CommandLine info = parse({"info", "run_1.hdf"});
  EXPECT_EQ(info.action, Action::info);
  EXPECT_EQ(info.file, "run_1.hdf");
  const CommandLine exported = parse({"export", "run_1.hdf", "--format", "csv", "--output", "grains.csv"});
  EXPECT_EQ(exported.action, Action::export_file);
  EXPECT_EQ(exported.file, "run_1.hdf");
  EXPECT_EQ(exported.format, "csv");
  EXPECT_EQ(exported.output, "grains.csv");
  EXPECT_THROW(parse({"export", "run_1.hdf", "--format", "obj", "--output", "grains.obj"}), DeckError);
  EXPECT_THROW(parse({"export", "run_1.hdf", "--output", "grains.csv"}), DeckError);
  EXPECT_THROW(parse({"info"}), DeckError);
}

TEST(ParseCommandLine, OtherActions) {
  const CommandLine check = parse({"check", "deck.toml", "--set", "a=1"});
  EXPECT_EQ(check.action, Action::check);
  EXPECT_EQ(check.deck, "deck.toml");
  EXPECT_EQ(check.overrides, std::vector<std::string>{"a=1"});
  EXPECT_EQ(parse({"keys"}).action, Action::keys);
  EXPECT_EQ(parse({"--version"}).action, Action::version);
  const CommandLine run = parse({"run", "deck.toml", "--output", "out", "--quiet"});
  EXPECT_TRUE(run.quiet);
  EXPECT_EQ(run.vector_level, "auto");
}

TEST(ParseCommandLine, TimeLimitsAreThoseOfBatchSystems) {
  const auto seconds = [](const std::string& limit) {
    return parse({"run", "a.toml", "--output", "o", "--restart", "--time-limit", limit}).time_limit;
  };
  EXPECT_EQ(seconds("00:00:06"), 6.0);
  EXPECT_EQ(seconds("47:59:30"), 172770.0);
  EXPECT_EQ(seconds("2-01:00:00"), 176400.0);
  EXPECT_TRUE(parse({"run", "a.toml", "--output", "o", "--restart"}).restart);
  EXPECT_FALSE(parse({"run", "a.toml", "--output", "o"}).time_limit);
}

TEST(ParseCommandLine, Thermal) {
  const CommandLine bed = parse({"thermal", "bed", "deck.toml", "--set", "a=1", "--output", "out"});
  EXPECT_EQ(bed.action, Action::thermal);
  EXPECT_EQ(bed.tool, "bed");
  EXPECT_EQ(bed.deck, "deck.toml");
  EXPECT_EQ(bed.output, "out");
  EXPECT_EQ(bed.overrides, std::vector<std::string>{"a=1"});
  const CommandLine tps = parse({"thermal", "tps", "1.csv", "2.csv", "--deck", "deck.toml"});
  EXPECT_EQ(tps.tool, "tps");
  EXPECT_EQ(tps.files, (std::vector<std::string>{"1.csv", "2.csv"}));
  EXPECT_EQ(tps.deck, "deck.toml");
  const CommandLine compare = parse({"compare", "--deck", "deck.toml", "a.csv", "b.csv"});
  EXPECT_EQ(compare.action, Action::thermal);
  EXPECT_EQ(compare.tool, "compare");
  EXPECT_EQ(compare.files, (std::vector<std::string>{"a.csv", "b.csv"}));
}

TEST(ParseCommandLine, Measure) {
  const CommandLine line = parse({"measure", "run_1.hdf", "--deck", "deck.toml", "--set", "a=1", "--output", "out"});
  EXPECT_EQ(line.action, Action::measure);
  EXPECT_EQ(line.file, "run_1.hdf");
  EXPECT_EQ(line.deck, "deck.toml");
  EXPECT_EQ(line.output, "out");
  EXPECT_EQ(line.overrides, std::vector<std::string>{"a=1"});
  EXPECT_EQ(parse({"measure", "a.csv", "--deck", "deck.toml"}).output, "");
}

TEST(ParseCommandLine, Studies) {
  const CommandLine line =
      parse({"calibrate", "c.toml", "--output", "out", "--set", "a=1", "--time-limit", "01:00:00"});
  EXPECT_EQ(line.action, Action::calibrate);
  EXPECT_EQ(line.deck, "c.toml");
  EXPECT_EQ(line.overrides, std::vector<std::string>{"a=1"});
  EXPECT_EQ(line.time_limit, 3600.0);
  EXPECT_EQ(parse({"sensitivity", "s.toml", "--output", "out"}).action, Action::sensitivity);
  const CommandLine again = parse({"estimate", "results", "--deck", "c.toml"});
  EXPECT_EQ(again.action, Action::estimate);
  EXPECT_EQ(again.file, "results");
  EXPECT_EQ(again.deck, "c.toml");
  EXPECT_EQ(parse({"estimate", "results"}).deck, "");
}

TEST(ParseCommandLine, HelpIsText) {
  const CommandLine help = parse({"--help"});
  EXPECT_EQ(help.action, Action::none);
  for (const char* word : {"run", "check", "measure", "calibrate", "estimate", "sensitivity", "keys", "--version"})
    EXPECT_NE(help.text.find(word), std::string::npos) << word;
  const CommandLine run = parse({"run", "--help"});
  EXPECT_EQ(run.action, Action::none);
  EXPECT_NE(run.text.find("--vector-level"), std::string::npos) << run.text;
}

TEST(ParseCommandLine, MistakesAreOneLine) {
  struct Bad {
    std::vector<std::string> words;
    const char* message;
  };
  const Bad cases[] = {
      {{}, "nothing to do: name a command; see repose --help"},
      {{"ran", "deck.toml"}, "The following arguments were not expected: deck.toml ran; see repose --help"},
      {{"run", "--output", "out"}, "DECK is required; see repose --help"},
      {{"run", "deck.toml"}, "--output is required; see repose --help"},
      {{"check", "a.toml", "b.toml"}, "The following argument was not expected: b.toml; see repose --help"},
      {{"check", "a.toml", "--set"}, "--set: 1 required KEY=VALUE missing; see repose --help"},
      {{"measure", "a.csv"}, "--deck is required; see repose --help"},
      {{"thermal"}, "A subcommand is required; see repose --help"},
      {{"thermal", "network", "--deck", "a.toml"}, "FILE is required; see repose --help"},
      {{"thermal", "tps", "a.csv"}, "--deck is required; see repose --help"},
      {{"compare", "a.csv", "--deck", "a.toml"}, "FILES: At least 2 required but received 1; see repose --help"},
      {{"measure", "--deck", "a.toml"}, "FILE is required; see repose --help"},
      {{"run", "a.toml", "--output", "o", "--vector-level", "mmx"},
       "--vector-level: mmx not in {auto,sse2,avx2,avx512}; see repose --help"},
      {{"run", "a.toml", "--output", "o", "--time-limit", "90"},
       "--time-limit 90: HH:MM:SS or D-HH:MM:SS was expected"},
      {{"run", "a.toml", "--output", "o", "--time-limit", "01:60:00"},
       "--time-limit 01:60:00: HH:MM:SS or D-HH:MM:SS was expected"},
      {{"run", "a.toml", "--output", "o", "--time-limit", "00:01:00 "},
       "--time-limit 00:01:00 : HH:MM:SS or D-HH:MM:SS was expected"},
  };
  for (const Bad& c : cases) {
    try {
      parse(c.words);
      ADD_FAILURE() << c.message;
    } catch (const DeckError& error) {
      EXPECT_STREQ(error.what(), c.message);
    }
  }
}

}  // namespace
}  // namespace repose
