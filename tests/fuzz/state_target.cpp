// The JSON text of a checkpoint, as the state of what knows how to read one.
#include <nlohmann/json.hpp>

#include "domain/exits.h"
#include "measurement/discharge.h"
#include "measurement/tilt_onset.h"
#include "output/state_json.h"
#include "output/summary.h"
#include "scene/walls/motion.h"
#include "target.h"

namespace repose::fuzz {
namespace {

struct Everything {
  ExitCount left;
  DischargeRecord discharge;
  TiltOnset tilt_onset = TiltOnset(TiltOnsetDeck{});
  std::vector<PhaseSummary> phases;
  std::vector<Motions> motions = {Motions(std::vector<MotionDeck>(2))};

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("left", self.left);
    v("discharge", self.discharge);
    v("tilt_onset", self.tilt_onset);
    v("phases", self.phases);
    v.each("motions", self.motions);
  }
};

}  // namespace

bool accepts(std::string_view input) {
  const nlohmann::json json = nlohmann::json::parse(input, nullptr, false);
  if (json.is_discarded()) return false;
  Everything state;
  if (!is_done([&] { StateReader(json, "state")("all", state); })) return false;
  const nlohmann::json once = StateWriter::encode(state);
  Everything again;
  const nlohmann::json wrapped = {{"all", once}};
  StateReader(wrapped, "state")("all", again);
  expect(StateWriter::encode(again) == once, "what was read is written and read back to the same");
  return true;
}

}  // namespace repose::fuzz
