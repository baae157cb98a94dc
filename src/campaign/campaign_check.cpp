#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "campaign/campaign.h"
#include "deck/overrides.h"
#include "deck/parse_toml.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "files/shared_file.h"
#include "run/restart.h"
#include "run/summary_figures.h"

namespace repose {
namespace {

/// Those of the study, without the command line's.
std::vector<std::string> own_overrides(const CampaignPlan& plan, const StudyRun& run) {
  std::vector<std::string> own = run.overrides;
  std::erase_if(own, [&](const std::string& override) {
    return std::find(plan.command_line.begin(), plan.command_line.end(), override) != plan.command_line.end();
  });
  return own;
}

/// DeckError when two parameters are one key of the base deck, or when another override sets the key of a parameter or
/// the seed, which would be in vain.
void refuse_set_twice(const CampaignPlan& plan, const std::string& text, const StudyRun& run) {
  const std::vector<ParameterDeck>& parameters = plan.study.parameters;
  if (parameters.empty()) return;
  const std::string& base = plan.bases[plan.base_of(run)];
  const std::vector<std::string> paths = override_paths(parse_toml(text, base), run.overrides);
  const std::size_t first = paths.size() - parameters.size() - 1;  // behind them the seed
  for (std::size_t i = first; i < paths.size(); ++i) {
    const auto before = static_cast<std::size_t>(std::find(paths.begin(), paths.end(), paths[i]) - paths.begin());
    if (before == i) continue;
    const bool is_seed = i - first == parameters.size();
    const std::string setter = is_seed ? "\"seeds\" and \"first_seed\" set this key"
                                       : fmt::format("parameter \"{}\" sets this key", parameters[i - first].name);
    throw DeckError(fmt::format("--set {}: {}, too; remove one of them", run.overrides[before], setter));
  }
}

/// The deck of a run; what is refused of the study's own keys is told with the line of the study.
Deck checked_deck(const CampaignPlan& plan, const std::string& text, const StudyRun& run, bool is_first) {
  try {
    if (is_first) refuse_set_twice(plan, text, run);
    return read_deck(text, plan.bases[plan.base_of(run)], run.overrides);
  } catch (const DeckError& error) {
    throw DeckError(told_of_file(error.what(), own_overrides(plan, run), plan.deck, plan.deck_text));
  }
}

/// DeckError when runs of this deck do not have what the study asks of them.
void require_figures(const CampaignPlan& plan, const Deck& deck, const StudyRun& run) {
  std::string place = plan.deck;
  try {
    for (const RunFigure& figure : plan.figures) {
      if (figure.experiment != run.experiment) continue;
      place = place_of(fmt::format("\"{}\"", figure.key), plan.deck, plan.deck_text).value_or(plan.deck);
      require_figure(deck, figure.key);
    }
    place = plan.deck;
    if (plan.check_deck) plan.check_deck(deck, run.experiment);
  } catch (const DeckError& error) {
    throw DeckError(fmt::format("{}: {}", place, error.what()));
  }
}

/// DeckError when a run's folder has a name that no file system takes; points of a search may have more digits yet.
void refuse_long_name(const CampaignPlan& plan, const StudyRun& run) {
  constexpr std::size_t longest = 220;                                     // 255 are taken
  const std::size_t length = run.name.size() - (run.name.rfind('/') + 1);  // npos + 1 is 0
  if (length <= longest) return;
  throw DeckError(
      fmt::format("{}: folders of runs would have names of {} characters, {} at most; shorten the names of "
                  "the parameters",
                  plan.deck, length, longest));
}

}  // namespace

void check_campaign(const CampaignPlan& plan, std::span<const StudyRun> runs) {
  std::vector<std::string> texts;
  for (const std::string& base : plan.bases) texts.push_back(read_whole_file(base));
  std::vector<char> is_known(plan.bases.size(), 0);
  for (const StudyRun& run : runs) {
    const std::size_t base = plan.base_of(run);
    refuse_long_name(plan, run);
    const bool is_first = is_known[base] == 0;
    const Deck deck = checked_deck(plan, texts[base], run, is_first);
    if (is_first) require_figures(plan, deck, run);
    is_known[base] = 1;
    if (plan.directory.empty()) continue;
    const std::string folder = folder_of(plan.directory, run);
    const std::string before = folder + "/deck.resolved.toml";
    if (!std::filesystem::exists(before)) continue;
    refuse_other_deck(folder, read_whole_file(before), resolved_deck(deck), std::numeric_limits<std::size_t>::max());
  }
}

}  // namespace repose
