#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "deck/deck.h"

namespace repose {

/// The value of a key of summary.json, with dots between the names ("scattering.area_1.count"), or nothing where the
/// run has none (no pile, no angle). DeckError when there is no such key or it is not one number.
std::optional<double> figure_in(const nlohmann::ordered_json& summary, const std::string& figure);

/// The standard error that the summary gives for it: angle_of_repose_stderr_deg, or "error" beside "count".
std::optional<double> error_in(const nlohmann::ordered_json& summary, const std::string& figure);

/// DeckError when runs of this deck will have no such figure, with the section that measures it or the figure that may
/// have been meant.
void require_figure(const Deck& deck, const std::string& figure);

}  // namespace repose
