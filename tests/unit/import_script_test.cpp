// The language of scripts: lines, words, variables, formulas, loops, conditions, includes.
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "deck_error.h"
#include "import/formula.h"
#include "import/script.h"
#include "import_samples.h"

namespace repose {
namespace {

using Files = std::map<std::string, std::string>;

/// The commands of the script "in", each as "line: words".
std::vector<std::string> commands_of(const Files& files, const std::vector<std::string>& variables = {}) {
  std::vector<std::string> commands;
  read_script("in", test::reader_of(files), variables, [&](const ScriptCommand& command) {
    commands.push_back(std::to_string(command.place.line) + ": " + text(command));
  });
  return commands;
}

std::vector<std::string> commands_of(const std::string& script) { return commands_of(Files{{"in", script}}); }

std::string error_of(const std::string& script) {
  return test::deck_error([&] { commands_of(script); });
}

double value(const std::string& formula) {
  return evaluate(formula, [](const std::string& name) -> std::optional<double> {
    if (!name.starts_with("v_")) return {};
    return name == "v_two" ? 2.0 : throw DeckError("no");
  });
}

using Lines = std::vector<std::string>;

TEST(Script, JoinsLinesAndDropsComments) {
  EXPECT_EQ(commands_of("a 1 &\n  2& # more\n 3\n# nothing\n\nb \"x # y\" 'z z'  # end"),
            (Lines{"1: a 1 2 3", "6: b x # y z z"}));
}

TEST(Script, ReplacesVariablesOutsideOfQuotes) {
  EXPECT_EQ(
      commands_of("variable r equal 3*2\nvariable n string name\nc ${r} $n $(v_r/4) '${r}'\nprint \"${unknown}\""),
      (Lines{"3: c 6 name 1.5 ${r}", "4: print ${unknown}"}));
}

TEST(Script, EvaluatesAFormulaWhenItIsAskedFor) {
  EXPECT_EQ(commands_of("variable a equal 1\nvariable b equal ${a}+v_a\nvariable a equal 5\nc ${b}"),
            (Lines{"4: c 6"}));
}

TEST(Script, LoopsOverNumbersAndWords) {
  const std::string loop = "label again\nvariable i loop 3\nc $i\nnext i\njump SELF again\nlast";
  EXPECT_EQ(commands_of(loop), (Lines{"3: c 1", "3: c 2", "3: c 3", "6: last"}));
  EXPECT_EQ(commands_of("variable w index x y\nlabel l\nc $w\nnext w\njump SELF l"), (Lines{"3: c x", "3: c y"}));
  EXPECT_EQ(commands_of("variable i loop 9 10 pad\nc $i"), (Lines{"2: c 09"}));
}

TEST(Script, FollowsConditions) {
  const std::string script =
      "variable a equal 2\nif \"${a} > 1\" then \"c 1\" \"c 2\" else \"c 3\"\n"
      "if \"$a == 1\" then \"d 1\" elif \"$a == 2 && 1\" \"d 2\" else \"d 3\"\n"
      "variable s string yes\nif \"$s == no\" then \"e 1\" else \"e 2\"";
  EXPECT_EQ(commands_of(script), (Lines{"2: c 1", "2: c 2", "3: d 2", "5: e 2"}));
  EXPECT_EQ(
      commands_of(
          "variable i loop 5\nlabel l\nc $i\nif \"$i == 2\" then \"jump SELF out\"\nnext i\njump SELF l\nlabel out\nd"),
      (Lines{"3: c 1", "3: c 2", "8: d"}));
  EXPECT_EQ(commands_of("a\nquit\nb"), (Lines{"1: a"}));
}

TEST(Script, IncludesAndTakesVariablesOfTheCommandLine) {
  const Files files = {{"in", "variable r index 1\ninclude more\nc $r"}, {"more", "d $r"}};
  EXPECT_EQ(commands_of(files), (Lines{"1: d 1", "3: c 1"}));
  EXPECT_EQ(commands_of(files, {"r=7"}), (Lines{"1: d 7", "3: c 7"}));
  for (const std::string command : {"include more", "jump more"}) {
    try {
      read_script(
          "in",
          [&](const std::string& file) -> std::string {
            return file == "in" ? "variable a index 1\n" + command : throw FileError(file + ": cannot open");
          },
          {}, [](const ScriptCommand&) {});
      ADD_FAILURE() << "a file that is not there was read";
    } catch (const FileError& error) {
      EXPECT_STREQ(error.what(), "in:2: more: cannot open");
    }
  }
}

TEST(Script, WritesFormulasAsLiggghtsDoes) {
  const std::string script = "variable t equal 0.3\nvariable dt equal 1e-5\nvariable n equal ${t}/${dt}\n";
  EXPECT_EQ(commands_of(script + "run ${n} v_n\nvariable m equal v_n/7\nc ${m}"),
            (Lines{"4: run 30000 v_n", "6: c 4285.71428571429"}));
}

TEST(Script, KnowsTheTimeStepOnceItIsGiven) {
  EXPECT_EQ(commands_of("timestep 1e-3\nc $(0.5/dt)"), (Lines{"1: timestep 1e-3", "2: c 500"}));
  EXPECT_EQ(error_of("c $(0.5/dt)"),
            "in:1: formula \"0.5/dt\": \"dt\" is no constant, or known only while the simulation runs");
}

TEST(Script, RefusesVariablesOfTheCommandLineThatChangeNothing) {
  const auto error = [](const std::string& script, const std::string& given) {
    return test::deck_error([&] { commands_of(Files{{"in", script}}, {given}); });
  };
  EXPECT_EQ(error("a\nvariable r equal 1\nc $r", "r=7"),
            "--var r=7: in:2 defines \"r\" as equal; only index variables can be given");
  EXPECT_EQ(error("variable rr index 1\nc ${rr} $(v_rr)", "r=7"), "--var r=7: in has no variable \"r\"");
  for (const std::string use : {"print \"${r}\"", "c $r", "c $(2*v_r)", "variable  r index 1"})
    EXPECT_NO_THROW(commands_of(Files{{"in", use}}, {"r=7"})) << use;
}

TEST(Script, SaysWhereItCannotGoOn) {
  EXPECT_EQ(error_of("a\nb ${radius}"), "in:2: no variable \"radius\" is defined above");
  EXPECT_EQ(error_of("variable rad equal 1\nb ${rat}"),
            "in:2: no variable \"rat\" is defined above; the nearest is \"rad\"");
  EXPECT_EQ(error_of("a \"b"), "in:1: a quote that is not closed");
  EXPECT_EQ(error_of("a ${b"), "in:1: a ${ that is not closed");
  EXPECT_EQ(error_of("label l\njump SELF l"), "in:1: more than 1000000 commands: a loop without end?");
  EXPECT_EQ(error_of("variable a string x\nlabel l\nvariable a string $a$a\njump SELF l"),
            "in:3: more than 1000000 characters: a variable that is joined to itself?");
  EXPECT_EQ(error_of("jump SELF nowhere"), "in:1: no label \"nowhere\" in in");
  EXPECT_EQ(error_of("include in"), "in: includes itself");
  EXPECT_EQ(error_of("variable a equal v_a\nb $a"), "in:2: formula \"v_a\" names itself");
  EXPECT_EQ(error_of("variable a equal step*2\nb $a"),
            "in:2: formula \"step*2\": \"step\" is no constant, or known only while the simulation runs");
  EXPECT_EQ(error_of("variable a python f"),
            "in:1: variables of style \"python\" are not known; index, loop, string and equal are");
}

TEST(Formula, FollowsTheOrderOfOperations) {
  EXPECT_DOUBLE_EQ(value("1+2*3^2"), 19.0);
  EXPECT_DOUBLE_EQ(value("-2^2"), 4.0);  // doc/variable.txt of LIGGGHTS: a sign binds tighter than ^
  EXPECT_DOUBLE_EQ(value("-(2^2)"), -4.0);
  EXPECT_DOUBLE_EQ(value("2^3^2"), 64.0);
  EXPECT_DOUBLE_EQ(value("2^-1"), 0.5);
  EXPECT_DOUBLE_EQ(value("2*-3^2"), 18.0);
  EXPECT_DOUBLE_EQ(value("0 == 1 > 2"), 1.0);
  EXPECT_DOUBLE_EQ(value("(1 + v_two) % 2"), 1.0);
  EXPECT_DOUBLE_EQ(value("7/2/2"), 1.75);
  EXPECT_DOUBLE_EQ(value("1.5e-3*1E3"), 1.5);
  EXPECT_DOUBLE_EQ(value("2 < 3 && !(1 >= 2) || 0"), 1.0);
  EXPECT_DOUBLE_EQ(value("sqrt(16)+atan2(0,1)+round(PI)+log(100)"), 9.0);
}

TEST(Formula, RefusesWhatIsNone) {
  for (const std::string bad :
       {"", "1+", "(1", "1)", "1/0", "sqrt(-1)", "sin 1", "atan2(1)", "c_temp", "1 2", "1e400", "random(0,1,5)"}) {
    EXPECT_THROW(value(bad), DeckError) << bad;
  }
  EXPECT_THROW(value(std::string(100000, '(')), DeckError);
  EXPECT_THROW(value(std::string(100000, '-')), DeckError);
}

}  // namespace
}  // namespace repose
