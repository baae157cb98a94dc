#pragma once

#include <span>
#include <string>
#include <vector>

#include "deck/deck.h"

namespace repose {

class DeckErrors;

/// What is known of a parameter before any run.
enum class ParameterPrior { uniform, normal, lognormal };

/// A number of the base deck that runs differ in.
struct ParameterDeck {
  std::string name;            ///< of tables and folders
  std::string key;             ///< of the base deck, as with --set
  double min = unset;          ///< in the key's SI unit; default: the least of `values`
  double max = unset;          ///< default: the greatest of `values`
  std::int64_t points = 0;     ///< values from min to max, evenly; 0: not given
  std::vector<double> values;  ///< or these
  double fixed = unset;        ///< sensitivity: while another parameter changes
  ParameterPrior prior = ParameterPrior::uniform;
  double prior_mean = unset;       ///< of the parameter itself, before the range cuts it off
  double prior_deviation = unset;  ///< its standard deviation
};

/// Many runs of one deck.
struct StudyDeck {
  std::string title;
  std::string base;              ///< path of the deck, relative to this file
  std::vector<std::string> set;  ///< "key=value" for all runs
  std::int64_t seeds = 1;        ///< runs at each point, with successive values of run.seed
  std::int64_t first_seed = 1;
  std::int64_t ranks_per_run = 1;
  std::vector<ParameterDeck> parameters;
};

/// Notes what is wrong with the parameters and fills in `min` and `max`.
void check_study(StudyDeck& study, DeckErrors& errors);

/// Notes parameters with the name of one of these figures, beside which they are columns of one table.
void check_column_names(const StudyDeck& study, std::span<const std::string> figures, DeckErrors& errors);

/// Notes what is wrong with the priors, which calibrations alone have.
void check_priors(const StudyDeck& study, DeckErrors& errors);

/// The values of one parameter.
std::vector<double> values_of(const ParameterDeck& parameter);

}  // namespace repose
