#include <functional>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "base/error.h"
#include "comm/communicator.h"
#include "commands/command_line.h"
#include "commands/study_request.h"

namespace repose {
namespace {

using Words = std::vector<std::string>;

/// argc and argv of a program that was called with these words.
struct Arguments {
  explicit Arguments(Words given) : words(std::move(given)) {
    words.insert(words.begin(), "repose");
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
  }
  int argc() const { return static_cast<int>(words.size()); }

  Words words;
  std::vector<char*> argv;
};

CommandLine parse(const Words& words) {
  Arguments arguments(words);
  return parse_command_line(arguments.argc(), arguments.argv.data());
}

/// What a command with these options reads from the words.
void read(const std::function<void(Options&)>& declare, const Words& words) {
  CLI::App app;
  Options options(app);
  declare(options);
  Arguments arguments(words);
  app.parse(arguments.argc(), arguments.argv.data());
}

StudyRequest study(const Words& words) {
  StudyRequest request;
  read([&](Options& options) { request.declare(options, "DECK", "a deck"); }, words);
  return request;
}

TEST(StudyRequest, TakesOverridesAndADeckInAnyOrder) {
  const StudyRequest request =
      study({"--set", "time.step=-1", "deck.toml", "--output", "out", "--set", "gravity=[0,0,-1]",
             "--set=run.title=two words, or more", "--vector-level", "avx2"});
  EXPECT_EQ(request.file, "deck.toml");
  EXPECT_EQ(request.output, "out");
  EXPECT_EQ(request.overrides, (Words{"time.step=-1", "gravity=[0,0,-1]", "run.title=two words, or more"}));
  EXPECT_EQ(request.vector_level, "avx2");
  EXPECT_FALSE(request.quiet);
  EXPECT_FALSE(request.time_limit);
  const RunRequest run = study({"deck.toml", "--output", "out", "--quiet"}).run_request(Communicator(MPI_COMM_SELF));
  EXPECT_EQ(run.level, best_vector_level());
  EXPECT_EQ(run.log.progress, nullptr);
  EXPECT_FALSE(run.restart);
}

TEST(StudyRequest, TimeLimitsAreThoseOfBatchSystems) {
  EXPECT_EQ(seconds_of_time_limit("00:00:06"), 6.0);
  EXPECT_EQ(seconds_of_time_limit("47:59:30"), 172770.0);
  EXPECT_EQ(seconds_of_time_limit("2-01:00:00"), 176400.0);
  EXPECT_EQ(study({"a.toml", "--output", "o", "--time-limit", "01:00:00"}).time_limit, 3600.0);
}

TEST(Options, ArgumentsAndChoices) {
  std::string one;
  Words two;
  std::string format;
  const auto declare = [&](Options& options) {
    options.argument("FILE", one, "a file");
    options.arguments("FILES", two, "two files", 2, "A B");
    options.choice("--format", format, {"vtp", "csv"}, "a format", Options::Need::must);
  };
  read(declare, {"a", "b", "c", "--format", "csv"});
  EXPECT_EQ(one, "a");
  EXPECT_EQ(two, (Words{"b", "c"}));
  EXPECT_EQ(format, "csv");
  EXPECT_THROW(read(declare, {"a", "b", "c"}), CLI::RequiredError);
  EXPECT_THROW(read(declare, {"a", "b", "--format", "csv"}), CLI::ParseError);
  EXPECT_THROW(read(declare, {"a", "b", "c", "--format", "obj"}), CLI::ValidationError);
}

TEST(ParseCommandLine, MpiStartsForWhatSimulates) {
  for (const char* name : {"run", "calibrate", "sensitivity", "validate"}) {
    EXPECT_EQ(parse({name, "a.toml", "--output", "o"}).need, Process::Need::ranks) << name;
  }
  EXPECT_EQ(parse({"check", "a.toml"}).need, Process::Need::alone);
  EXPECT_EQ(parse({"thermal", "bed", "a.toml"}).need, Process::Need::alone);
  EXPECT_EQ(parse({"--version"}).need, Process::Need::alone);
}

TEST(ParseCommandLine, MistakesAreOneLine) {
  struct Bad {
    std::vector<std::string> words;
    const char* message;
  };
  const Bad cases[] = {
      {{}, "nothing to do: name a command; see repose --help"},
      {{"ran", "deck.toml"}, "there is no command \"ran\"; did you mean run? repose --help lists them"},
      {{"run", "--output", "out"}, "DECK is required; see repose run --help"},
      {{"run", "deck.toml"}, "--output is required; see repose run --help"},
      {{"run", "deck.toml", "--out", "out"},
       "there is no option \"--out\"; did you mean --output? repose run --help lists them"},
      {{"run", "deck.toml", "--output", "out", "--quite"},
       "there is no option \"--quite\"; did you mean --quiet? repose run --help lists them"},
      {{"check", "a.toml", "b.toml"}, "The following argument was not expected: b.toml; see repose check --help"},
      {{"check", "a.toml", "--set"}, "--set: 1 required KEY=VALUE missing; see repose check --help"},
      {{"measure", "a.csv"}, "--deck is required; see repose measure --help"},
      {{"thermal"}, "nothing to do: name a command; see repose thermal --help"},
      {{"thermal", "beds", "a.toml"},
       "there is no command \"beds\"; did you mean bed? repose thermal --help lists them"},
      {{"--verbose"}, "The following argument was not expected: --verbose; see repose --help"},
      {{"thermal", "network", "--deck", "a.toml"}, "FILE is required; see repose thermal network --help"},
      {{"thermal", "tps", "a.csv"}, "--deck is required; see repose thermal tps --help"},
      {{"compare", "a.csv", "--deck", "a.toml"},
       "FILES: At least 2 required but received 1; see repose compare --help"},
      {{"measure", "--deck", "a.toml"}, "FILE is required; see repose measure --help"},
      {{"run", "a.toml", "--output", "o", "--vector-level", "mmx"},
       "--vector-level: mmx not in {auto,sse2,avx2,avx512x4,avx512}; see repose run --help"},
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
